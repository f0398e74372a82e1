#include "stoss/impact/quantities.hpp"

#include <algorithm>

#include "quantity_help.hpp"

namespace stoss {

using enum Dimension;

const Quantities<Impact>& impact_quantities() {
  using I = Impact;
  static const Quantities<I> all{
      {"restitution", none, help::restitution, &I::restitution},
      {"lost_fraction", none, help::lost_fraction, &I::lost_fraction},
      {"translation", none, help::translation, [](const I& i) { return i.energy.translation; }},
      {"vibration", none, help::vibration, [](const I& i) { return i.energy.vibration; }},
      {"dissipated", none, help::dissipated, [](const I& i) { return i.energy.dissipated; }},
      {"yielded", none, help::yielded, [](const I& i) { return i.energy.yielded; }},
      {"unresolved", none, help::unresolved, [](const I& i) { return i.energy.unresolved; }},
      {"lost_to_first", none, help::lost_to_first, [](const I& i) { return i.energy.lost_to_first; }},
      {"lost_to_second", none, help::lost_to_second, [](const I& i) { return i.energy.lost_to_second; }},
      {"contact_time", time, help::contact_time, &I::contact_time},
      {"impulse_time", time, help::impulse_time, &I::impulse_time},
      {"contacts", none, help::contacts, &I::contacts},
      {"max_force", force, help::max_force, &I::max_force},
      {"max_compression", length, help::max_compression, &I::max_compression},
      {"max_half_width", length, help::max_half_width, &I::max_half_width},
      {"dent", length, help::dent, &I::dent},
      {"cutoff", frequency, help::cutoff, &I::cutoff},
      {"modes", none, help::modes, [](const I& i) { return static_cast<long>(i.energy.modes.size()); }},
      {"step", time, help::step, [](const I& i) { return i.resolution.step; }},
      {"nodes", none, help::nodes, [](const I& i) { return i.resolution.nodes; }},
      {"half_width", length, help::half_width, [](const I& i) { return i.resolution.half_width; }},
      {"steps", none, help::steps, &I::steps},
      {"energy_error", none, help::energy_error, &I::energy_error},
      {"momentum_error", none, help::momentum_error, &I::momentum_error},
      {"stays", none, help::stays, [](const I& i) { return i.remaining > 0.0; }},
      {"strain", none, help::strain, &I::strain},
      {"beyond_small_strain", none, help::beyond_small_strain, &I::beyond_small_strain},
  };
  return all;
}

std::string note_of_staying() {
  return "the body stays: the plate is infinite and never returns what it takes, so eps is 0; waves from the rim of "
         "a real one may throw it off (python -m stoss.modal --plate LxWxH --edge clamped)";
}

std::string note_of_a_plate(double restitution) {
  constexpr double little = 0.2;
  if (!(restitution > 0.0 && restitution < little)) return {};
  return "eps is small: the plate is infinite and never returns what it takes; waves from the rim of a real one may "
         "throw the body off with much more (python -m stoss.modal --plate LxWxH --edge clamped)";
}

const Quantities<EnergyLedger>& ledger_quantities() {
  using L = EnergyLedger;
  static const Quantities<L> all{
      {"translation", none, help::translation, &L::translation}, {"vibration", none, help::vibration, &L::vibration},
      {"dissipated", none, help::dissipated, &L::dissipated},    {"yielded", none, help::yielded, &L::yielded},
      {"unresolved", none, help::unresolved, &L::unresolved},    {"stored", none, help::stored, &L::stored},
  };
  return all;
}

const Quantities<ObliqueImpact>& oblique_impact_quantities() {
  using O = ObliqueImpact;
  static const Quantities<O> all{
      {"restitution", none, help::normal_restitution, &O::restitution},
      {"tangential_restitution", none, help::tangential_restitution, &O::tangential_restitution},
      {"sliding", speed, help::sliding, &O::sliding},
      {"sliding_after", speed, help::sliding_after, &O::sliding_after},
      {"tangential_after", speed, help::tangential_after, &O::tangential_after},
      {"spin_after", frequency, help::spin_after, &O::spin_after},
      {"second_spin_after", frequency, help::second_spin_after, &O::second_spin_after},
      {"contact_time", time, help::contact_time, [](const O& o) { return o.normal.contact_time; }},
      {"max_force", force, help::max_force, [](const O& o) { return o.normal.max_force; }},
      {"max_compression", length, help::max_compression, [](const O& o) { return o.normal.max_compression; }},
      {"max_half_width", length, help::max_half_width, [](const O& o) { return o.normal.max_half_width; }},
      {"cutoff", frequency, help::cutoff, [](const O& o) { return o.normal.cutoff; }},
      {"step", time, help::step, [](const O& o) { return o.normal.resolution.step; }},
      {"nodes", none, help::nodes, [](const O& o) { return o.normal.resolution.nodes; }},
      {"half_width", length, help::half_width, [](const O& o) { return o.normal.resolution.half_width; }},
      {"steps", none, help::steps, [](const O& o) { return o.normal.steps; }},
      {"energy_error", none, help::energy_error, &O::energy_error},
      {"momentum_error", none, help::momentum_error,
       [](const O& o) { return std::max(o.momentum_error, o.normal.momentum_error); }},
      {"angular_momentum_error", none, "Missing angular momentum as a share of that of the motion before",
       &O::angular_momentum_error},
      {"stays", none, help::stays, [](const O& o) { return o.normal.remaining > 0.0; }},
      {"strain", none, help::strain, [](const O& o) { return o.normal.strain; }},
      {"beyond_small_strain", none, help::beyond_small_strain, [](const O& o) { return o.normal.beyond_small_strain; }},
      {"turned", none, help::turned, &O::turned},
      {"beyond_small_turn", none, help::beyond_small_turn, &O::beyond_small_turn},
  };
  return all;
}

const Quantities<ObliqueSnapshot>& oblique_snapshot_quantities() {
  using S = ObliqueSnapshot;
  static const Quantities<S> all{
      {"time", time, help::time, &S::time},
      {"center", length, help::center, &S::center},
      {"shift", length, "Distance that the first body has moved along the surface since the start", &S::shift},
      {"velocity", speed, "Speed of approach along the normal", &S::velocity},
      {"tangential", speed, "Velocity of the first body along the surface", &S::tangential},
      {"angle", none, "Angle in radians by which the first body has turned since the start", &S::angle},
      {"second_angle", none, "Angle in radians by which the second body has turned since the start", &S::second_angle},
      {"spin", frequency, "Spin of the first body", &S::spin},
      {"second_spin", frequency, "Spin of the second body", &S::second_spin},
      {"force", force, help::force, &S::force},
      {"friction", force, "Force of friction, positive where it slows the first body", &S::friction},
      {"touching", none, "Number of contact points with pressure", &S::touching},
      {"translation", none, help::normal_translation, [](const S& s) { return s.energy.translation; }},
      {"across", none, help::across, [](const S& s) { return s.energy.across; }},
      {"rotation", none, help::rotation, [](const S& s) { return s.energy.rotation; }},
      {"second_rotation", none, help::second_rotation, [](const S& s) { return s.energy.second_rotation; }},
      {"elastic", none, "Share of the initial energy that went into the deformation of the bodies",
       [](const S& s) { return s.energy.elastic; }},
      {"friction_loss", none, help::friction_loss, [](const S& s) { return s.energy.friction; }},
  };
  return all;
}

const Quantities<ObliqueLedger>& oblique_ledger_quantities() {
  using L = ObliqueLedger;
  static const Quantities<L> all{
      {"translation", none, help::normal_translation, &L::translation},
      {"across", none, help::across, &L::across},
      {"rotation", none, help::rotation, &L::rotation},
      {"second_rotation", none, help::second_rotation, &L::second_rotation},
      {"vibration", none, "Share of the initial energy in the vibration of the first body's kept modes", &L::vibration},
      {"second_vibration", none, "Share of the initial energy in the vibration of the second body's kept modes",
       &L::second_vibration},
      {"dissipated", none, help::dissipated, &L::dissipated},
      {"yielded", none, help::yielded, &L::yielded},
      {"friction", none, help::friction_loss, &L::friction},
      {"unresolved", none, help::unresolved, &L::unresolved},
      {"stored", none, help::stored, &L::stored},
  };
  return all;
}

const Quantities<ModeEnergy>& mode_energy_quantities() {
  using M = ModeEnergy;
  static const Quantities<M> all{
      {"body", none, "Which body vibrates in this mode: first or second",
       [](const M& m) { return std::string(m.body == 0 ? "first" : "second"); }},
      {"order", none, help::order, &M::order},
      {"index", none, help::index, &M::index},
      {"omega", frequency, help::omega, &M::omega},
      {"before", none, "Energy of the mode before the impact, as a share of the initial energy", &M::before},
      {"average", none, "Mean energy of the mode during the contact, as a share of the initial energy", &M::average},
      {"after", none, "Energy of the mode after the impact, as a share of the initial energy", &M::after},
  };
  return all;
}

const Quantities<Snapshot>& snapshot_quantities() {
  using S = Snapshot;
  static const Quantities<S> all{
      {"time", time, help::time, &S::time},
      {"center", length, help::center, &S::center},
      {"velocity", speed, "Velocity of the first body's centre of mass towards the other", &S::velocity},
      {"force", force, help::force, &S::force},
      {"translation", none, help::translation, &S::translation},
      {"vibration", none, help::vibration, &S::vibration},
      {"stored", none, help::stored, &S::stored},
      {"dissipated", none, help::dissipated, &S::dissipated},
      {"yielded", none, help::yielded, &S::yielded},
      {"unresolved", none, help::unresolved, &S::unresolved},
      {"contact_half_width", length, "Half-width of the contact, of spheres its radius", &S::contact_half_width},
  };
  return all;
}

}  // namespace stoss
