#include "stoss/vibration/quantities.hpp"

#include "quantity_help.hpp"

namespace stoss {

using enum Dimension;

const Quantities<Sample>& sample_quantities() {
  using S = Sample;
  static const Quantities<S> all{
      {"sample", none, "Number of the sample in its ensemble, from 0", &S::number},
      {"vibration", none, "Energy of all modes before the impact, as a share of the translational one", &S::vibration},
      {"restitution", none, help::restitution, &S::restitution},
      {"lost_fraction", none, help::lost_fraction, &S::lost_fraction},
      {"contact_time", time, help::contact_time, &S::contact_time},
      {"contacts", none, help::contacts, &S::contacts},
      {"steps", none, help::all_steps, &S::steps},
      {"converged", none, help::converged, &S::converged},
      {"strain", none, help::strain, &S::strain},
      {"beyond_small_strain", none, help::beyond_small_strain, &S::beyond_small_strain},
  };
  return all;
}

const Quantities<DistributionSummary>& distribution_quantities() {
  using D = DistributionSummary;
  static const Quantities<D> all{
      {"samples", none, "Number of samples that have a value", &D::samples},
      {"missing", none, "Number of samples without a value", &D::missing},
      {"not_converged", none, "Number of samples with a value that misses the error asked for", &D::not_converged},
      {"restitution", none, "Mean coefficient of restitution", [](const D& d) { return d.restitution.value; }},
      {"restitution_statistical_error", none, "Standard error of the mean restitution, infinite for one sample",
       [](const D& d) { return d.restitution.statistical_error; }},
      {"restitution_numerical_error", none, "Mean numerical error of the restitution of the samples",
       [](const D& d) { return d.restitution.numerical_error; }},
      {"standard_deviation", none, "Standard deviation of the restitution, infinite for one sample",
       &D::standard_deviation},
      {"least", none, "Smallest restitution of the samples", &D::least},
      {"greatest", none, "Largest restitution of the samples", &D::greatest},
      {"share_above_one", none, "Share of the samples with a restitution above 1", &D::share_above_one},
      {"lost_fraction", none, "Mean lost fraction", [](const D& d) { return d.lost_fraction.value; }},
      {"lost_fraction_statistical_error", none, "Standard error of the mean lost fraction, infinite for one sample",
       [](const D& d) { return d.lost_fraction.statistical_error; }},
      {"lost_fraction_numerical_error", none, "Mean numerical error of the lost fraction of the samples",
       [](const D& d) { return d.lost_fraction.numerical_error; }},
  };
  return all;
}

const Quantities<Bounce>& bounce_quantities() {
  using B = Bounce;
  static const Quantities<B> all{
      {"number", none, "Number of the impact in its sequence, from 1", &B::number},
      {"speed", Dimension::speed, help::speed, &B::speed},
      {"restitution", none, help::restitution, &B::restitution},
      {"translation_before", none, "Translational energy before, as a share of the sequence's initial energy",
       [](const B& b) { return b.before.translation; }},
      {"vibration_before", none, "Energy of the kept modes before, as a share of the sequence's initial energy",
       [](const B& b) { return b.before.vibration; }},
      {"dissipated_before", none, "Energy lost to the material and in flight before, as a share of the initial energy",
       [](const B& b) { return b.before.dissipated; }},
      {"unresolved_before", none, "Energy that modes above the cutoff and waves took before, as a share of the initial",
       [](const B& b) { return b.before.unresolved; }},
      {"translation", none, "Translational energy after, as a share of the sequence's initial energy",
       [](const B& b) { return b.after.translation; }},
      {"vibration", none, "Energy of the kept modes after, as a share of the sequence's initial energy",
       [](const B& b) { return b.after.vibration; }},
      {"dissipated", none, "Energy lost to the material and in flight after, as a share of the initial energy",
       [](const B& b) { return b.after.dissipated; }},
      {"unresolved", none, "Energy that modes above the cutoff and waves have taken, as a share of the initial",
       [](const B& b) { return b.after.unresolved; }},
      {"energy_error", none, "Missing energy of all impacts so far, as a share of the sequence's initial energy",
       &B::energy_error},
      {"contact_time", time, help::contact_time, &B::contact_time},
      {"flight_time", time, "Time of the flight after the impact", &B::flight_time},
      {"short_flight", none, "Whether the flight before was too short for the vibration to keep clear of the wall",
       &B::short_flight},
      {"dent", length, help::dent, &B::dent},
      {"strain", none, help::strain, &B::strain},
      {"beyond_small_strain", none, help::beyond_small_strain, &B::beyond_small_strain},
  };
  return all;
}

}  // namespace stoss
