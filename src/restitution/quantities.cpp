#include "stoss/restitution/quantities.hpp"

#include <limits>

namespace stoss {
namespace {

/// Of the finest impact, if there is one.
double finest(const Restitution& r, double value) {
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
