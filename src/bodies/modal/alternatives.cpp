#include "bodies/modal/alternatives.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/half_space/medium.hpp"

namespace stoss::bodies::modal {
namespace {

/// χ over φ of a Rayleigh wave of the frequency 1.
double bend_of_waves(const ModalBody& its) {
  const double wave_speed = std::sqrt(its.young / its.density);
  const double slowest = half_space::medium(Contour::ball, its.poisson).rayleigh_speed() * wave_speed;
  return -0.25 / (slowest * slowest);
}

/// The body with all of its modes changed.
template <typename Change>
ModalBody with_modes(const ModalBody& its, const Change& change) {
  ModalBody other = its;
  for (PointMode& mode : other.modes) change(mode);
  return other;
}

/// What the modes of a body have of its compliance c₀.
double share_of_modes(const ModalBody& its) {
  double sum = 0.0;
  for (const PointMode& mode : its.modes) sum += std::pow(mode.displacement / mode.omega, 2);
  return sum;
}

/// Of a body that is held the lowest modes have nearly all of c₀, and err with it: what they leave of it stays.
ModalBody with_rest_kept(const ModalBody& its, ModalBody other) {
  if (its.held) other.compliance += share_of_modes(other) - share_of_modes(its);
  return other;
}

bool any(const ModalBody& its, double PointMode::*value) {
  return std::any_of(its.modes.begin(), its.modes.end(), [value](const PointMode& mode) { return mode.*value != 0.0; });
}

}  // namespace

std::vector<ModalBody> alternatives(const ModalBody& its, double other) {
  std::vector<ModalBody> all;
  if (its.compliance_error > 0.0) {
    all.push_back(its);
    all.back().compliance += its.compliance_error;
  }
  if (any(its, &PointMode::omega_error)) {
    all.push_back(with_rest_kept(its, with_modes(its, [](PointMode& mode) { mode.omega += mode.omega_error; })));
  }
  if (any(its, &PointMode::displacement_error)) {
    all.push_back(with_rest_kept(its, with_modes(its, [](PointMode& mode) {
                                   mode.displacement += std::copysign(mode.displacement_error, mode.displacement);
                                 })));
  }
  if (!its.has_bends) {  // as of Rayleigh waves of their frequency
    const double bend = bend_of_waves(its);
    all.push_back(
        with_modes(its, [bend](PointMode& mode) { mode.bend = bend * mode.displacement * mode.omega * mode.omega; }));
  }
  if (its.curvature_difference > 0.0) {
    // Of Hertz' ellipses up to 4 : 1 the curvature counts that is A B (A + B)/2, cubed, with the relative ones A, B.
    all.push_back(its);
    const double mean = its.curvature + other / own_length(its), half = 0.5 * its.curvature_difference;
    all.back().curvature -= mean - std::cbrt((mean * mean - half * half) * mean);
    all.back().curvature_difference = 0.0;  // round, or its own ratio may be refused
  }
  return all;
}

std::vector<ModalBody> alternatives_along(const ModalBody& its) {
  std::vector<ModalBody> all;
  if (!its.tangent) return all;
  if (its.tangent->compliance_error > 0.0) {
    all.push_back(its);
    all.back().tangent->compliance += its.tangent->compliance_error;
  }
  if (any(its, &PointMode::tangential_error)) {
    all.push_back(with_modes(
        its, [](PointMode& mode) { mode.tangential += std::copysign(mode.tangential_error, mode.tangential); }));
  }
  if (!its.tangent->has_bends && any(its, &PointMode::tangential)) {
    const double bend = bend_of_waves(its);
    all.push_back(with_modes(
        its, [bend](PointMode& mode) { mode.tangential_bend = bend * mode.tangential * mode.omega * mode.omega; }));
  }
  return all;
}

Unevenness unevenness(const ModalBody& its, double other) {
  if (its.curvature_difference == 0.0) return {};
  const double mean = its.curvature + other / own_length(its), half = 0.5 * its.curvature_difference;
  return {std::abs(its.poisson) / (2.0 - its.poisson) * half / mean, half * own_length(its)};
}

}  // namespace stoss::bodies::modal
