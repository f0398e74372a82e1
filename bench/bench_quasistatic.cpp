#include <cmath>
#include <vector>

#include "common.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/quasistatic.hpp"

namespace bench {
namespace {

constexpr auto law = stoss::quasistatic::CompressionLaw::center;
constexpr double slow = 1e-8;

/// Maximum compression by the classical method of Runge and Kutta for δ̈ = −F(δ): the rival of the quadrature.
double stepped_compression(double speed, double step) {
  const auto force = [](double compression) {
    return compression > 0.0 ? stoss::quasistatic::compression_force(law, poisson, compression) : 0.0;
  };
  double x = 0.0, v = speed;
  for (;;) {
    const double a = -force(x);
    const double b = -force(x + 0.5 * step * v);
    const double c = -force(x + 0.5 * step * (v + 0.5 * step * a));
    const double d = -force(x + step * (v + 0.5 * step * b));
    const double next = v + step / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    if (next <= 0.0) return x + 0.5 * v * v / -a;  // the rest of the way at this force
    x += step * (v + step / 6.0 * (a + b + c));
    v = next;
  }
}

}  // namespace

void add_quasistatic() {
  add("slow impact by quadrature, v = 1e-8", [](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(stoss::quasistatic::slow_impact(law, poisson, slow).contact_time);
  });
  add("slow impact in 3000 steps of time, v = 1e-8", [](benchmark::State& state) {
    const stoss::quasistatic::SlowImpact exact = stoss::quasistatic::slow_impact(law, poisson, slow);
    double compression = 0.0;
    for (auto _ : state) compression = stepped_compression(slow, exact.contact_time / 3000.0);
    state.counters["relative error of the compression"] = std::abs(compression / exact.max_compression - 1.0);
  });
  add("Rayleigh's estimate, 1800 modes, v = 1e-8", [](benchmark::State& state) {
    const std::vector<stoss::bodies::disk::Mode> modes = stoss::bodies::disk::modes(poisson, 62.9);
    for (auto _ : state)
      benchmark::DoNotOptimize(stoss::quasistatic::rayleigh(law, poisson, slow, modes).lost_fraction);
    state.counters["modes"] = static_cast<double>(modes.size());
  });
  add("static contact of all modes, δ = 0.03 R", [](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(stoss::quasistatic::static_contact(poisson, 0.03).force);
  });
}

}  // namespace bench
