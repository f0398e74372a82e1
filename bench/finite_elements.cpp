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

Moduli moduli_of(Symmetry symmetry, double poisson) {
  const double shear = 0.5 / (1.0 + poisson);
  if (symmetry == Symmetry::plane) {  // plane stress
    const double normal = 1.0 / (1.0 - poisson * poisson);
    return {normal, poisson * normal, shear};
  }
  const double lateral = poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  return {lateral + 2.0 * shear, lateral, shear};
}

struct Metric {
  double weight;                // of a sphere per 2π
  std::array<double, 4> slope;  // as ElementGroup::slope
  double hoop;                  // as HoopGroup::slope
};

Metric metric_at(Symmetry symmetry, const Element& element, std::size_t node) {
  const SpectralRule& rule = element.at_axis ? lobatto_at_axis : lobatto;
  const std::size_t row = node / side;
  const std::size_t column = node % side;
  Point r, s;  // ∂/∂r and ∂/∂s of the position
  for (std::size_t k = 0; k < side; ++k) {
    const Point& above = element.nodes[k * side + column];
    const Point& beside = element.nodes[row * side + k];
    r.across += rule.derivative[row][k] * above.across;
    r.towards += rule.derivative[row][k] * above.towards;
    s.across += lobatto.derivative[column][k] * beside.across;
    s.towards += lobatto.derivative[column][k] * beside.towards;
  }
  const double jacobian = r.across * s.towards - r.towards * s.across;
  const bool on_axis = element.at_axis && row == 0;
  const double radius = element.nodes[node].across;
  double weight = rule.weights[row] * lobatto.weights[column] * std::abs(jacobian);
  if (symmetry == Symmetry::axial)
    weight *= on_axis ? r.across : element.at_axis ? radius / (1.0 + rule.points[row]) : radius;
  const double root = std::sqrt(weight);
  const double scale = root / jacobian;
  return {weight,
          {scale * s.towards, -scale * r.towards, -scale * s.across, scale * r.across},
          symmetry == Symmetry::axial && !on_axis ? root / radius : 0.0};
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

FiniteElements::FiniteElements(Symmetry symmetry, double poisson, const std::vector<Element>& elements)
    : symmetry_(symmetry), moduli_(moduli_of(symmetry, poisson)) {
  place(elements);
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
  const auto groups_for = [](std::ptrdiff_t number) { return (static_cast<std::size_t>(number) + lanes - 1) / lanes; };
  const auto at_axis = std::count_if(elements.begin(), elements.end(), [](const Element& e) { return e.at_axis; });
  groups_.at_axis = groups_for(at_axis);
  // The last groups at and beside the axis may have empty lanes, without slopes.
  std::vector<ElementGroup>& groups = groups_.all;
  groups.resize(groups_.at_axis + groups_for(std::ssize(elements) - at_axis));
  if (symmetry_ == Symmetry::axial) groups_.hoops.resize(groups.size());
  const std::size_t inner = groups.size() * lanes * inner_nodes;
  nodes_.resize(inner + 1);  // one more, for empty lanes
  mass_.assign(nodes_.size(), 0.0);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].inner = g * lanes * inner_nodes;
    for (auto& places : groups[g].rim) places.fill(inner);
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
    return place;
  };
  std::size_t next_beside = groups_.at_axis * lanes;
  std::size_t next_at_axis = 0;
  for (const Element& element : elements) {
    const std::size_t slot = element.at_axis ? next_at_axis++ : next_beside++;
    ElementGroup& group = groups[slot / lanes];
    const std::size_t lane = slot % lanes;
    std::size_t next = group.inner + lane;
    for (std::size_t node = 0; node < element_nodes; ++node) {
      std::size_t place = next;
      if (is_inner(node)) {
        next += lanes;
        nodes_[place] = element.nodes[node];
      } else {
        place = group.rim[node][lane] = on_rim(element.nodes[node]);
      }
      const Metric metric = metric_at(symmetry_, element, node);
      for (std::size_t i = 0; i < 4; ++i) group.slope[node][i][lane] = metric.slope[i];
      if (symmetry_ == Symmetry::axial) groups_.hoops[slot / lanes].slope[node][lane] = metric.hoop;
      mass_[place] += metric.weight;
      all_mass_ += metric.weight;
    }
  }
}

void FiniteElements::add_forces() {
  bench::add_forces(groups_, moduli_, nodes_.size(), displacement_.data(), force_.data());
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

void FiniteElements::start(double velocity) {
  const auto half = static_cast<std::ptrdiff_t>(nodes_.size());
  std::fill(displacement_.begin(), displacement_.end(), 0.0);
  std::fill(force_.begin(), force_.end(), 0.0);
  std::fill(velocity_.begin(), velocity_.begin() + half, 0.0);
  std::fill(velocity_.begin() + half, velocity_.end(), velocity);
}

void FiniteElements::advance(double step) {
  add_forces();
  move(force_.size(), step, inverse_mass_.data(), force_.data(), velocity_.data(), displacement_.data());
}

double FiniteElements::push(std::size_t node, double more, double step) {
  const std::size_t towards = nodes_.size() + node;
  displacement_[towards] += more;
  velocity_[towards] += more / step;
  return mass_[node] * more / step;
}

}  // namespace bench
