#include "bodies/half_space/surface_waves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bodies/half_space/continuum.hpp"

namespace stoss::bodies::half_space {
namespace {

SurfaceWaves waves_of(const Medium& medium, double wave_number, double weight, double cutoff, double time) {
  const double unit = medium.shear_speed * wave_number;  // ω of x = 1
  const double whole = medium.compliance(wave_number) * weight;
  SurfaceWaves waves{wave_number, weight, {}, {}, 0.0, 0.0};
  for (const Spectrum& spectrum : medium.spectra) {
    const double compliance = whole * spectrum.share;
    const auto keep = [&](double x, double share) {
      waves.omega.push_back(std::min(unit * x, cutoff));  // rounding
      waves.strength.push_back(compliance * unit * unit * share);
    };
    if (spectrum.rayleigh_weight > 0.0) keep(medium.kernel.rayleigh_root, spectrum.rayleigh_weight);
    const double end = cutoff / unit;
    const Continuum its{medium.kernel, spectrum};
    const Piece kept = its.up_to(end, unit * time);
    for (std::size_t i = 0; i < kept.x.size(); ++i) keep(kept.x[i], kept.weight[i]);
    const Rest rest = its.beyond(end);
    waves.residual_compliance += compliance * rest.compliance;
    waves.residual_second_moment += compliance * rest.moment / (unit * unit);
  }
  return waves;
}

}  // namespace

std::vector<SurfaceWaves> surface_waves(const Medium& medium, double cutoff, double duration, const Poll& poll) {
  const double time = share_of_duration * duration;
  std::vector<SurfaceWaves> all;
  for (const auto& [k, weight] : wave_numbers(medium, cutoff, duration)) {
    if (poll) poll();
    all.push_back(waves_of(medium, k, weight, cutoff, time));
  }
  return all;
}

double cutoff_of_count(const Medium& medium, double count, double duration) {
  // count = (2.3 turns + wave_numbers)(turns + nodes), turns = ¼ H ω
  const double nodes = 5.0 / std::sqrt(medium.kernel.squared_ratio) + 16.0;
  constexpr double surplus = 2.3, wave_numbers = 24.0;
  const double half = 0.5 * (nodes + wave_numbers / surplus);
  const double turns = std::sqrt(half * half + (count - wave_numbers * nodes) / surplus) - half;
  return 4.0 * turns / (share_of_duration * duration);
}

}  // namespace stoss::bodies::half_space
