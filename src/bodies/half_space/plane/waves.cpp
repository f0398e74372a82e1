#include "bodies/half_space/plane/waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "bodies/half_space/surface_waves.hpp"
#include "numeric/quadrature.hpp"

namespace stoss::bodies::half_space {
namespace {

/// The kinds of the two directions by themselves, each with all of its response.
struct Kinds {
  Spectrum normal, along;

  explicit Kinds(const LambKernel& kernel)
      : normal(spectra(kernel, Direction::normal).front()), along(spectra(kernel, Direction::along).front()) {}
};

/// √(ρ ρ_h) with the sign of −ρ_X.
double mixed_density(const LambKernel& kernel, const Kinds& kinds, double x) {
  const double density = std::sqrt(kinds.normal.density(kernel, x) * kinds.along.density(kernel, x));
  return x * x < 2.0 ? density : -density;
}

/// ∫√(ρ ρ_h)/x² and /x⁴ from x on: up to the speed of pressure waves, with roots at both ends.
Rest mixed_beyond(const LambKernel& kernel, const Kinds& kinds, double x) {
  constexpr int nodes = 64;
  const double from = std::max(x, 1.0), length = 1.0 / std::sqrt(kernel.squared_ratio) - from;
  Rest rest;
  if (length <= 0.0) return rest;
  const auto& rule = numeric::gauss_legendre(nodes);
  const double quarter = 0.25 * std::numbers::pi;
  for (std::size_t i = 0; i < rule.node.size(); ++i) {
    const double angle = quarter * (1.0 + rule.node[i]), sine = std::sin(angle);
    const double at = from + length * sine * sine;
    const double weight = mixed_density(kernel, kinds, at) * length * std::sin(2.0 * angle) * quarter * rule.weight[i];
    rest.compliance += weight / (at * at);
    rest.moment += weight / (at * at * at * at);
  }
  return rest;
}

PlaneWaves waves_along_plane(const Medium& medium, const Kinds& kinds, const WaveNumber& number, double cutoff,
                             double time) {
  const LambKernel& kernel = medium.kernel;
  const double unit = medium.shear_speed * number.k;  // ω of x = 1
  const double compliance = medium.compliance(number.k) * number.weight, end = cutoff / unit;
  PlaneWaves waves{number.k, number.weight, {}, {}, {}, {}, {}};
  const auto keep = [&](double x, double normal, double along) {
    const double scale = std::sqrt(compliance) * unit;
    waves.omega.push_back(std::min(unit * x, cutoff));  // rounding
    waves.normal.push_back(scale * normal);
    waves.along.push_back(scale * along);
  };
  keep(kernel.rayleigh_root, std::sqrt(kinds.normal.rayleigh_weight), std::sqrt(kinds.along.rayleigh_weight));
  const Continuum normal{kernel, kinds.normal}, along{kernel, kinds.along};
  const Piece of_normal = normal.up_to(end, unit * time), of_along = along.up_to(end, unit * time);
  for (std::size_t i = 0; i < of_normal.x.size(); ++i) {
    const double x = of_normal.x[i], first = std::sqrt(of_normal.weight[i]), second = std::sqrt(of_along.weight[i]);
    if (x < normal.pressure_speed()) {
      keep(x, first, x * x < 2.0 ? second : -second);
    } else {
      keep(x, first, 0.0);
      keep(x, 0.0, second);
    }
  }
  const Rest rest = normal.beyond(end), rest_along = along.beyond(end), mixed = mixed_beyond(kernel, kinds, end);
  const double moment = compliance / (unit * unit);
  waves.residual_compliance = {compliance * rest.compliance, compliance * mixed.compliance,
                               compliance * rest_along.compliance};
  waves.residual_second_moment = {moment * rest.moment, moment * mixed.moment, moment * rest_along.moment};
  return waves;
}

}  // namespace

std::vector<PlaneWaves> plane_waves(const Medium& medium, double cutoff, double duration, const Poll& poll) {
  const Kinds kinds(medium.kernel);
  std::vector<PlaneWaves> all;
  for (const WaveNumber& number : wave_numbers(medium, cutoff, duration)) {
    if (poll) poll();
    all.push_back(waves_along_plane(medium, kinds, number, cutoff, share_of_duration * duration));
  }
  return all;
}

Flexibility plane_compliance(const Medium& medium, double wave_number) {
  const double compliance = medium.compliance(wave_number);
  return {compliance, compliance * medium.kernel.squared_ratio, compliance};
}

Flexibility plane_second_moment(const Medium& medium, double wave_number) {
  const double unit = medium.shear_speed * wave_number, scale = medium.compliance(wave_number) / (unit * unit);
  const double eta = medium.kernel.squared_ratio;
  const Kinds kinds(medium.kernel);
  return {scale * kinds.normal.second_moment, scale * (1.0 + eta * eta) / (4.0 * (1.0 - eta)),
          scale * kinds.along.second_moment};
}

}  // namespace stoss::bodies::half_space
