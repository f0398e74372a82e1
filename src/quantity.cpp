#include "stoss/quantity.hpp"

#include <array>
#include <cstddef>

namespace stoss {
namespace {

struct Names {
  std::string_view dimension;
  std::array<std::string_view, 6> units;  // in the order of UnitSystem
};

// In the order of Dimension.
constexpr std::array<Names, 10> names{{{"", {"", "", "", "", "", ""}},
                                       {"length", {"R", "L", "m", "m", "R", "m"}},
                                       {"inverse length", {"1/R", "1/L", "1/m", "1/m", "1/R", "1/m"}},
                                       {"time", {"R/c", "L/c", "s", "s", "R/c", "s"}},
                                       {"speed", {"c", "c", "m/s", "m/s", "c", "m/s"}},
                                       {"frequency", {"c/R", "c/L", "rad/s", "rad/s", "c/R", "rad/s"}},
                                       {"force", {"piRE", "EA", "N/m", "N", "mc^2/R", "N"}},
                                       {"energy", {"mc^2", "mc^2", "J/m", "J", "mc^2", "J"}},
                                       {"acceleration", {"c^2/R", "c^2/L", "m/s^2", "m/s^2", "c^2/R", "m/s^2"}},
                                       {"momentum", {"mc", "mc", "N s/m", "N s", "mc", "N s"}}}};

const Names& of(Dimension dimension) { return names.at(static_cast<std::size_t>(dimension)); }

}  // namespace

std::string_view unit_name(Dimension dimension, UnitSystem system) {
  return of(dimension).units.at(static_cast<std::size_t>(system));
}

std::string_view dimension_name(Dimension dimension) { return of(dimension).dimension; }

double unit_in_si(Dimension dimension, const Scales& scales) {
  switch (dimension) {
    case Dimension::length:
      return scales.length;
    case Dimension::inverse_length:
      return 1.0 / scales.length;
    case Dimension::time:
      return scales.time;
    case Dimension::speed:
      return scales.speed;
    case Dimension::frequency:
      return scales.frequency;
    case Dimension::force:
      return scales.force;
    case Dimension::energy:
      return scales.force * scales.length;
    case Dimension::acceleration:
      return scales.speed / scales.time;
    case Dimension::momentum:
      return scales.force * scales.time;
    case Dimension::none:
      break;
  }
  return 1.0;
}

}  // namespace stoss
