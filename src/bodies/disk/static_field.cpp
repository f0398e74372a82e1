#include "bodies/disk/static_field.hpp"

namespace stoss::bodies::disk {

StaticField static_field(double poisson, int order, double normal, double shear) {
  StaticField field;
  if (order == 0) {
    field.radial_high = (1.0 - poisson) * normal;
    field.rr_edge = field.pp_edge = normal;
    return field;
  }
  field.rr_edge = normal;
  field.rp_edge = shear;
  field.pp_edge = normal + 2.0 * shear;
  if (order == 1) {
    const double b = 0.25 * (normal + shear), g = normal - shear;
    field.radial_high = (1.0 - 3.0 * poisson) * b + 0.25 * (1.0 + poisson) * g;
    field.tangential_high = (5.0 + poisson) * b - 0.75 * (1.0 + poisson) * g;
    field.radial_low = 0.25 * (field.tangential_high - field.radial_high);
    field.tangential_low = -field.radial_low;
    return field;
  }
  const double n = order;
  const double b = 0.5 * (normal + shear) / (n + 1.0);
  const double below = 0.5 * ((2.0 - n) * shear - n * normal);  // n(n−1)a
  field.radial_low = -(1.0 + poisson) * below / (n - 1.0);
  field.tangential_low = -field.radial_low;
  field.radial_high = -((n - 2.0) + poisson * (n + 2.0)) * b;
  field.tangential_high = (n + 4.0 + poisson * n) * b;
  field.rr_below = -below;
  field.pp_below = field.rp_below = below;
  return field;
}

}  // namespace stoss::bodies::disk
