#include "stoss/impact/quantities.hpp"

#include <algorithm>

namespace stoss {

using enum Dimension;

const Quantities<Impact>& impact_quantities() {
  using I = Impact;
  static const Quantities<I> all{
      {"restitution", none, &I::restitution},
      {"lost_fraction", none, &I::lost_fraction},
      {"translation", none, [](const I& i) { return i.energy.translation; }},
      {"vibration", none, [](const I& i) { return i.energy.vibration; }},
      {"dissipated", none, [](const I& i) { return i.energy.dissipated; }},
      {"unresolved", none, [](const I& i) { return i.energy.unresolved; }},
      {"lost_to_first", none, [](const I& i) { return i.energy.lost_to_first; }},
      {"lost_to_second", none, [](const I& i) { return i.energy.lost_to_second; }},
      {"contact_time", time, &I::contact_time},
      {"impulse_time", time, &I::impulse_time},
      {"contacts", none, &I::contacts},
      {"max_force", force, &I::max_force},
      {"max_compression", length, &I::max_compression},
      {"max_half_width", length, &I::max_half_width},
      {"cutoff", frequency, &I::cutoff},
      {"modes", none, [](const I& i) { return static_cast<long>(i.energy.modes.size()); }},
      {"step", time, [](const I& i) { return i.resolution.step; }},
      {"nodes", none, [](const I& i) { return i.resolution.nodes; }},
      {"half_width", length, [](const I& i) { return i.resolution.half_width; }},
      {"steps", none, &I::steps},
      {"energy_error", none, &I::energy_error},
      {"momentum_error", none, &I::momentum_error},
      {"stays", none, [](const I& i) { return i.remaining > 0.0; }},
      {"strain", none, &I::strain},
      {"beyond_small_strain", none, &I::beyond_small_strain},
  };
  return all;
}

std::string note_of_staying() {
  return "the body stays: the plate is infinite and never returns what it takes, so eps is 0; waves that come "
         "back from the rim of a real one may throw the body off";
}

const Quantities<EnergyLedger>& ledger_quantities() {
  using L = EnergyLedger;
  static const Quantities<L> all{
      {"translation", none, &L::translation}, {"vibration", none, &L::vibration}, {"dissipated", none, &L::dissipated},
      {"unresolved", none, &L::unresolved},   {"stored", none, &L::stored},
  };
  return all;
}

const Quantities<ObliqueImpact>& oblique_impact_quantities() {
  using O = ObliqueImpact;
  static const Quantities<O> all{
      {"restitution", none, &O::restitution},
      {"tangential_restitution", none, &O::tangential_restitution},
      {"sliding", speed, &O::sliding},
      {"sliding_after", speed, &O::sliding_after},
      {"tangential_after", speed, &O::tangential_after},
      {"spin_after", frequency, &O::spin_after},
      {"second_spin_after", frequency, &O::second_spin_after},
      {"contact_time", time, [](const O& o) { return o.normal.contact_time; }},
      {"max_force", force, [](const O& o) { return o.normal.max_force; }},
      {"max_compression", length, [](const O& o) { return o.normal.max_compression; }},
      {"max_half_width", length, [](const O& o) { return o.normal.max_half_width; }},
      {"cutoff", frequency, [](const O& o) { return o.normal.cutoff; }},
      {"step", time, [](const O& o) { return o.normal.resolution.step; }},
      {"nodes", none, [](const O& o) { return o.normal.resolution.nodes; }},
      {"half_width", length, [](const O& o) { return o.normal.resolution.half_width; }},
      {"steps", none, [](const O& o) { return o.normal.steps; }},
      {"energy_error", none, &O::energy_error},
      {"momentum_error", none, [](const O& o) { return std::max(o.momentum_error, o.normal.momentum_error); }},
      {"angular_momentum_error", none, &O::angular_momentum_error},
      {"stays", none, [](const O& o) { return o.normal.remaining > 0.0; }},
      {"strain", none, [](const O& o) { return o.normal.strain; }},
      {"beyond_small_strain", none, [](const O& o) { return o.normal.beyond_small_strain; }},
      {"turned", none, &O::turned},
      {"beyond_small_turn", none, &O::beyond_small_turn},
  };
  return all;
}

const Quantities<ObliqueSnapshot>& oblique_snapshot_quantities() {
  using S = ObliqueSnapshot;
  static const Quantities<S> all{
      {"time", time, &S::time},
      {"center", length, &S::center},
      {"shift", length, &S::shift},
      {"velocity", speed, &S::velocity},
      {"tangential", speed, &S::tangential},
      {"angle", none, &S::angle},
      {"second_angle", none, &S::second_angle},
      {"spin", frequency, &S::spin},
      {"second_spin", frequency, &S::second_spin},
      {"force", force, &S::force},
      {"friction", force, &S::friction},
      {"touching", none, &S::touching},
      {"translation", none, [](const S& s) { return s.energy.translation; }},
      {"across", none, [](const S& s) { return s.energy.across; }},
      {"rotation", none, [](const S& s) { return s.energy.rotation; }},
      {"second_rotation", none, [](const S& s) { return s.energy.second_rotation; }},
      {"elastic", none, [](const S& s) { return s.energy.elastic; }},
      {"friction_loss", none, [](const S& s) { return s.energy.friction; }},
  };
  return all;
}

const Quantities<ObliqueLedger>& oblique_ledger_quantities() {
  using L = ObliqueLedger;
  static const Quantities<L> all{
      {"translation", none, &L::translation}, {"across", none, &L::across},
      {"rotation", none, &L::rotation},       {"second_rotation", none, &L::second_rotation},
      {"vibration", none, &L::vibration},     {"second_vibration", none, &L::second_vibration},
      {"dissipated", none, &L::dissipated},   {"friction", none, &L::friction},
      {"unresolved", none, &L::unresolved},   {"stored", none, &L::stored},
  };
  return all;
}

const Quantities<ModeEnergy>& mode_energy_quantities() {
  using M = ModeEnergy;
  static const Quantities<M> all{
      {"body", none, [](const M& m) { return std::string(m.body == 0 ? "first" : "second"); }},
      {"order", none, &M::order},
      {"index", none, &M::index},
      {"omega", frequency, &M::omega},
      {"before", none, &M::before},
      {"average", none, &M::average},
      {"after", none, &M::after},
  };
  return all;
}

const Quantities<Snapshot>& snapshot_quantities() {
  using S = Snapshot;
  static const Quantities<S> all{
      {"time", time, &S::time},
      {"center", length, &S::center},
      {"velocity", speed, &S::velocity},
      {"force", force, &S::force},
      {"translation", none, &S::translation},
      {"vibration", none, &S::vibration},
      {"stored", none, &S::stored},
      {"dissipated", none, &S::dissipated},
      {"unresolved", none, &S::unresolved},
      {"contact_half_width", length, &S::contact_half_width},
  };
  return all;
}

}  // namespace stoss
