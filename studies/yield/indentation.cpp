#include "indentation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace yield_study {
namespace {

constexpr int most_halvings = 7;  // of a step

}  // namespace

Indentation::Indentation(HalfSpace half_space, double radius_of_curvature)
    : half_space_(std::move(half_space)),
      curvature_radius_(radius_of_curvature),
      newton_(half_space_.body),
      unknowns_(Eigen::VectorXd::Zero(half_space_.body.size())),
      none_(Eigen::VectorXd::Zero(half_space_.body.size())),
      touching_(static_cast<std::size_t>(half_space_.body.size()), 0),
      candidates_(half_space_.surface.size() - 1) {}

double Indentation::target(std::size_t node, double depth) const {
  const double r = half_space_.body.mesh().nodes[static_cast<std::size_t>(half_space_.surface[node])][0];
  return 0.5 * r * r / curvature_radius_ - depth;
}

int Indentation::unknown(std::size_t node) const {
  return half_space_.body.freedom(half_space_.surface[node], 1).unknown;
}

/// Nodes that are pulled let go, and those below the indenter touch. True if none changed.
bool Indentation::update_contact(double depth) {
  bool same = true;
  for (std::size_t node = 0; node < candidates_; ++node) {
    const int k = unknown(node);
    char& touches = touching_[static_cast<std::size_t>(k)];
    const double above = unknowns_[k] - target(node, depth), pull = half_space_.body.forces()[k];
    const bool change = touches ? pull > 0.0 : above > 1e-12 * std::abs(depth);
    if (!change) continue;
    touches = !touches;
    same = false;
  }
  return same;
}

Reading Indentation::go(double depth) { return go(depth, most_halvings); }

Reading Indentation::go(double depth, int halvings) {
  const Eigen::VectorXd unknowns = unknowns_;
  const std::vector<char> touching = touching_;
  if (const int iterations = attempt(depth)) {
    depth_ = depth;
    return reading(depth, iterations);
  }
  if (halvings == 0) throw std::runtime_error("no equilibrium found");
  unknowns_ = unknowns;
  touching_ = touching;
  (void)go(0.5 * (depth_ + depth), halvings - 1);
  return go(depth, halvings - 1);
}

/// Iterations until equilibrium, whose state is then kept; 0 if it was not found.
int Indentation::attempt(double depth) {
  constexpr int most = 25;
  constexpr double tolerance = 1e-8;
  Body& body = half_space_.body;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(body.size());
  for (std::size_t node = 0; node < candidates_; ++node) values[unknown(node)] = target(node, depth);
  body.assemble(unknowns_);
  // Deeper, the indenter would overlap many nodes at once, most of which it pushes away when it comes. So the nodes
  // of the last step are the better start.
  const auto touches = [&] {
    return std::any_of(touching_.begin(), touching_.end(), [](char each) { return each != 0; });
  };
  if (!touches()) update_contact(depth);
  for (int iteration = 1; iteration <= most; ++iteration) {
    newton_.step(unknowns_, touching_, values, none_);
    const bool same = update_contact(depth);
    // Without contact there is no force to compare with.
    const double imbalance = touches() ? newton_.imbalance(touching_, none_) : body.forces().cwiseAbs().maxCoeff();
    if (same && imbalance < tolerance) {
      body.keep();
      return iteration;
    }
  }
  return 0;
}

Reading Indentation::reading(double depth, int iterations) const {
  Reading reading{depth, 0.0, 0.0, 0, iterations};
  const auto& nodes = half_space_.body.mesh().nodes;
  const auto place = [&](std::size_t node) { return nodes[static_cast<std::size_t>(half_space_.surface[node])][0]; };
  std::size_t last = 0;
  for (std::size_t node = 0; node < candidates_; ++node) {
    const int k = unknown(node);
    if (!touching_[static_cast<std::size_t>(k)]) continue;
    reading.force -= half_space_.body.forces()[k];
    ++reading.nodes;
    last = node;
  }
  if (reading.nodes == 0) return reading;
  // Where the gap, which grows as (r − a)^{3/2} by the edge of an elastic contact, would close.
  const auto gap = [&](std::size_t node) { return std::max(target(node, depth) - unknowns_[unknown(node)], 0.0); };
  const double ratio = std::pow(gap(last + 1) / gap(last + 2), 2.0 / 3.0);
  const double edge = (place(last + 1) - ratio * place(last + 2)) / (1.0 - ratio);
  reading.radius = std::clamp(edge, place(last), place(last + 1));
  return reading;
}

std::vector<Eigen::Vector2d> Indentation::surface() const {
  std::vector<Eigen::Vector2d> points;
  for (const int node : half_space_.surface)
    points.emplace_back(half_space_.body.mesh().nodes[static_cast<std::size_t>(node)][0],
                        half_space_.body.displacement(unknowns_, node, 1));
  return points;
}

}  // namespace yield_study
