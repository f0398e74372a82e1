#include "bodies/mode_search.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies {

void check_sum_rule(int order, const Flexibility& all, const Flexibility& kept, double rounding, double tail,
                    double cutoff) {
  const double radial = all.radial - kept.radial;
  const double mixed = all.mixed - kept.mixed;
  const double tangential = all.tangential - kept.tangential;
  const double lowest = 0.5 * (radial + tangential) - std::hypot(0.5 * (radial - tangential), mixed);
  const double least = -rounding * (all.radial + all.tangential);
  if (lowest < least || radial + tangential > 1.5 * tail + 4.0 / (cutoff * cutoff)) {
    throw NotConverged("modes: the static sum rule of order " + std::to_string(order) + " is violated");
  }
}

void refuse_low_cutoff(const std::vector<Mode>& some, double cutoff, double highest) {
  const auto first =
      std::min_element(some.begin(), some.end(), [](const Mode& a, const Mode& b) { return a.omega < b.omega; });
  std::ostringstream allowed;
  allowed.precision(6);
  allowed << first->omega << " to " << highest;
  throw InvalidInput::out_of_range("cutoff", shown(cutoff), allowed.str(),
                                   "below the lowest mode nothing vibrates; 25 to 100 is usual");
}

}  // namespace stoss::bodies
