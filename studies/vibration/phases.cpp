// ε against the phase of one mode that vibrates before the impact, next to its sinusoid of small energies.
#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "stoss/restitution/restitution.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double small_energy = 1e-3;  // a√E is measured to 1e-3, what is of higher order is E³ᐟ² of it
constexpr int phases = 36;
const std::vector<double> energies{0.01, 0.1, 1.0};

struct Curve {
  const Case& it;
  double speed;
  int order;
};

}  // namespace

Sinusoid sinusoid(const Case& it, double speed, int order, int index) {
  Sinusoid result;
  result.mean = stoss::restitution(it.contact, speed, {.tolerance = 3e-4, .absolute = 0.0}).restitution.value;
  double value[4] = {};
  for (int k = 0; k < 4; ++k) {
    const stoss::Restitution r = stoss::restitution(
        it.contact, speed,
        {.tolerance = 3e-4, .absolute = 1e-7, .vibration = {{0, order, index, small_energy, 0.5 * pi * k}}});
    value[k] = r.restitution.value;
    result.error = std::max(result.error, r.restitution.error / std::sqrt(small_energy));
  }
  const double in_phase = 0.5 * (value[0] - value[2]), out_of_phase = 0.5 * (value[1] - value[3]);
  result.amplitude = std::hypot(in_phase, out_of_phase) / std::sqrt(small_energy);
  result.phase = std::atan2(out_of_phase, in_phase);
  return result;
}

void write_phases(const std::string& name) {
  const std::vector<Curve> curves{{sphere(), 0.01, 2}, {disk(), 0.1, 2}};
  const std::size_t of_curve = energies.size() * (phases + 1);
  std::vector<Sinusoid> sinusoids(curves.size());
  on_all_threads(curves.size(),
                 [&](std::size_t c) { sinusoids[c] = sinusoid(curves[c].it, curves[c].speed, curves[c].order, 0); });
  std::vector<std::string> lines(curves.size() * of_curve);
  on_all_threads(lines.size(), [&](std::size_t i) {
    const Curve& curve = curves[i / of_curve];
    const Sinusoid& law = sinusoids[i / of_curve];
    const double energy = energies[i % of_curve / (phases + 1)];
    const double phase = 2.0 * pi * static_cast<double>(i % (phases + 1)) / phases;
    const stoss::Restitution r = stoss::restitution(
        curve.it.contact, curve.speed, {.absolute = 1e-4, .vibration = {{0, curve.order, 0, energy, phase}}});
    lines[i] = fmt::format("{},{},{},0,{},{:.6f},{:.7f},{:.1e},{:.7f},{}\n", curve.it.body, curve.speed, curve.order,
                           energy, phase, r.restitution.value, r.restitution.error,
                           law.mean + law.amplitude * std::sqrt(energy) * std::cos(phase - law.phase), r.converged);
  });
  auto out = fmt::output_file(name);
  out.print("body,speed[c],order,index,energy,phase,restitution,restitution_error,sinusoid,converged\n");
  for (const std::string& line : lines) out.print("{}", line);
}

}  // namespace study
