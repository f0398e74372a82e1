#include "body.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yield_study {
namespace {

using StrainMatrix = Eigen::Matrix<double, 4, 8>;

struct Sample {
  StrainMatrix strain;
  Eigen::Vector4d shapes;
  Eigen::Vector2d place;
  double volume;
};

/// Strains by displacements at a point of the unit square [−1, 1]².
Sample sample(const std::array<Eigen::Vector2d, 4>& corners, double x, double y) {
  constexpr std::array<double, 4> sign_x{-1.0, 1.0, 1.0, -1.0}, sign_y{-1.0, -1.0, 1.0, 1.0};
  Eigen::Matrix<double, 2, 4> slopes;
  Eigen::Vector4d shapes;
  for (int k = 0; k < 4; ++k) {
    const auto i = static_cast<std::size_t>(k);
    shapes[k] = 0.25 * (1.0 + sign_x[i] * x) * (1.0 + sign_y[i] * y);
    slopes.col(k) << 0.25 * sign_x[i] * (1.0 + sign_y[i] * y), 0.25 * sign_y[i] * (1.0 + sign_x[i] * x);
  }
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  for (int k = 0; k < 4; ++k) {
    const auto& corner = corners[static_cast<std::size_t>(k)];
    jacobian += slopes.col(k) * corner.transpose();
    place += shapes[k] * corner;
  }
  const Eigen::Matrix<double, 2, 4> gradients = jacobian.inverse() * slopes;
  StrainMatrix strain = StrainMatrix::Zero();
  for (int k = 0; k < 4; ++k) {
    strain(0, 2 * k) = gradients(0, k);
    strain(1, 2 * k + 1) = gradients(1, k);
    strain(2, 2 * k) = shapes[k] / place[0];
    strain(3, 2 * k) = gradients(1, k);
    strain(3, 2 * k + 1) = gradients(0, k);
  }
  return {strain, shapes, place, 2.0 * std::numbers::pi * place[0] * jacobian.determinant()};
}

}  // namespace

Body::Body(Mesh mesh, const Material& material, std::vector<Freedom> freedoms)
    : mesh_(std::move(mesh)), material_(material), freedoms_(std::move(freedoms)) {
  for (const Freedom& freedom : freedoms_) size_ = std::max(size_, freedom.unknown + 1);
  volumes_ = Eigen::VectorXd::Zero(size_);
  prepare();
  prepare_pattern();
  kept_ = now_ = forces_ = Eigen::VectorXd::Zero(size_);
}

void Body::prepare() {
  const double gauss = 1.0 / std::sqrt(3.0);
  for (const auto& element : mesh_.elements) {
    std::array<Eigen::Vector2d, 4> corners;
    std::array<Freedom, 8> freedoms;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto node = static_cast<std::size_t>(element[k]);
      corners[k] = mesh_.nodes[node];
      freedoms[2 * k] = freedoms_[2 * node];
      freedoms[2 * k + 1] = freedoms_[2 * node + 1];
    }
    std::array<Sample, 4> samples;
    Eigen::Matrix<double, 1, 8> mean = Eigen::Matrix<double, 1, 8>::Zero();
    double volume = 0.0;
    for (std::size_t p = 0; p < 4; ++p) {
      samples[p] = sample(corners, p % 2 ? gauss : -gauss, p / 2 ? gauss : -gauss);
      mean += samples[p].volume * samples[p].strain.topRows<3>().colwise().sum();
      volume += samples[p].volume;
      for (std::size_t i = 0; i < 8; ++i)
        if (const Freedom& each = freedoms[i]; each.unknown >= 0)
          volumes_[each.unknown] +=
              each.factor * each.factor * samples[p].volume * samples[p].shapes[static_cast<int>(i / 2)];
    }
    mean /= volume;
    for (Sample& each : samples) {
      const Eigen::Matrix<double, 1, 8> excess = (mean - each.strain.topRows<3>().colwise().sum()) / 3.0;
      each.strain.topRows<3>().rowwise() += excess;
      points_.push_back({each.strain, each.place, each.volume, Stress::Zero(), Stress::Zero(), 0.0, 0.0});
    }
    of_elements_.push_back(freedoms);
  }
}

void Body::prepare_pattern() {
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < size_; ++k) entries.emplace_back(k, k, 0.0);
  for (const auto& freedoms : of_elements_)
    for (const Freedom& row : freedoms)
      for (const Freedom& column : freedoms)
        if (column.unknown >= 0 && row.unknown >= column.unknown)
          entries.emplace_back(row.unknown, column.unknown, 0.0);
  tangent_.resize(size_, size_);
  tangent_.setFromTriplets(entries.begin(), entries.end());
  tangent_.makeCompressed();
  const int* const rows = tangent_.innerIndexPtr();
  const int* const starts = tangent_.outerIndexPtr();
  for (const auto& freedoms : of_elements_) {
    std::array<int, 64> places;
    for (std::size_t i = 0; i < 8; ++i)
      for (std::size_t j = 0; j < 8; ++j) {
        const int row = freedoms[i].unknown, column = freedoms[j].unknown;
        int& place = places[8 * i + j] = -1;
        if (column < 0 || row < column) continue;
        place = static_cast<int>(std::lower_bound(rows + starts[column], rows + starts[column + 1], row) - rows);
      }
    places_.push_back(places);
  }
}

void Body::add_spring(int unknown, double k) { springs_.emplace_back(unknown, k); }

void Body::assemble(const Eigen::VectorXd& unknowns) {
  now_ = unknowns;
  const Eigen::VectorXd change = now_ - kept_;
  double* const values = tangent_.valuePtr();
  std::fill_n(values, tangent_.nonZeros(), 0.0);
  forces_.setZero();
  const Stiffness elastic = material_.stiffness();
  for (std::size_t e = 0; e < of_elements_.size(); ++e) {
    const auto& freedoms = of_elements_[e];
    const Eigen::Matrix<double, 8, 1> step = of_element(e, change);
    Eigen::Matrix<double, 8, 8> stiffness = Eigen::Matrix<double, 8, 8>::Zero();
    Eigen::Matrix<double, 8, 1> force = Eigen::Matrix<double, 8, 1>::Zero();
    for (std::size_t p = 4 * e; p < 4 * e + 4; ++p) {
      Point& point = points_[p];
      const Returned returned = radial_return(material_, point.kept + elastic * (point.strain * step), point.slip);
      point.now = returned.stress;
      point.slip_now = point.slip + returned.slip;
      force.noalias() += point.volume * (point.strain.transpose() * returned.stress);
      const StrainMatrix product = point.volume * returned.tangent * point.strain;
      stiffness.noalias() += point.strain.transpose() * product;
    }
    for (std::size_t i = 0; i < 8; ++i) {
      if (freedoms[i].unknown < 0) continue;
      forces_[freedoms[i].unknown] += freedoms[i].factor * force[static_cast<int>(i)];
      for (std::size_t j = 0; j < 8; ++j)
        if (const int place = places_[e][8 * i + j]; place >= 0)
          values[place] +=
              freedoms[i].factor * freedoms[j].factor * stiffness(static_cast<int>(i), static_cast<int>(j));
    }
  }
  for (const auto& [unknown, k] : springs_) {
    forces_[unknown] += k * now_[unknown];
    tangent_.coeffRef(unknown, unknown) += k;
  }
}

Eigen::Matrix<double, 8, 1> Body::of_element(std::size_t element, const Eigen::VectorXd& unknowns) const {
  Eigen::Matrix<double, 8, 1> values;
  for (std::size_t i = 0; i < 8; ++i) {
    const Freedom& each = of_elements_[element][i];
    values[static_cast<int>(i)] = each.unknown < 0 ? 0.0 : each.factor * unknowns[each.unknown];
  }
  return values;
}

void Body::follow(const Eigen::VectorXd& unknowns) {
  now_ = unknowns - kept_;
  forces_.setZero();
  const Stiffness elastic = material_.stiffness();
  for (std::size_t e = 0; e < of_elements_.size(); ++e) {
    const Eigen::Matrix<double, 8, 1> step = of_element(e, now_);
    Eigen::Matrix<double, 8, 1> force = Eigen::Matrix<double, 8, 1>::Zero();
    for (std::size_t p = 4 * e; p < 4 * e + 4; ++p) {
      Point& point = points_[p];
      point.kept += elastic * (point.strain * step);
      if (mises(point.kept) > material_.strength + material_.hardening * point.slip) {
        const Returned returned = radial_return(material_, point.kept, point.slip);
        point.kept = returned.stress;
        point.slip += returned.slip;
      }
      force.noalias() += point.volume * (point.strain.transpose() * point.kept);
    }
    for (std::size_t i = 0; i < 8; ++i)
      if (const Freedom& each = of_elements_[e][i]; each.unknown >= 0)
        forces_[each.unknown] += each.factor * force[static_cast<int>(i)];
  }
  for (const auto& [unknown, k] : springs_) forces_[unknown] += k * unknowns[unknown];
  kept_ = unknowns;
}

void Body::keep() {
  kept_ = now_;
  for (Point& point : points_) {
    point.kept = point.now;
    point.slip = point.slip_now;
  }
}

Energies Body::energies() const {
  Energies energies{0.0, 0.0};
  for (const Point& point : points_) {
    energies.stored += point.volume * elastic_energy(material_, point.kept);
    if (point.slip > 0.0)
      energies.dissipated += point.volume * (material_.strength + 0.5 * material_.hardening * point.slip) * point.slip;
  }
  for (const auto& [unknown, k] : springs_) energies.stored += 0.5 * k * kept_[unknown] * kept_[unknown];
  return energies;
}

double Body::displacement(const Eigen::VectorXd& unknowns, int node, int direction) const {
  const Freedom& its = freedom(node, direction);
  return its.unknown < 0 ? 0.0 : its.factor * unknowns[its.unknown];
}

}  // namespace yield_study
