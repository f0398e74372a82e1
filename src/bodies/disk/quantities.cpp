#include "stoss/bodies/disk/quantities.hpp"

namespace stoss::bodies::disk {

using enum Dimension;

const Quantities<Mode>& mode_quantities() {
  const auto family_name = [](const Mode& mode) {
    return std::string(family(mode) == ModeFamily::radial ? "radial" : "tangential");
  };
  static const Quantities<Mode> all{
      {"order", none, &Mode::order},   {"index", none, &Mode::index},           {"omega", frequency, &Mode::omega},
      {"radial", none, &Mode::radial}, {"tangential", none, &Mode::tangential}, {"family", none, family_name},
  };
  return all;
}

}  // namespace stoss::bodies::disk
