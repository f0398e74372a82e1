#pragma once

#include <ostream>

#include "stoss/bodies/disk.hpp"
#include "stoss/contact/wall.hpp"

/// How GoogleTest names parameters of these types; without it, by their bytes.
namespace stoss {

inline void PrintTo(const Disk& disk, std::ostream* out) {
  *out << "poisson " << disk.poisson << ", radius " << disk.radius << ", young " << disk.young << ", density "
       << disk.density;
}

inline void PrintTo(Tail tail, std::ostream* out) {
  *out << (tail == Tail::radiating ? "radiating" : tail == Tail::none ? "no tail" : "quasistatic");
}

}  // namespace stoss
