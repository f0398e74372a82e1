#include "stoss/impact/sound.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "check.hpp"
#include "impact/inputs.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

/// Samples after which a phase is computed anew, so that rounding does not add up.
constexpr std::size_t block = 256;

void add_partial(std::complex<double> amplitude, double omega, double decay, double interval,
                 std::vector<double>& sum) {
  const std::complex<double> rate(-decay, omega), turn = std::exp(rate * interval);
  for (std::size_t begin = 0; begin < sum.size(); begin += block) {
    std::complex<double> now = amplitude * std::exp(rate * (interval * static_cast<double>(begin)));
    for (std::size_t i = begin; i < std::min(sum.size(), begin + block); ++i) {
      sum[i] += now.real();
      now *= turn;
    }
  }
}

}  // namespace

std::vector<double> sound(const Contact& contact, const Impact& impact, const SoundOptions& options, const Poll& poll) {
  const Body& body = *required_body(contact, options.body);
  if (!is_whole(body)) {
    throw InvalidInput::out_of_range("of", "'" + body.name + "'", "a body that is there as a whole",
                                     "the waves of this one run away");
  }
  require("interval", options.interval, {0.0, 1e12, false, true, "above 0, to 1e12"}, "R/c, between two samples");
  if (options.quality) require("quality", *options.quality, {0.5, 1e12, false, true, "above 0.5, to 1e12"}, "of modes");
  const State& last = impact.final_state;
  if (last.coordinate.size() != mode_count(contact)) {
    throw InvalidInput::out_of_range("body", "'" + name(contact) + "' with other modes", "the one of the impact");
  }
  const std::vector<double> shape = body.surface({.radius = 1.0, .spacing = 0.0, .count = 1}).shape;
  std::vector<double> sum(options.count, 0.0);
  const std::size_t first = options.body == 0 ? 0 : contact.first_groups;
  std::size_t k = 0;
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const bool of_body = (g < contact.first_groups) == (options.body == 0);
    const double mass = modal_mass(contact, g);
    for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
      const double omega = contact.groups[g].omega[l];
      if (!of_body || omega * options.interval >= std::numbers::pi) continue;
      if (poll) poll();
      const ModeGroup& own = body.groups[g - first];
      const double displacement = own.upper[l] * shape[own.upper_row] + own.lower[l] * shape[own.lower_row];
      const double decay = options.quality ? 0.5 * omega / *options.quality : free_mode(contact, g, l).gamma;
      const std::complex<double> amplitude(last.momentum[k] / mass, omega * last.coordinate[k]);
      add_partial(displacement * amplitude, omega, decay, options.interval, sum);
    }
  }
  return sum;
}

}  // namespace stoss
