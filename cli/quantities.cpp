#include "quantities.hpp"

#include <limits>

namespace stoss::cli {
namespace {

using namespace quasistatic;

/// Of the finest impact; there is none where no two impacts end.
double finest(const Restitution& r, double value) {
  return r.runs.empty() ? std::numeric_limits<double>::quiet_NaN() : value;
}

template <typename List>
long count(const List& list) {
  return static_cast<long>(list.size());
}

std::string family_name(const bodies::disk::Mode& mode) {
  return family(mode) == bodies::disk::ModeFamily::radial ? "radial" : "tangential";
}

Estimate lost_by_rayleigh(const RayleighEstimate& e) { return {e.lost_fraction, e.lost_fraction_error}; }

using enum Dimension;

constexpr bool own = false;  // without an SI value

}  // namespace

const Quantities<Restitution>& restitution_quantities() {
  using R = Restitution;
  static const Quantities<R> all{
      {"restitution", none, &R::restitution, {22, 22, true}},
      {"lost_fraction", none, &R::lost_fraction, {25, 25, true}, own, [](const R& r) { return !r.converged; }},
      {"contact_time", time, &R::contact_time, {13, 17}},
      {"max_compression", length, &R::max_compression},
      {"max_force", force, &R::max_force},
      {"lost_to_first", none, [](const R& r) { return finest(r, r.finest.energy.lost_to_first); }},
      {"lost_to_second", none, [](const R& r) { return finest(r, r.finest.energy.lost_to_second); }},
      {"cutoff", frequency, [](const R& r) { return finest(r, r.finest.cutoff); }, {}, own},
      {"modes", none, [](const R& r) { return count(r.finest.energy.modes); }},
      {"runs", none, [](const R& r) { return count(r.runs); }},
      {"steps", none, &R::steps},
      {"energy_error", none, [](const R& r) { return finest(r, r.finest.energy_error); }},
      {"converged", none, &R::converged},
      {"beyond_small_strain", none, [](const R& r) { return r.finest.beyond_small_strain; }},
  };
  return all;
}

const Quantities<Run>& run_quantities() {
  static const Quantities<Run> all{
      {"cutoff", frequency, &Run::cutoff},
      {"step", time, &Run::step},
      {"nodes", none, &Run::nodes},
      {"lost_fraction", none, &Run::lost_fraction},
      {"contact_time", time, &Run::contact_time},
      {"max_force", force, &Run::max_force},
      {"max_compression", length, &Run::max_compression},
      {"energy_error", none, &Run::energy_error},
      {"steps", none, &Run::steps},
  };
  return all;
}

const Quantities<ExtrapolatedRestitution>& extrapolation_quantities() {
  using E = ExtrapolatedRestitution;
  static const Quantities<E> all{
      {"restitution", none, &E::restitution, {22, 22, true}},
      {"lost_fraction", none, &E::lost_fraction, {24, 24, true}},
      {"impacts", none, [](const E& e) { return count(e.impacts); }, {9, 9}},
      {"steps", none, &E::steps},
  };
  return all;
}

const Quantities<SoftImpact>& soft_impact_quantities() {
  static const Quantities<SoftImpact> all{
      {"cutoff", frequency, &SoftImpact::cutoff}, {"modes", none, &SoftImpact::modes},
      {"hardness", none, &SoftImpact::hardness},  {"lost_fraction", none, &SoftImpact::lost_fraction},
      {"steps", none, &SoftImpact::steps},
  };
  return all;
}

const Quantities<Impact>& impact_quantities() {
  using I = Impact;
  static const Quantities<I> all{
      {"restitution", none, &I::restitution},
      {"lost_fraction", none, &I::lost_fraction},
      {"translation", none, [](const I& i) { return i.energy.translation; }},
      {"vibration", none, [](const I& i) { return i.energy.vibration; }},
      {"unresolved", none, [](const I& i) { return i.energy.unresolved; }},
      {"lost_to_first", none, [](const I& i) { return i.energy.lost_to_first; }},
      {"lost_to_second", none, [](const I& i) { return i.energy.lost_to_second; }},
      {"contact_time", time, &I::contact_time},
      {"contacts", none, &I::contacts},
      {"max_force", force, &I::max_force},
      {"max_compression", length, &I::max_compression},
      {"max_half_width", length, &I::max_half_width},
      {"cutoff", frequency, &I::cutoff, {}, own},
      {"modes", none, [](const I& i) { return count(i.energy.modes); }},
      {"step", time, &I::step, {}, own},
      {"nodes", none, &I::nodes},
      {"steps", none, &I::steps},
      {"energy_error", none, &I::energy_error},
      {"momentum_error", none, &I::momentum_error},
      {"beyond_small_strain", none, &I::beyond_small_strain},
  };
  return all;
}

const Quantities<EnergyLedger>& ledger_quantities() {
  static const Quantities<EnergyLedger> all{
      {"translation", none, &EnergyLedger::translation},
      {"vibration", none, &EnergyLedger::vibration},
      {"unresolved", none, &EnergyLedger::unresolved},
      {"stored", none, &EnergyLedger::stored},
  };
  return all;
}

const Quantities<ModeEnergy>& mode_quantities() {
  static const Quantities<ModeEnergy> all{
      {"body", none, [](const ModeEnergy& m) { return std::string(m.body == 0 ? "first" : "second"); }},
      {"order", none, &ModeEnergy::order},
      {"index", none, &ModeEnergy::index},
      {"omega", frequency, &ModeEnergy::omega},
      {"average", none, &ModeEnergy::average},
      {"after", none, &ModeEnergy::after},
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
      {"unresolved", none, &S::unresolved},
      {"contact_half_width", length, &S::contact_half_width},
  };
  return all;
}

const Quantities<bodies::disk::Mode>& eigenmode_quantities() {
  static const Quantities<bodies::disk::Mode> all{
      {"order", none, &bodies::disk::Mode::order, {7, 7}},
      {"index", none, &bodies::disk::Mode::index, {7, 7}},
      {"omega", frequency, &bodies::disk::Mode::omega, {13, 13}},
      {"radial", none, &bodies::disk::Mode::radial, {13, 13}},
      {"tangential", none, &bodies::disk::Mode::tangential, {13, 13}},
      {"family", none, [](const bodies::disk::Mode& m) { return family_name(m); }, {13, 13}},
  };
  return all;
}

const Quantities<RayleighEstimate>& slow_impact_quantities() {
  using E = RayleighEstimate;
  static const Quantities<E> all{
      {"lost_fraction", none, lost_by_rayleigh, {24, 24, true}, own, &E::beyond_perturbation},
      {"contact_time", time, [](const E& e) { return e.impact.contact_time; }, {14, 17}},
      {"max_compression", length, [](const E& e) { return e.impact.max_compression; }, {17, 20}},
      {"max_force", force, [](const E& e) { return e.impact.max_force; }, {13, 0}},
      {"kinetic_share", none, &E::kinetic_share},
      {"beyond_perturbation", none, &E::beyond_perturbation},
      {"modes", none, [](const E& e) { return count(e.modes); }},
  };
  return all;
}

const Quantities<DrivenMode>& driven_mode_quantities() {
  static const Quantities<DrivenMode> all{
      {"order", none, &DrivenMode::order},      {"index", none, &DrivenMode::index},
      {"omega", frequency, &DrivenMode::omega}, {"amplitude", none, &DrivenMode::amplitude},
      {"after", none, &DrivenMode::after},
  };
  return all;
}

const Quantities<Compressed>& compression_quantities() {
  using C = Compressed;
  static const Quantities<C> all{
      {"compression", length, &C::compression, {13, 16}},
      {"force", force, &C::force, {13, 13}},
      {"energy", energy, &C::energy, {14, 14}},
      {"half_width", length, &C::half_width, {12, 15}},
      {"static_force",
       force,
       [](const C& c) {
         return Estimate{c.contact.force, c.contact.force_error};
       },
       {27, 17, true}},
  };
  return all;
}

}  // namespace stoss::cli
