#include "stoss/quasistatic/rayleigh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "quasistatic/driven_modes.hpp"
#include "quasistatic/pulse.hpp"

namespace stoss::quasistatic {
namespace {

constexpr std::size_t lanes = 4;  // sums side by side: their order is fixed, and they need not wait for one another

template <std::size_t size>
constexpr std::array<double, size> inverse(std::array<double, size> values) {
  for (double& value : values) value = 1.0 / value;
  return values;
}

/// cos x for 0 ≤ x < 1e6, to 1e-15 plus the rounding of x; without branches, in a loop several times faster than the
/// library's: 2 cos²(x/2) − 1, with the series of the cosine after whole turns are taken off.
double cosine(double x) {
  constexpr double to_integer = 0x1.8p52;           // what is added to it loses its fraction
  constexpr double per_turn = 0.15915494309189535;  // 1/2π
  constexpr double turn_high = 0x1.921fb5p+2;       // 2π in two parts, the first with few bits
  constexpr double turn_low = 0x1.110b4611a6263p-24;
  constexpr std::array factorials{1.1240007277776077e21,
                                  2.43290200817664e18,
                                  6.402373705728e15,
                                  2.0922789888e13,
                                  8.71782912e10,
                                  4.790016e8,
                                  3.6288e6,
                                  40320.0,
                                  720.0,
                                  24.0,
                                  2.0};  // 22!, 20! … 2!
  constexpr auto series = inverse(factorials);
  const double turns = (x * per_turn + to_integer) - to_integer;
  const double half = 0.5 * ((x - turns * turn_high) - turns * turn_low);
  const double square = half * half;
  double sum = 0.0;
  for (const double coefficient : series) sum = coefficient - square * sum;
  const double result = 1.0 - square * sum;
  return 2.0 * result * result - 1.0;
}

/// ∫F cos ωt dt / v
double amplitude(const ForcePulse::Nodes& nodes, double omega) {
  std::array<double, lanes> sum{};
  for (std::size_t i = 0; i < nodes.time.size(); i += lanes) {
    for (std::size_t k = 0; k < lanes; ++k) sum[k] += nodes.weight[i + k] * cosine(omega * nodes.time[i + k]);
  }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

ForcePulse::Nodes padded(ForcePulse::Nodes nodes) {
  const std::size_t size = (nodes.time.size() + lanes - 1) / lanes * lanes;
  nodes.time.resize(size, 0.0);
  nodes.weight.resize(size, 0.0);
  return nodes;
}

}  // namespace

RayleighEstimate rayleigh(CompressionLaw law, double poisson, double speed, const std::vector<bodies::Mode>& modes,
                          const Poll& poll) {
  RayleighEstimate result;
  result.impact = slow_impact(law, poisson, speed);
  require_modes(modes, "edge amplitude C");
  const ForcePulse pulse = slow_pulse(law, poisson, speed);
  for (const bodies::Mode& mode : modes) result.cutoff = std::max(result.cutoff, mode.omega);
  const ForcePulse::Nodes nodes = padded(pulse.nodes(result.cutoff));
  const auto integral = [&](const bodies::Mode& mode) { return amplitude(nodes, mode.omega); };
  drive(modes, integral, pulse.max_force_rate(), second_order_factor, poll, result);
  return result;
}

}  // namespace stoss::quasistatic
