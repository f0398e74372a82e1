#include "quantity_help.hpp"
#include "stoss/encounter/seismogram.hpp"

namespace stoss {

const Quantities<Seismogram>& seismogram_quantities() {
  using S = Seismogram;
  static const Quantities<S> all{
      {"distance", Dimension::length, "Distance of the receiver along the surface from the first point of contact",
       [](const S& s) { return s.receiver.distance; }},
      {"depth", Dimension::length, "Depth of the receiver below the surface",
       [](const S& s) { return s.receiver.depth; }},
      {"arrival", Dimension::time, "Time of the first wave to the receiver, straight from the contact", &S::arrival},
      {"max_normal", Dimension::length, "Greatest displacement of the receiver along the normal of the surface",
       &S::max_normal},
      {"max_radial", Dimension::length, "Greatest displacement of the receiver along the surface", &S::max_radial},
      {"max_normal_velocity", Dimension::speed, "Greatest velocity of the receiver along the normal of the surface",
       &S::max_normal_velocity},
      {"max_radial_velocity", Dimension::speed, "Greatest velocity of the receiver along the surface",
       &S::max_radial_velocity},
  };
  return all;
}

const Quantities<RecordedInstant>& recorded_instant_quantities() {
  using I = RecordedInstant;
  static const Quantities<I> all{
      {"time", Dimension::time, "Time after unexcited bodies would touch", &I::time},
      {"force", Dimension::force, help::force, &I::force},
      {"normal", Dimension::length, "Displacement of the receiver into the depth", &I::normal},
      {"radial", Dimension::length, "Displacement of the receiver along the surface, away from the contact",
       &I::radial},
      {"normal_velocity", Dimension::speed, "Velocity of the receiver into the depth", &I::normal_velocity},
      {"radial_velocity", Dimension::speed, "Velocity of the receiver along the surface, away from the contact",
       &I::radial_velocity},
  };
  return all;
}

}  // namespace stoss
