#include "stoss/impact/resolution.hpp"

#include <algorithm>
#include <cmath>

#include "check.hpp"
#include "contact/demands.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {

FixedResolution fixed_resolution(const Contact& contact, double speed, const Resolution& asked) {
  require_speed(speed);
  if (asked.tail == Tail::none && contact.asperities == 0.0) {
    throw InvalidInput::out_of_range("tail", "none at smooth faces", "static or radiating",
                                     "the modes above the cutoff answer where no point passes");
  }
  if (contact.unbounded && mach_number(contact, speed) > 1.0) {
    throw InvalidInput::out_of_range("speed", shown(speed) + " c at so soft a body",
                                     "up to " + shown_most(speed / mach_number(contact, speed)),
                                     "the wave speed of the softer body");
  }
  const auto& [step, nodes, asked_half_width, tail] = asked;
  if (step) {
    constexpr double rounding = 1e-12;
    const double least = 5e-6 * std::min(1.0, time_scale(contact));
    require("step", *step,
            {least, (1.0 + rounding) / contact.cutoff, true, true,
             "5e-6 (of two bodies, less where they meet faster) to 1/cutoff"},
            "time step in R/c; 0.25/cutoff is usual");
  }
  if (asked_half_width) {
    require("half_width", *asked_half_width,
            {0.0, std::max(greatest_half_width(contact), 1e-300), false, true,
             "above 0 and up to the end of the edge that can touch"},
            "half-width of the contact grid in R");
  }
  const double half_width = asked_half_width ? *asked_half_width : initial_half_width(contact, speed);
  if (nodes) {
    const long fewest = !has_single_point(contact) ? std::max(16, nyquist_nodes(contact, half_width)) : 1;
    require("nodes", static_cast<long>(*nodes), fewest, most_nodes, "contact nodes; as many as the kept orders need");
  }
  return {step ? *step : resolving_step(contact, tail, speed), nodes ? *nodes : nodes_within(contact, tail, half_width),
          half_width, tail};
}

}  // namespace stoss
