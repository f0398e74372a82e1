#include "finite_elements.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "numeric/multiversion.hpp"

namespace bench {
namespace {

constexpr std::size_t side = element_side;
constexpr std::size_t lanes = ElementGroup::lanes;
constexpr std::size_t inner_nodes = (side - 2) * (side - 2);
constexpr double same_place = 1e-8;  // nodes are further apart; coordinates of one agree much better

struct Metric {
  double weight;
  std::array<double, 4> slope;  // as ElementGroup::slope
};

Metric metric_at(const Element& element, std::size_t node) {
  const std::size_t row = node / side;
  const std::size_t column = node % side;
  Point r, s;  // ∂/∂r and ∂/∂s of the position
  for (std::size_t k = 0; k < side; ++k) {
    const Point& above = element[k * side + column];
    const Point& beside = element[row * side + k];
    r.across += derivative[row][k] * above.across;
    r.towards += derivative[row][k] * above.towards;
    s.across += derivative[column][k] * beside.across;
    s.towards += derivative[column][k] * beside.towards;
  }
  const double jacobian = r.across * s.towards - r.towards * s.across;
  const double weight = lobatto_weights[row] * lobatto_weights[column] * std::abs(jacobian);
  const double scale = std::sqrt(weight) / jacobian;
  return {weight, {scale * s.towards, -scale * r.towards, -scale * s.across, scale * r.across}};
}

/// One step of all nodes without a wall; leaves no force.
STOSS_MULTIVERSION
void move(std::size_t count, double step, const double* inverse_mass, double* force, double* velocity,
          double* displacement) {
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    velocity[i] += step * inverse_mass[i] * force[i];
    displacement[i] += step * velocity[i];
    force[i] = 0.0;
  }
}

}  // namespace

FiniteElements::FiniteElements(double poisson, const MeshSize& size)
    : moduli_{1.0 / (1.0 - poisson * poisson), poisson / (1.0 - poisson * poisson), 0.5 / (1.0 + poisson)} {
  place(half_disk(size));
  const std::size_t count = nodes_.size();
  for (std::vector<double>* all : {&inverse_mass_, &displacement_, &velocity_, &force_}) all->assign(2 * count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    if (mass_[i] == 0.0) continue;  // of an empty lane
    if (nodes_[i].across > same_place) inverse_mass_[i] = 1.0 / mass_[i];
    inverse_mass_[count + i] = 1.0 / mass_[i];
  }
  find_step();
}

/// Numbers the nodes, and fills the groups.
void FiniteElements::place(const std::vector<Element>& elements) {
  groups_.resize((elements.size() + lanes - 1) / lanes);  // the last may have empty lanes, without slopes
  const std::size_t inner = groups_.size() * lanes * inner_nodes;
  nodes_.resize(inner + 1);  // one more, for empty lanes
  mass_.assign(nodes_.size(), 0.0);
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    groups_[g].inner = g * lanes * inner_nodes;
    for (auto& places : groups_[g].rim) places.fill(inner);
  }
  std::map<std::pair<long, long>, std::size_t> known;
  const auto on_rim = [&](const Point& point) {
    const long x = std::lround(point.across / same_place);
    const long z = std::lround(point.towards / same_place);
    for (const long i : {0, -1, 1}) {
      for (const long j : {0, -1, 1}) {
        if (const auto found = known.find({x + i, z + j}); found != known.end()) return found->second;
      }
    }
    const std::size_t place = known[{x, z}] = nodes_.size();
    nodes_.push_back(point);
    mass_.push_back(0.0);
    const double radius = std::hypot(point.across, point.towards);
    if (point.towards > 0.0 && radius > 1.0 - same_place) edge_.push_back(place);
    return place;
  };
  for (std::size_t e = 0; e < elements.size(); ++e) {
    ElementGroup& group = groups_[e / lanes];
    const std::size_t lane = e % lanes;
    std::size_t next = group.inner + lane;
    for (std::size_t node = 0; node < element_nodes; ++node) {
      std::size_t place = next;
      if (is_inner(node)) {
        next += lanes;
        nodes_[place] = elements[e][node];
      } else {
        place = group.rim[node][lane] = on_rim(elements[e][node]);
      }
      const Metric metric = metric_at(elements[e], node);
      for (std::size_t i = 0; i < 4; ++i) group.slope[node][i][lane] = metric.slope[i];
      mass_[place] += metric.weight;
      mass_of_half_ += metric.weight;
    }
  }
}

void FiniteElements::add_forces() {
  bench::add_forces(groups_.data(), groups_.size(), moduli_, nodes_.size(), displacement_.data(), force_.data());
}

/// As long as is stable, 2/ω of the highest frequency, less a margin; by power iteration.
void FiniteElements::find_step() {
  for (std::size_t i = 0; i < displacement_.size(); ++i) displacement_[i] = std::sin(static_cast<double>(i * i));
  double square = 0.0;  // ω²
  for (int iteration = 0; iteration < 200; ++iteration) {
    std::fill(force_.begin(), force_.end(), 0.0);
    add_forces();
    double sum = 0.0;
    for (std::size_t i = 0; i < force_.size(); ++i) {
      displacement_[i] = inverse_mass_[i] * force_[i];
      sum += displacement_[i] * displacement_[i];
    }
    square = std::sqrt(sum);
    for (double& u : displacement_) u /= square;
  }
  constexpr double margin = 0.95;
  step_ = margin * 2.0 / std::sqrt(square);
}

double FiniteElements::rayleigh_quotient(const std::vector<Point>& displacement) {
  const std::size_t count = nodes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    displacement_[i] = displacement[i].across;
    displacement_[count + i] = displacement[i].towards;
  }
  std::fill(force_.begin(), force_.end(), 0.0);
  add_forces();
  double stiffness = 0.0;
  double inertia = 0.0;
  for (std::size_t i = 0; i < displacement_.size(); ++i) {
    stiffness -= displacement_[i] * force_[i];
    inertia += mass_[i % count] * displacement_[i] * displacement_[i];
  }
  return stiffness / inertia;
}

ElementCollision FiniteElements::collide(double speed) {
  const std::size_t count = nodes_.size();
  std::fill(displacement_.begin(), displacement_.end(), 0.0);
  std::fill(force_.begin(), force_.end(), 0.0);
  std::fill(velocity_.begin(), velocity_.begin() + static_cast<std::ptrdiff_t>(count), 0.0);
  std::fill(velocity_.begin() + static_cast<std::ptrdiff_t>(count), velocity_.end(), speed);
  double* const towards = displacement_.data() + count;
  double* const velocity = velocity_.data() + count;
  double impulse = 0.0;
  ElementCollision result;
  constexpr double longest = 50.0;  // R/c
  constexpr double quiet = 0.3;     // without contact; shorter breaks were at most 0.05
  for (double time = 0.0; time < std::min(longest, result.contact_time + quiet); ++result.steps) {
    add_forces();
    move(2 * count, step_, inverse_mass_.data(), force_.data(), velocity_.data(), displacement_.data());
    time += step_;
    for (const std::size_t node : edge_) {
      const double beyond = towards[node] - (1.0 - nodes_[node].towards);
      if (beyond <= 0.0) continue;
      towards[node] -= beyond;
      velocity[node] -= beyond / step_;
      impulse += mass_[node] * beyond / step_;
      result.contact_time = time;
    }
  }
  const double after = 1.0 - impulse / (mass_of_half_ * speed);  // velocity over v
  result.lost_fraction = 1.0 - after * after;
  return result;
}

}  // namespace bench
