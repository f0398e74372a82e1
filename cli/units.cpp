#include "units.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace stoss::cli {
namespace {

struct Names {
  std::string_view disk, rod, si;
};

// In the order of Dimension. Forces and energies of a disk are per thickness.
constexpr std::array<Names, 7> names{{{"", "", ""},
                                      {"R", "L", "m"},
                                      {"R/c", "L/c", "s"},
                                      {"c", "c", "m/s"},
                                      {"c/R", "c/L", "rad/s"},
                                      {"piRE", "EA", "N/m"},
                                      {"mc^2", "mc^2", "J/m"}}};

const Names& of(Dimension dimension) { return names.at(static_cast<std::size_t>(dimension)); }

}  // namespace

std::string Units::own_name(Dimension dimension) const {
  return std::string(rods ? of(dimension).rod : of(dimension).disk);
}

std::string Units::si_name(Dimension dimension) { return std::string(of(dimension).si); }

double Units::scale(Dimension dimension) const {
  switch (dimension) {
    case Dimension::length:
      return si->length;
    case Dimension::time:
      return si->time;
    case Dimension::speed:
      return si->speed;
    case Dimension::frequency:
      return si->frequency;
    case Dimension::force:
      return si->force;
    case Dimension::energy:
      return si->force * si->length;
    case Dimension::none:
      break;
  }
  return 1.0;
}

}  // namespace stoss::cli
