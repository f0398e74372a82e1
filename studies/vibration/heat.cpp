// Mean energy that impacts give to translation, against the ratio of the temperatures of vibration and translation.
//
// Of a body at a wall in equilibrium ½mv² is distributed before its impacts as the energy of a mode, exponentially. All
// modes of the contact are warm and its static tail keeps all energy, so that equal temperatures are an equilibrium.
#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/impact/impact.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr std::size_t pairs = 1500;  // of samples of opposite coordinates and momenta, in which the first order cancels
constexpr std::uint64_t seed = 16;
constexpr double speed = 0.1;  // of ½mv² = the temperature of translation
const std::vector<double> ratios{0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0};

/// Over a number of values.
struct Mean {
  double sum = 0.0, squares = 0.0, count = 0.0;
  void add(double value) { sum += value, squares += value * value, count += 1.0; }
  [[nodiscard]] double value() const { return sum / count; }
  [[nodiscard]] double error() const { return std::sqrt((squares / count - value() * value()) / (count - 1.0)); }
};

/// Energy that an impact gives to translation, over the temperature of translation.
double gain(const stoss::Contact& contact, double energy, const stoss::Vibration& vibration) {
  const double v = speed * std::sqrt(energy);
  stoss::ImpactOptions options{.start = stoss::approach(contact, v, vibration)};
  options.resolution.tail = stoss::Tail::quasistatic;
  return -energy * stoss::impact(contact, v, options).lost_fraction;
}

}  // namespace

void write_heat(const std::string& name) {
  auto out = fmt::output_file(name);
  out.print("# Units of energy: the temperature of translation, that of {} c; {} pairs of opposite samples.\n", speed,
            pairs);
  out.print(
      "body,modes,ratio,gain,gain_error,half_mean_square,half_mean_square_error,fluctuation,fluctuation_"
      "error\n");
  for (const Case* it : {&sphere(), &disk()}) {
    const stoss::Contact& contact = it->contact.at(0);
    const stoss::Spectrum modes = stoss::thermal(it->contact, 1.0, contact.cutoff);
    for (const double ratio : ratios) {
      std::vector<double> plus(pairs), minus(pairs);
      on_all_threads(pairs, [&](std::size_t i) {
        const double energy = -std::log((static_cast<double>(i) + 0.5) / pairs);  // evenly through the distribution
        stoss::Spectrum spectrum = modes;
        for (stoss::MeanEnergy& mode : spectrum) mode.energy = ratio / energy;
        stoss::Vibration vibration = stoss::draw(spectrum, seed, i);
        plus[i] = gain(contact, energy, vibration);
        for (stoss::Oscillation& mode : vibration) mode.phase += std::numbers::pi;
        minus[i] = gain(contact, energy, vibration);
      });
      Mean mean, square, fluctuation;
      for (std::size_t i = 0; i < pairs; ++i) {
        const auto weight = [&](double given) { return std::exp(given * (1.0 / ratio - 1.0)); };
        mean.add(0.5 * (plus[i] + minus[i]));
        square.add(0.25 * (plus[i] * plus[i] + minus[i] * minus[i]));
        if (ratio > 0.0) fluctuation.add(0.5 * (weight(plus[i]) + weight(minus[i])));
      }
      out.print("{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},", it->body, modes.size(), ratio, mean.value(), mean.error(),
                square.value(), square.error());
      if (ratio > 0.0) {
        out.print("{:.5f},{:.5f}\n", fluctuation.value(), fluctuation.error());
      } else {
        out.print(",\n");
      }
    }
  }
}

}  // namespace study
