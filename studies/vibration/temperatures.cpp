// ε of warm bodies: all samples of ensembles at rising temperatures, and their mean and spread next to the law of
// small temperatures, σ² = T Σ e_k / 2ε₀² over the modes that are warm.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stoss/vibration/distribution.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double highest = 5.0;  // c/R: modes of nearly all the loss
constexpr long samples = 400;
const std::vector<double> temperatures{1e-4, 1e-3, 1e-2, 0.1, 1.0};

/// Share of the energy that the warm modes absorb in the impact from rest.
double share(const stoss::Restitution& from_rest) {
  double sum = 0.0;
  for (const stoss::ModeEnergy& mode : from_rest.finest.energy.modes) sum += mode.omega <= highest ? mode.after : 0.0;
  return sum;
}

}  // namespace

void write_temperatures(const std::string& name, const std::string& name_of_samples) {
  auto out = fmt::output_file(name), each = fmt::output_file(name_of_samples);
  out.print("# {} modes of the sphere and {} of the disk, those up to {} c/R, are warm; {} samples each.\n",
            thermal(sphere().contact, 1.0, highest).size(), thermal(disk().contact, 1.0, highest).size(), highest,
            samples);
  out.print(
      "body,speed[c],temperature,restitution_from_rest,mean,mean_statistical_error,mean_numerical_error,"
      "standard_deviation,law,least,greatest,share_above_one,not_converged\n");
  each.print("body,temperature,restitution\n");
  for (const auto& [it, speed] : {std::pair<const Case&, double>{sphere(), 0.01}, {disk(), 0.1}}) {
    const stoss::Restitution rest = stoss::restitution(it.contact, speed, {.tolerance = 3e-4, .absolute = 0.0});
    for (const double temperature : temperatures) {
      const double law = std::sqrt(0.5 * temperature * share(rest)) / rest.restitution.value;
      const stoss::Spectrum spectrum = stoss::thermal(it.contact, temperature, highest);
      const std::vector<stoss::Sample> found = stoss::restitution_distribution(
          it.contact, speed, spectrum, {.samples = samples, .seed = 16, .error = 0.2 * law});
      const stoss::DistributionSummary all = stoss::summary(found);
      out.print("{},{},{},{:.7f},{:.7f},{:.1e},{:.1e},{:.4e},{:.4e},{:.6f},{:.6f},{:.4f},{}\n", it.body, speed,
                temperature, rest.restitution.value, all.restitution.value, all.restitution.statistical_error,
                all.restitution.numerical_error, all.standard_deviation, law, all.least, all.greatest,
                all.share_above_one, all.missing + all.not_converged);
      for (const stoss::Sample& sample : found) {
        each.print("{},{},{:.6f}\n", it.body, temperature, sample.restitution.value);
      }
    }
  }
}

}  // namespace study
