#include "impact/oblique/rings/wave_memory.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "numeric/kernels.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Shape of the modes of a group at the nodes.
auto shape_of(const ContactGrid& grid, const ModeGroup& group) {
  const auto nodes = static_cast<Index>(grid.recess.size());
  return VectorXd::Map(&grid.shape[group.upper_row * grid.recess.size()], nodes);
}

/// Orthonormal shapes, nodes × few, of which those of the groups consist.
MatrixXd common_shapes(const Contact& along, const ContactGrid& grid) {
  constexpr double rounding = 1e-15;  // the square of what is neglected
  const auto nodes = static_cast<Index>(grid.recess.size());
  MatrixXd sum = MatrixXd::Zero(nodes, nodes);
  for (std::size_t g = along.first_groups; g < along.groups.size(); ++g) {
    const ModeGroup& group = along.groups[g];
    double compliance = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      compliance += group.upper[l] * group.upper[l] / (group.omega[l] * group.omega[l]);
    }
    sum.selfadjointView<Eigen::Lower>().rankUpdate(shape_of(grid, group), compliance);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(sum);  // values rise
  const double least = rounding * solver.eigenvalues()(nodes - 1);
  Index few = 1;
  while (few < nodes && solver.eigenvalues()(nodes - 1 - few) > least) ++few;
  return solver.eigenvectors().rightCols(few).rowwise().reverse();
}

}  // namespace

bool remembers_waves(const Contact& along) {
  const std::size_t first = along.first_groups;
  if (!along.unbounded || first >= along.groups.size() || loses(*along.second)) return false;
  return std::all_of(along.groups.begin() + static_cast<std::ptrdiff_t>(first), along.groups.end(),
                     [](const ModeGroup& group) {
                       return std::all_of(group.lower.begin(), group.lower.end(), [](double w) { return w == 0.0; });
                     });
}

std::pair<Contact, ContactGrid> without_remembered(Contact along, ContactGrid grid) {
  if (!remembers_waves(along)) return {std::move(along), std::move(grid)};
  along.groups.resize(along.first_groups);
  std::size_t rows = 0;
  for (const ModeGroup& group : along.groups) rows = std::max({rows, group.upper_row + 1, group.lower_row + 1});
  grid.shape.resize(rows * grid.recess.size());
  return {std::move(along), std::move(grid)};
}

WaveMemory::Response WaveMemory::response(const Contact& along, const ContactGrid& grid, double step, std::size_t steps,
                                          const Poll& poll) {
  const MatrixXd shapes = common_shapes(along, grid);
  const auto count = static_cast<std::size_t>(shapes.cols());
  Response result{static_cast<std::size_t>(shapes.rows()), count, steps, 0.0, {}, {}, {}, {}};
  result.weight = step * step / along.mass;
  result.shape.assign(shapes.data(), shapes.data() + shapes.size());
  result.sine.resize(count * count * steps);
  result.cosine.resize(count * count * steps);
  result.cosine_at_once.resize(count * count);
  // Of each group: values of all its waves, then functions of time.
  VectorXd sine(static_cast<Index>(steps)), cosine(static_cast<Index>(steps));
  for (std::size_t g = along.first_groups; g < along.groups.size(); ++g) {
    if (poll) poll();
    const ModeGroup& group = along.groups[g];
    numeric::kernels::sum_oscillations(group.omega.data(), group.upper.data(), group.omega.size(), step, steps,
                                       sine.data(), cosine.data());
    double at_once = 0.0;
    for (const double upper : group.upper) at_once += upper * upper;
    const VectorXd part = shapes.transpose() * shape_of(grid, group);
    for (std::size_t b = 0; b < count; ++b) {
      for (std::size_t a = 0; a < count; ++a) {
        const double share = part(static_cast<Index>(a)) * part(static_cast<Index>(b));
        const std::size_t at = (b * count + a) * steps;
        VectorXd::Map(&result.sine[at], sine.size()) += share * sine;
        VectorXd::Map(&result.cosine[at], sine.size()) += share * cosine;
        result.cosine_at_once[b * count + a] += share * at_once;
      }
    }
  }
  for (double& each : result.sine) each *= step / along.mass;
  return result;
}

WaveMemory::WaveMemory(const Contact& along, const ContactGrid& grid, double step, std::size_t steps,
                       const Poll& poll) {
  if (steps == 0 || !remembers_waves(along)) return;
  response_ = std::make_shared<const Response>(response(along, grid, step, steps, poll));
  kick_.resize(response_->shapes);
  place_.resize(response_->shapes * steps);
  velocity_.resize(place_.size());
}

void WaveMemory::load(const std::vector<double>& force) {
  if (response_ == nullptr) return;
  const Response& its = *response_;
  for (std::size_t b = 0; b < its.shapes; ++b) {
    const double* shape = &its.shape[b * its.nodes];
    kick_[b] = 0.0;
    for (std::size_t i = 0; i < its.nodes; ++i) kick_[b] += shape[i] * force[i];
  }
}

void WaveMemory::advance() {
  if (response_ == nullptr) return;
  energy_ = energy_after(1.0);
  const Response& its = *response_;
  const std::size_t left = its.steps - std::min(its.steps, step_);
  for (std::size_t a = 0; a < its.shapes; ++a) {
    const std::size_t at = a * its.steps;
    numeric::kernels::add_transposed(&its.sine[at], its.shapes * its.steps, its.shapes, left, kick_.data(),
                                     &place_[at + step_]);
    numeric::kernels::add_transposed(&its.cosine[at], its.shapes * its.steps, its.shapes, left, kick_.data(),
                                     &velocity_[at + step_]);
  }
  ++step_;
}

void WaveMemory::add_displacement(std::vector<double>& position) const {
  if (response_ == nullptr || step_ == 0) return;
  const Response& its = *response_;
  for (std::size_t a = 0; a < its.shapes; ++a) {
    const double place = place_[a * its.steps + step_ - 1];
    const double* shape = &its.shape[a * its.nodes];
    for (std::size_t i = 0; i < its.nodes; ++i) position[i] -= place * shape[i];
  }
}

/// After a share of the kick that is due.
double WaveMemory::energy_after(double share) const {
  const Response& its = *response_;
  double sum = 0.0;
  for (std::size_t b = 0; b < its.shapes; ++b) {
    double velocity = step_ == 0 ? 0.0 : velocity_[b * its.steps + step_ - 1];
    for (std::size_t a = 0; a < its.shapes; ++a) {
      velocity += 0.5 * share * its.cosine_at_once[b * its.shapes + a] * kick_[a];
    }
    sum += share * kick_[b] * velocity;
  }
  return energy_ + its.weight * sum;
}

double WaveMemory::energy() const { return response_ == nullptr ? 0.0 : energy_after(0.5); }

}  // namespace stoss
