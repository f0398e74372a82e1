#include "stoss/bodies/sphere/quantities.hpp"

namespace stoss::bodies::sphere {

using enum Dimension;

const Quantities<Mode>& mode_quantities() {
  static const Quantities<Mode> all{
      {"order", none, &Mode::order},   {"index", none, &Mode::index},           {"omega", frequency, &Mode::omega},
      {"radial", none, &Mode::radial}, {"tangential", none, &Mode::tangential},
  };
  return all;
}

}  // namespace stoss::bodies::sphere
