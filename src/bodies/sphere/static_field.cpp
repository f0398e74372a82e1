#include "bodies/sphere/static_field.hpp"

namespace stoss::bodies::sphere {
namespace {

/// n = 1: a translation, and the field r² that the inertia of the accelerated sphere and the load make.
StaticField accelerated(double poisson, double normal, double shear) {
  const double load = (normal + 2.0 * shear) / (1.0 - poisson);
  const double s = 0.1 * load * (1.0 + poisson) * (1.0 - 2.0 * poisson);
  const double a = 0.5 * shear - s / (1.0 + poisson);
  StaticField field;
  field.radial_low = field.tangential_low = -(2.0 * a + s);
  field.radial_high = 2.0 * (4.0 * poisson - 1.0) * a + 3.0 * s;
  field.tangential_high = (6.0 - 4.0 * poisson) * a + s;
  field.rr_edge = normal;
  field.rt_edge = shear;
  field.hoop_edge = (2.0 * s - (8.0 + 8.0 * poisson) * a) / (1.0 + poisson) + poisson * load;
  return field;
}

}  // namespace

StaticField static_field(double poisson, int order, double normal, double shear) {
  StaticField field;
  if (order == 0) {
    field.radial_high = (1.0 - 2.0 * poisson) * normal;
    field.rr_edge = field.hoop_edge = normal;
    return field;
  }
  if (order == 1) return accelerated(poisson, normal, shear);
  const double n = order;
  const double soft = 1.0 + poisson;
  const double a = -soft * (normal - n * shear) / (2.0 * (n * n + n + 1.0 + (2.0 * n + 1.0) * poisson));
  const double low = soft * shear - a * (n * n + 2.0 * n - 1.0 + 2.0 * poisson);  // (n−1)B
  const double b = low / (n - 1.0);
  field.radial_low = n * b;
  field.tangential_low = b;
  field.radial_high = (n + 1.0) * (n - 2.0 + 4.0 * poisson) * a;
  field.tangential_high = (n + 5.0 - 4.0 * poisson) * a;
  field.rr_below = n * low / soft;
  field.rr_edge = normal;
  field.rt_below = field.hoop_below = low / soft;
  field.rt_edge = shear;
  field.hoop_edge = shear - a * (4.0 * n + 6.0 + poisson * n * (4.0 * n + 6.0)) / soft;
  field.bend_below = b / soft;
  field.bend_edge = (soft * shear + 2.0 * a * (n - 2.0 - poisson * (2.0 * n - 1.0))) / (soft * (n - 1.0));
  return field;
}

}  // namespace stoss::bodies::sphere
