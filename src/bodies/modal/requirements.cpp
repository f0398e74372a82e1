// What numbers a body by its modes at a point may have.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>

#include "bodies/half_space/lamb_kernel.hpp"
#include "bodies/half_space/surface_waves.hpp"
#include "bodies/modal/point_modes.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::modal {
namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr Range positive{0.0, most, false, true, "a positive finite number"};
constexpr Range not_negative{0.0, most, true, true, "0 or a positive finite number"};
constexpr Range finite{-most, most, true, true, "a finite number"};

/// Local law of Weyl: Σ φ² over the modes up to ω of a large body is that of a half-space, (2/3π) C ω³/(ρ c_s³).
double expected_sum(const ModalBody& body, double omega) {
  const double shear = std::sqrt(0.5 * body.young / (body.density * (1.0 + body.poisson)));
  const double radiated = half_space::radiation_coefficient(half_space::lamb_kernel(body.poisson));
  return 2.0 / (3.0 * std::numbers::pi) * radiated / body.density * std::pow(omega / shear, 3.0);
}

void require_modes(const ModalBody& body) {
  double last = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < body.modes.size(); ++i) {
    const PointMode& mode = body.modes[i];
    const std::string name = "mode " + std::to_string(i + 1) + " ";
    require(name + "frequency", mode.omega, positive, "of an elastic mode: rigid motion is not among them");
    require(name + "displacement", mode.displacement, finite, "along the normal at the point");
    require(name + "bend", mode.bend, finite, "of the displacement around the point");
    require(name + "frequency error", mode.omega_error, not_negative, "of the mode");
    require(name + "displacement error", mode.displacement_error, not_negative, "of the mode");
    require(name + "tangential displacement", mode.tangential, finite, "along the surface at the point");
    require(name + "tangential bend", mode.tangential_bend, finite, "of the displacement along the surface");
    require(name + "tangential displacement error", mode.tangential_error, not_negative, "of the mode");
    if (mode.omega < last) {
      throw InvalidInput::out_of_range(name + "frequency", shown(mode.omega) + " after " + shown(last),
                                       "modes in rising order");
    }
    last = mode.omega;
    if (mode.omega <= body.complete_to) sum += mode.displacement * mode.displacement;
  }
  // Below some ten modes the law says nothing, and where bodies are slender there are fewer than in a large one.
  constexpr double share = 0.1, enough = 30.0;
  const double expected = expected_sum(body, body.complete_to);
  if (expected * body.mass > enough && sum < share * expected) {
    throw InvalidInput::out_of_range(
        "modes",
        std::to_string(body.modes.size()) + " with " + rounded(sum) + " as the sum of their squared displacements",
        "about " + rounded(expected) + " up to complete_to",
        "modes are missing, or are not normalised to unit modal mass");
  }
}

void require_tangent(const PointTangent& its) {
  require("tangential mass", its.mass, positive, "of the body along its surface");
  require("tangential inertia", its.inertia, not_negative, "of the body as friction turns it; 0: it does not turn");
  require("tangential arm", its.arm, not_negative, "from the centre of mass to the point; 0: it does not turn");
  if ((its.inertia > 0.0) != (its.arm > 0.0)) {
    throw InvalidInput::out_of_range("tangential arm", shown(its.arm) + " with inertia " + shown(its.inertia),
                                     "both above 0, or both 0", "it does not turn");
  }
  require("tangential cross", its.cross, finite, "by which the normal force turns the point along the surface");
  require("tangential compliance", its.compliance, finite, "c_t at the point");
  require("tangential compliance_error", its.compliance_error, not_negative, "of c_t");
}

/// Numbers in units that do not belong together. Of all bodies of one mass a ball has about the highest first
/// frequency, ω (m/ρ)^{1/3}/c = 4; and what the modes up to ω leave of c₀ is that of shorter waves, −0.2 to −2 c/(Eω)
/// of shipped bodies and their finite elements, and of thin ones more, as (c/ωh)².
void require_fit(const ModalBody& body) {
  constexpr double highest = 20.0, least = -10.0, greatest = 1e4;
  constexpr const char* units = "are all numbers in one system of units: Pa, kg/m3, kg, m/N, Hz, kg^(-1/2)?";
  if (body.modes.empty()) return;
  const double speed = wave_speed(body), first = body.modes.front().omega * std::cbrt(body.mass / body.density) / speed;
  if (first > highest) {
    throw InvalidInput::out_of_range(
        "modes", "a lowest frequency of " + rounded(first) + " c/L, L = (mass/density)^(1/3), c = sqrt(young/density)",
        "some 4 and less", units);
  }
  double taken = 0.0, moved = 0.0;
  for (const PointMode& mode : body.modes) {
    if (mode.omega <= body.complete_to) taken += std::pow(mode.displacement / mode.omega, 2);
    moved = std::max(moved, body.mass * std::pow(mode.displacement, 2));
  }
  constexpr double most_moved = 1e5, least_moved = 1e-5;
  constexpr std::size_t enough = 10;  // modes of which one moves the point
  if (moved > most_moved || (moved < least_moved && body.modes.size() >= enough)) {
    throw InvalidInput::out_of_range(
        "mass",
        rounded(body.mass) + " beside modes whose displacement squared is at most " + rounded(moved / body.mass),
        "a product of some 1 to 100", units);
  }
  const double left = (body.compliance - taken) * body.young * speed / body.complete_to;
  if (left >= least && left <= greatest) return;
  throw InvalidInput::out_of_range("compliance",
                                   rounded(body.compliance) + " beside modes that have " + rounded(taken) + " of it",
                                   "what leaves some -1 c/(young omega) for the modes above", units);
}

}  // namespace

void require_body(const ModalBody& body) {
  require("mass", body.mass, positive, "of the body, as its point feels it");
  require("poisson", body.poisson, {-0.95, 0.4999, true, true, "-0.95 to 0.4999"}, "Poisson's ratio at the point");
  require("young", body.young, positive, "Young's modulus at the point");
  require("density", body.density, positive, "at the point");
  require("curvature", body.curvature, not_negative, "mean curvature at the point; a hollow one is not computed");
  require("curvature_difference", body.curvature_difference, not_negative, "of the principal curvatures");
  require("compliance", body.compliance, finite, "c0 at the point");
  require("compliance_error", body.compliance_error, not_negative, "of c0");
  require("complete_to", body.complete_to, positive, "highest frequency up to which all modes are there");
  require_loss_time(body.loss_time * wave_speed(body) / own_length(body));
  require_modes(body);
  require_fit(body);
  if (body.tangent) require_tangent(*body.tangent);
}

}  // namespace stoss::bodies::modal
