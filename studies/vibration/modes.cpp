// Amplitude and phase of the sinusoid of ε, mode by mode, next to those that follow from the share of the energy that
// the mode absorbs in the impact from rest.
#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/quasistatic/rayleigh.hpp"
#include "stoss/restitution/restitution.hpp"
#include "study.hpp"

namespace study {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t strongest = 10;

struct Row {
  const Case& it;
  double speed, mean;
  stoss::ModeEnergy mode;
};

/// φ₀ of a slow sphere, from its contact time and the phase Φ that the stiffness of the contact adds
/// (docs/theory/vibration.md); NaN of a disk.
double slow_phase(const Row& row) {
  if (row.it.body != "sphere") return std::nan("");
  constexpr double poisson = 0.3, modulus = 1.0 / (1.0 - poisson * poisson), mass = 4.0 * pi / 3.0;
  const stoss::quasistatic::SlowImpact slow =
      stoss::quasistatic::slow_impact(stoss::quasistatic::PointLaw::center, poisson, row.speed);
  for (const auto& mode : stoss::bodies::sphere::modes(poisson, 20.0)) {
    if (mode.order != row.mode.order || mode.index != row.mode.index) continue;
    const double contact = 0.5549 * 4.0 * modulus * std::pow(slow.max_radius * mode.radial, 2.0) * slow.max_radius /
                           (mass * mode.omega * row.speed);
    const double turned = 0.5 * (mode.omega * slow.contact_time + contact);
    const double side = std::cos(turned - 1.25 * pi) > 0.0 ? 1.0 : -1.0;
    return std::remainder(-turned - 0.5 * pi * side, 2.0 * pi);
  }
  return std::nan("");
}

std::vector<Row> rows_of(const Case& it, double speed) {
  const stoss::Restitution r = stoss::restitution(it.contact, speed, {.tolerance = 3e-4, .absolute = 0.0});
  std::vector<stoss::ModeEnergy> modes = r.finest.energy.modes;
  std::partial_sort(modes.begin(), modes.begin() + strongest, modes.end(),
                    [](const auto& a, const auto& b) { return a.after > b.after; });
  std::vector<Row> rows;
  for (std::size_t k = 0; k < strongest; ++k) rows.push_back({it, speed, r.restitution.value, modes[k]});
  return rows;
}

}  // namespace

void write_modes(const std::string& name) {
  std::vector<Row> rows;
  for (const double speed : {0.001, 0.01, 0.1}) {
    for (Row& row : rows_of(sphere(), speed)) rows.push_back(row);
  }
  for (const double speed : {0.01, 0.1}) {
    for (Row& row : rows_of(disk(), speed)) rows.push_back(row);
  }
  std::vector<std::string> lines(rows.size());
  on_all_threads(rows.size(), [&](std::size_t i) {
    const Row& row = rows[i];
    const Sinusoid law = sinusoid(row.it, row.speed, row.mode.order, row.mode.index);
    lines[i] = fmt::format("{},{},{},{},{:.6f},{:.5e},{:.6f},{:.1e},{:.6f},{:.4f},{:.4f}\n", row.it.body, row.speed,
                           row.mode.order, row.mode.index, row.mode.omega, row.mode.after, law.amplitude, law.error,
                           std::sqrt(row.mode.after) / row.mean, law.phase, slow_phase(row));
  });
  auto out = fmt::output_file(name);
  out.print(
      "body,speed[c],order,index,omega[c/R],share_from_rest,amplitude,amplitude_error,amplitude_from_share,phase,"
      "phase_of_slow_theory\n");
  for (const std::string& line : lines) out.print("{}", line);
}

}  // namespace study
