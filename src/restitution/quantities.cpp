#include "stoss/restitution/quantities.hpp"

#include <limits>

#include "quantity_help.hpp"

namespace stoss {
namespace {

/// Of the finest impact, if there is one.
template <typename Result>
double finest(const Result& r, double value) {
  return r.runs.empty() ? std::numeric_limits<double>::quiet_NaN() : value;
}

template <typename List>
long count(const List& list) {
  return static_cast<long>(list.size());
}

}  // namespace

using enum Dimension;

const Quantities<Restitution>& restitution_quantities() {
  using R = Restitution;
  static const Quantities<R> all{
      {"restitution", none, help::restitution, &R::restitution},
      {"lost_fraction", none, help::lost_fraction, &R::lost_fraction},
      {"contact_time", time, help::contact_time, &R::contact_time},
      {"impulse_time", time, help::impulse_time, &R::impulse_time},
      {"max_compression", length, help::max_compression, &R::max_compression},
      {"max_force", force, help::max_force, &R::max_force},
      {"lost_to_first", none, help::lost_to_first, &R::lost_to_first},
      {"lost_to_second", none, help::lost_to_second, &R::lost_to_second},
      {"dissipated", none, help::dissipated, &R::dissipated},
      {"yielded", none, help::yielded, &R::yielded},
      {"dent", length, help::dent, [](const R& r) { return finest(r, r.finest.dent); }},
      {"cutoff", frequency, help::cutoff, [](const R& r) { return finest(r, r.finest.cutoff); }},
      {"modes", none, help::modes, [](const R& r) { return count(r.finest.energy.modes); }},
      {"runs", none, help::runs, [](const R& r) { return count(r.runs); }},
      {"steps", none, help::all_steps, &R::steps},
      {"energy_error", none, help::energy_error, [](const R& r) { return finest(r, r.finest.energy_error); }},
      {"converged", none, help::converged, &R::converged},
      {"stays", none, help::stays, [](const R& r) { return r.finest.remaining > 0.0; }},
      {"strain", none, help::strain, [](const R& r) { return finest(r, r.finest.strain); }},
      {"beyond_small_strain", none, help::beyond_small_strain, [](const R& r) { return r.finest.beyond_small_strain; }},
  };
  return all;
}

const Quantities<Run>& run_quantities() {
  static const Quantities<Run> all{
      {"cutoff", frequency, help::cutoff, &Run::cutoff},
      {"step", time, help::step, [](const Run& run) { return run.resolution.step; }},
      {"nodes", none, help::nodes, [](const Run& run) { return run.resolution.nodes; }},
      {"lost_fraction", none, help::lost_fraction, &Run::lost_fraction},
      {"dissipated", none, help::dissipated, &Run::dissipated},
      {"unresolved", none, help::unresolved, &Run::unresolved},
      {"contact_time", time, help::contact_time, &Run::contact_time},
      {"impulse_time", time, help::impulse_time, &Run::impulse_time},
      {"max_force", force, help::max_force, &Run::max_force},
      {"max_compression", length, help::max_compression, &Run::max_compression},
      {"energy_error", none, help::energy_error, &Run::energy_error},
      {"steps", none, help::steps, &Run::steps},
  };
  return all;
}

const Quantities<ObliqueRestitution>& oblique_quantities() {
  using O = ObliqueRestitution;
  static const Quantities<O> all{
      {"restitution", none, help::normal_restitution, &O::restitution},
      {"tangential_restitution", none, help::tangential_restitution, &O::tangential_restitution},
      {"sliding", speed, help::sliding, &O::sliding},
      {"sliding_after", speed, help::sliding_after, &O::sliding_after},
      {"tangential_after", speed, help::tangential_after, &O::tangential_after},
      {"spin_after", frequency, help::spin_after, &O::spin_after},
      {"second_spin_after", frequency, help::second_spin_after, &O::second_spin_after},
      {"friction_loss", none, help::friction_loss, &O::friction_loss},
      {"vibration", none, help::vibration_after, &O::vibration},
      {"dundurs", none, "Size of Dundurs' beta of both bodies, which couples pressure and friction",
       [](const O& o) { return o.neglected.dundurs; }},
      {"coupling_restitution", none, "Change of the restitution by the neglected coupling of pressure and friction",
       [](const O& o) { return o.neglected.restitution; }},
      {"coupling_tangential_restitution", none, "Change of the tangential restitution by the neglected coupling",
       [](const O& o) { return o.neglected.tangential_restitution; }},
      {"coupling_sliding_after", speed, "Change of the sliding speed after by the neglected coupling",
       [](const O& o) { return o.neglected.sliding_after; }},
      {"contact_time", time, help::contact_time, [](const O& o) { return finest(o, o.finest.normal.contact_time); }},
      {"cutoff", frequency, help::cutoff, [](const O& o) { return finest(o, o.finest.normal.cutoff); }},
      {"runs", none, help::runs, [](const O& o) { return count(o.runs); }},
      {"steps", none, help::all_steps, &O::steps},
      {"energy_error", none, help::energy_error, [](const O& o) { return finest(o, o.finest.energy_error); }},
      {"converged", none, help::converged, &O::converged},
      {"unstable", none, "Whether friction is so high that waves of any length grow, so that nothing has a limit",
       &O::unstable},
      {"stays", none, help::stays, [](const O& o) { return o.finest.normal.remaining > 0.0; }},
      {"strain", none, help::strain, [](const O& o) { return finest(o, o.finest.normal.strain); }},
      {"beyond_small_strain", none, help::beyond_small_strain,
       [](const O& o) { return o.finest.normal.beyond_small_strain; }},
      {"turned", none, help::turned, [](const O& o) { return finest(o, o.finest.turned); }},
      {"beyond_small_turn", none, help::beyond_small_turn, [](const O& o) { return o.finest.beyond_small_turn; }},
  };
  return all;
}

const Quantities<ObliqueRun>& oblique_run_quantities() {
  using R = ObliqueRun;
  static const Quantities<R> all{
      {"cutoff", frequency, help::cutoff, &R::cutoff},
      {"step", time, help::step, [](const R& run) { return run.resolution.step; }},
      {"nodes", none, help::nodes, [](const R& run) { return run.resolution.nodes; }},
      {"restitution", none, help::normal_restitution, &R::restitution},
      {"sliding_after", speed, help::sliding_after, &R::sliding_after},
      {"tangential_after", speed, help::tangential_after, &R::tangential_after},
      {"spin_after", frequency, help::spin_after, &R::spin_after},
      {"second_spin_after", frequency, help::second_spin_after, &R::second_spin_after},
      {"friction_loss", none, help::friction_loss, &R::friction_loss},
      {"vibration", none, help::vibration_after, &R::vibration},
      {"unresolved", none, help::unresolved, &R::unresolved},
      {"energy_error", none, help::energy_error, &R::energy_error},
      {"steps", none, help::steps, &R::steps},
  };
  return all;
}

}  // namespace stoss
