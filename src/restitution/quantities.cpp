#include "stoss/restitution/quantities.hpp"

#include <limits>

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
      {"restitution", none, &R::restitution},
      {"lost_fraction", none, &R::lost_fraction},
      {"contact_time", time, &R::contact_time},
      {"impulse_time", time, &R::impulse_time},
      {"max_compression", length, &R::max_compression},
      {"max_force", force, &R::max_force},
      {"lost_to_first", none, &R::lost_to_first},
      {"lost_to_second", none, &R::lost_to_second},
      {"dissipated", none, &R::dissipated},
      {"cutoff", frequency, [](const R& r) { return finest(r, r.finest.cutoff); }},
      {"modes", none, [](const R& r) { return count(r.finest.energy.modes); }},
      {"runs", none, [](const R& r) { return count(r.runs); }},
      {"steps", none, &R::steps},
      {"energy_error", none, [](const R& r) { return finest(r, r.finest.energy_error); }},
      {"converged", none, &R::converged},
      {"stays", none, [](const R& r) { return r.finest.remaining > 0.0; }},
      {"strain", none, [](const R& r) { return finest(r, r.finest.strain); }},
      {"beyond_small_strain", none, [](const R& r) { return r.finest.beyond_small_strain; }},
  };
  return all;
}

const Quantities<Run>& run_quantities() {
  static const Quantities<Run> all{
      {"cutoff", frequency, &Run::cutoff},
      {"step", time, [](const Run& run) { return run.resolution.step; }},
      {"nodes", none, [](const Run& run) { return run.resolution.nodes; }},
      {"lost_fraction", none, &Run::lost_fraction},
      {"dissipated", none, &Run::dissipated},
      {"unresolved", none, &Run::unresolved},
      {"contact_time", time, &Run::contact_time},
      {"impulse_time", time, &Run::impulse_time},
      {"max_force", force, &Run::max_force},
      {"max_compression", length, &Run::max_compression},
      {"energy_error", none, &Run::energy_error},
      {"steps", none, &Run::steps},
  };
  return all;
}

const Quantities<ObliqueRestitution>& oblique_quantities() {
  using O = ObliqueRestitution;
  static const Quantities<O> all{
      {"restitution", none, &O::restitution},
      {"tangential_restitution", none, &O::tangential_restitution},
      {"sliding", speed, &O::sliding},
      {"sliding_after", speed, &O::sliding_after},
      {"tangential_after", speed, &O::tangential_after},
      {"spin_after", frequency, &O::spin_after},
      {"second_spin_after", frequency, &O::second_spin_after},
      {"friction_loss", none, &O::friction_loss},
      {"vibration", none, &O::vibration},
      {"dundurs", none, [](const O& o) { return o.neglected.dundurs; }},
      {"coupling_restitution", none, [](const O& o) { return o.neglected.restitution; }},
      {"coupling_tangential_restitution", none, [](const O& o) { return o.neglected.tangential_restitution; }},
      {"coupling_sliding_after", speed, [](const O& o) { return o.neglected.sliding_after; }},
      {"contact_time", time, [](const O& o) { return finest(o, o.finest.normal.contact_time); }},
      {"cutoff", frequency, [](const O& o) { return finest(o, o.finest.normal.cutoff); }},
      {"runs", none, [](const O& o) { return count(o.runs); }},
      {"steps", none, &O::steps},
      {"energy_error", none, [](const O& o) { return finest(o, o.finest.energy_error); }},
      {"converged", none, &O::converged},
      {"unstable", none, &O::unstable},
      {"stays", none, [](const O& o) { return o.finest.normal.remaining > 0.0; }},
      {"strain", none, [](const O& o) { return finest(o, o.finest.normal.strain); }},
      {"beyond_small_strain", none, [](const O& o) { return o.finest.normal.beyond_small_strain; }},
      {"turned", none, [](const O& o) { return finest(o, o.finest.turned); }},
      {"beyond_small_turn", none, [](const O& o) { return o.finest.beyond_small_turn; }},
  };
  return all;
}

const Quantities<ObliqueRun>& oblique_run_quantities() {
  using R = ObliqueRun;
  static const Quantities<R> all{
      {"cutoff", frequency, &R::cutoff},
      {"step", time, [](const R& run) { return run.resolution.step; }},
      {"nodes", none, [](const R& run) { return run.resolution.nodes; }},
      {"restitution", none, &R::restitution},
      {"sliding_after", speed, &R::sliding_after},
      {"tangential_after", speed, &R::tangential_after},
      {"spin_after", frequency, &R::spin_after},
      {"second_spin_after", frequency, &R::second_spin_after},
      {"friction_loss", none, &R::friction_loss},
      {"vibration", none, &R::vibration},
      {"unresolved", none, &R::unresolved},
      {"energy_error", none, &R::energy_error},
      {"steps", none, &R::steps},
  };
  return all;
}

const Quantities<ExtrapolatedRestitution>& extrapolation_quantities() {
  using E = ExtrapolatedRestitution;
  static const Quantities<E> all{
      {"restitution", none, &E::restitution},
      {"lost_fraction", none, &E::lost_fraction},
      {"impacts", none, [](const E& e) { return count(e.impacts); }},
      {"steps", none, &E::steps},
  };
  return all;
}

const Quantities<SoftImpact>& soft_impact_quantities() {
  using S = SoftImpact;
  static const Quantities<S> all{
      {"cutoff", frequency, &S::cutoff},
      {"modes", none, &S::modes},
      {"hardness", inverse_length, &S::hardness},
      {"lost_fraction", none, &S::lost_fraction},
      {"steps", none, &S::steps},
  };
  return all;
}

}  // namespace stoss
