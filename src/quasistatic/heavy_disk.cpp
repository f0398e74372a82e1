#include "stoss/quasistatic/heavy_disk.hpp"

#include <cmath>

#include "check.hpp"

namespace stoss::quasistatic {

PlaneStress heavy_disk_stress(HeavyDiskContact contact, double force, double x, double y) {
  require("force", force, {0.0, max_hertz_force, true, true, "0 to 0.25"}, "weight in units of pi R E");
  constexpr double rounding = 1e-12;
  require("radius", std::hypot(x - 1.0, y), {0.0, 1.0 + rounding, true, true, "0 to 1"},
          "distance of (x, y) from the centre (1, 0) in R; x counts from the point of contact");
  PlaneStress stress;
  if (contact == HeavyDiskContact::point) {
    const double r = std::hypot(x, y);
    require("distance", r, {1e-100, 3.0, true, true, "1e-100 or more"},
            "from the point of contact in R, where the stress is infinite");
    const double c = x / r, s = y / r;
    const double radial = -2.0 * force * c / r;
    stress = {radial * c * c, radial * s * s, radial * c * s};
  } else {
    stress = hertz_stress(force, std::fmax(x, 0.0), y);
  }
  stress.xx += 0.5 * force * x;
  stress.yy += force * (1.0 - 0.5 * x);
  stress.xy += 0.5 * force * y;
  return stress;
}

}  // namespace stoss::quasistatic
