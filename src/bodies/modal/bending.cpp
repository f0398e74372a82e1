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

/// Σ value (1 − ω²/Ω²)² up to Ω.
struct Tapered {
  double highest, sum = 0.0;

  void add(double omega, double value) {
    const double left = 1.0 - omega * omega / (highest * highest);
    if (left > 0.0) sum += value * left * left;
  }
};

}  // namespace

Bending bending(const ModalBody& body, const Poll& poll) {
  if (body.curvature == 0.0 || !body.has_bends) return {};
  const double highest = std::min(enough, body.complete_to * own_length(body) / wave_speed(body));
  Tapered whole{highest}, lower{highest / std::numbers::sqrt2};
  const auto add = [&](double omega, double displacement, double bend, double mass) {
    const double value = displacement * bend / (mass * omega * omega);
    whole.add(omega, value);
    lower.add(omega, value);
  };
  const PointModes modes = point_modes(body, highest);
  for (const KeptMode& mode : modes.kept) add(mode.omega, mode.displacement, mode.bend, modes.mass);
  for (const Mode& mode : sphere::checked_modes(body.poisson, highest, poll)) {  // at the pole: u_r cos θ − u_θ sin θ
    const double wave = mode.order * (mode.order + 1.0);
    add(mode.omega, mode.radial, 0.5 * wave * mode.tangential - (0.25 * wave + 0.5) * mode.radial, -mass_of_sphere);
  }
  return {whole.sum, std::abs(whole.sum - lower.sum)};
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
