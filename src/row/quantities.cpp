#include "stoss/row/quantities.hpp"

#include "quantity_help.hpp"

namespace stoss {

using enum Dimension;

const Quantities<RowBody>& row_body_quantities() {
  using B = RowBody;
  static const Quantities<B> all{
      {"number", none, "Number of the body from the left, from 0", &B::number},
      {"velocity", Dimension::speed, "Velocity to the right before", &B::velocity},
      {"velocity_after", Dimension::speed, "Velocity to the right after the last contact", &B::velocity_after},
  };
  return all;
}

const Quantities<RowContact>& row_contact_quantities() {
  using C = RowContact;
  static const Quantities<C> all{
      {"left", none, "Number of the body on the left of the contact, -1 for a wall", &C::left},
      {"first_touch", time, "Time of the first force, after the first of the row", &C::first_touch},
      {"last_touch", time, "Time of the last force", &C::last_touch},
      {"touches", none, "Number of separate periods of contact", &C::touches},
      {"max_force", force, help::max_force, &C::max_force},
      {"impulse", momentum, "Momentum that the contact transfers", &C::impulse},
      {"max_compression", length, "Maximum compression", &C::max_compression},
  };
  return all;
}

const Quantities<RowResult>& row_quantities() {
  using R = RowResult;
  static const Quantities<R> all{
      {"translation", none, "Share of the kinetic energy of the centres that is left to them", &R::translation},
      {"vibration", none, "The same in the vibration of the bodies and in waves that run away",
       [](const R& r) { return r.finest.energy.vibration; }},
      {"dissipated", none, help::dissipated, [](const R& r) { return r.finest.energy.dissipated; }},
      {"yielded", none, help::yielded, [](const R& r) { return r.finest.energy.yielded; }},
      {"unresolved", none, "Share of the initial energy that modes above the cutoff have taken",
       [](const R& r) { return r.finest.energy.unresolved; }},
      {"duration", time, "Time from the first contact until no bodies can meet again, as far as computed",
       [](const R& r) { return r.finest.time; }},
      {"cutoff", frequency, help::cutoff, [](const R& r) { return r.finest.cutoff; }},
      {"runs", none, "Number of motions that were computed",
       [](const R& r) { return static_cast<long>(r.cutoffs.size()); }},
      {"steps", none, "Number of time steps, of all motions that were computed", &R::steps},
      {"energy_error", none, help::energy_error, [](const R& r) { return r.finest.energy_error; }},
      {"momentum_error", none, help::momentum_error, [](const R& r) { return r.finest.momentum_error; }},
      {"converged", none, help::converged, &R::converged},
      {"strain", none, help::strain, [](const R& r) { return r.finest.strain; }},
      {"beyond_small_strain", none, help::beyond_small_strain,
       [](const R& r) { return r.finest.strain > small_strain_limit; }},
  };
  return all;
}

}  // namespace stoss
