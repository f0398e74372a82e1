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

Alternatives alternatives(const ModalBody& its, double other) {
  Alternatives all;
  if (its.compliance_error > 0.0) {
    all.errors.push_back(its);
    all.errors.back().compliance += its.compliance_error;
  }
  if (any(its, &PointMode::omega_error)) {
    all.errors.push_back(with_rest_kept(its, with_modes(its, [](PointMode& mode) { mode.omega += mode.omega_error; })));
  }
  if (any(its, &PointMode::displacement_error)) {
    all.errors.push_back(with_rest_kept(its, with_modes(its, [](PointMode& mode) {
                                          mode.displacement +=
                                              std::copysign(mode.displacement_error, mode.displacement);
                                        })));
  }
  if (!its.has_bends) {  // as of Rayleigh waves of their frequency
    const double bend = bend_of_waves(its);
    all.bounds.push_back(
        with_modes(its, [bend](PointMode& mode) { mode.bend = bend * mode.displacement * mode.omega * mode.omega; }));
  }
  if (its.curvature_difference > 0.0 && its.has_bends) {
    // Of an ellipse as stiff as a circle the mean of r² is greater, and that along its long side at most by 1 + 2t, as
    // modes may bend along it alone (t = |A − B|/(A + B) up to 0.6).
    const double mean = its.curvature + other / own_length(its);
    const double longer = 1.0 + its.curvature_difference / mean;
    all.bounds.push_back(with_modes(its, [longer](PointMode& mode) { mode.bend *= longer; }));
  }
  return all;
}

Alternatives alternatives_along(const ModalBody& its) {
  Alternatives all;
  if (!its.tangent) return all;
  if (its.tangent->compliance_error > 0.0) {
    all.errors.push_back(its);
    all.errors.back().tangent->compliance += its.tangent->compliance_error;
  }
  if (any(its, &PointMode::tangential_error)) {
    all.errors.push_back(with_modes(
        its, [](PointMode& mode) { mode.tangential += std::copysign(mode.tangential_error, mode.tangential); }));
  }
  if (!its.tangent->has_bends && any(its, &PointMode::tangential)) {
    const double bend = bend_of_waves(its);
    all.bounds.push_back(with_modes(
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
