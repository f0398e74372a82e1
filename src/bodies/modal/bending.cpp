// How a body bends across the contact beside a sphere of its curvature, as its modes tell.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "bodies/modal/point_modes.hpp"
#include "bodies/sphere/mode_search.hpp"
#include "bodies/surface/residual.hpp"

namespace stoss::bodies::modal {
namespace {

constexpr double mass_of_sphere = 4.0 * std::numbers::pi / 3.0;
constexpr double enough = 24.0;  // modes of a sphere above, c/R, cost more than they tell

/// φχ/ω² of a mode.
struct Part {
  double omega, value;
};

double tapered(const std::vector<Part>& parts, double highest) {
  double sum = 0.0;
  for (const auto& [omega, value] : parts) {
    if (omega < highest) sum += value * std::pow(1.0 - std::pow(omega / highest, 2), 2);
  }
  return sum;
}

/// Those of a sphere at its pole: of u_r cos θ − u_θ sin θ.
std::vector<Part> parts_of_sphere(double poisson, double highest, const Poll& poll) {
  std::vector<Part> parts;
  for (const Mode& mode : sphere::checked_modes(poisson, highest, poll)) {
    const double wave = mode.order * (mode.order + 1.0);
    const double bend = 0.5 * wave * mode.tangential - (0.25 * wave + 0.5) * mode.radial;
    parts.push_back({mode.omega, mode.radial * bend / (mass_of_sphere * mode.omega * mode.omega)});
  }
  return parts;
}

}  // namespace

Bending bending(const ModalBody& body, const Poll& poll) {
  if (body.curvature == 0.0 || !body.has_bends) return {};
  const double highest = std::min(enough, body.complete_to * own_length(body) / wave_speed(body));
  const PointModes modes = point_modes(body, highest);
  std::vector<Part> parts;
  for (const KeptMode& mode : modes.kept) {
    parts.push_back({mode.omega, mode.displacement * mode.bend / (modes.mass * mode.omega * mode.omega)});
  }
  for (const auto& [omega, value] : parts_of_sphere(body.poisson, highest, poll)) parts.push_back({omega, -value});
  const double constant = tapered(parts, highest);
  return {constant, std::abs(constant - tapered(parts, highest / std::numbers::sqrt2))};
}

void add_bending(double constant, const ContactPoints& points, std::vector<double>& matrix) {
  for (std::size_t i = 0; i < points.count; ++i) {
    for (std::size_t j = 0; j < points.count; ++j) {
      const double here = lateral_distance(points, i), there = lateral_distance(points, j);
      matrix[i * points.count + j] += constant * (here * here + there * there);
    }
  }
}

}  // namespace stoss::bodies::modal
