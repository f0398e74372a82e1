#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "bodies/plate/plate_waves.hpp"
#include "support/rayleigh_lamb.hpp"

namespace stoss::test {

/// A plate of one material for a sphere, or a strip of one for a disk.
struct Slab {
  double poisson;
  bool in_plane = false;  ///< a strip
  double thickness = 1.3;
  double young = 2.0;
  double density = 0.7;

  [[nodiscard]] bodies::plate::Sheet sheet() const {
    const double nu = poisson;
    const double pressure = in_plane ? young / (1.0 - nu * nu) : young * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
    return {thickness, 0.5 * young / (1.0 + nu), pressure, density};
  }
  [[nodiscard]] bodies::plate::Lamina lamina() const {
    return bodies::plate::lamina(in_plane ? Contour::cylinder : Contour::ball, {sheet()});
  }
  template <typename Real>
  [[nodiscard]] ClosedForm<Real> exact() const {
    return closed_form<Real>(thickness, poisson, young, density, in_plane);
  }
  [[nodiscard]] double shear_speed() const { return std::sqrt(sheet().shear_modulus / density); }
  [[nodiscard]] double pressure_speed() const { return std::sqrt(sheet().pressure_modulus / density); }
};

inline void PrintTo(const Slab& slab, std::ostream* out) {
  *out << (slab.in_plane ? "strip " : "plate ") << slab.poisson;
}

inline const std::vector<Slab> every_slab{{-0.95},  {-0.5},       {0.0},        {0.3},      {0.45},
                                          {0.4999}, {-0.5, true}, {0.33, true}, {0.9, true}};

}  // namespace stoss::test
