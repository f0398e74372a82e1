#include "stoss/vibration/quantities.hpp"

namespace stoss {

using enum Dimension;

const Quantities<Sample>& sample_quantities() {
  using S = Sample;
  static const Quantities<S> all{
      {"sample", none, &S::number},
      {"vibration", none, &S::vibration},
      {"restitution", none, &S::restitution},
      {"lost_fraction", none, &S::lost_fraction},
      {"contact_time", time, &S::contact_time},
      {"contacts", none, &S::contacts},
      {"steps", none, &S::steps},
      {"converged", none, &S::converged},
      {"strain", none, &S::strain},
      {"beyond_small_strain", none, &S::beyond_small_strain},
  };
  return all;
}

const Quantities<DistributionSummary>& distribution_quantities() {
  using D = DistributionSummary;
  static const Quantities<D> all{
      {"samples", none, &D::samples},
      {"missing", none, &D::missing},
      {"not_converged", none, &D::not_converged},
      {"restitution", none, [](const D& d) { return d.restitution.value; }},
      {"restitution_statistical_error", none, [](const D& d) { return d.restitution.statistical_error; }},
      {"restitution_numerical_error", none, [](const D& d) { return d.restitution.numerical_error; }},
      {"standard_deviation", none, &D::standard_deviation},
      {"least", none, &D::least},
      {"greatest", none, &D::greatest},
      {"share_above_one", none, &D::share_above_one},
      {"lost_fraction", none, [](const D& d) { return d.lost_fraction.value; }},
      {"lost_fraction_statistical_error", none, [](const D& d) { return d.lost_fraction.statistical_error; }},
      {"lost_fraction_numerical_error", none, [](const D& d) { return d.lost_fraction.numerical_error; }},
  };
  return all;
}

const Quantities<Bounce>& bounce_quantities() {
  using B = Bounce;
  static const Quantities<B> all{
      {"number", none, &B::number},
      {"speed", Dimension::speed, &B::speed},
      {"restitution", none, &B::restitution},
      {"translation_before", none, [](const B& b) { return b.before.translation; }},
      {"vibration_before", none, [](const B& b) { return b.before.vibration; }},
      {"dissipated_before", none, [](const B& b) { return b.before.dissipated; }},
      {"unresolved_before", none, [](const B& b) { return b.before.unresolved; }},
      {"translation", none, [](const B& b) { return b.after.translation; }},
      {"vibration", none, [](const B& b) { return b.after.vibration; }},
      {"dissipated", none, [](const B& b) { return b.after.dissipated; }},
      {"unresolved", none, [](const B& b) { return b.after.unresolved; }},
      {"energy_error", none, &B::energy_error},
      {"contact_time", time, &B::contact_time},
      {"flight_time", time, &B::flight_time},
      {"short_flight", none, &B::short_flight},
      {"strain", none, &B::strain},
      {"beyond_small_strain", none, &B::beyond_small_strain},
  };
  return all;
}

}  // namespace stoss
