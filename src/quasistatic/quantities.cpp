#include "stoss/quasistatic/quantities.hpp"

#include "quantity_help.hpp"

namespace stoss::quasistatic {

using enum Dimension;

namespace {

struct WithError {
  double value, error;
};

template <typename Made>
Quantity<Made> lost_fraction() {
  return {"lost_fraction", none, help::lost_fraction, [](const Made& its) {
            return WithError{its.lost_fraction, its.lost_fraction_error};
          }};
}

/// Those of Rayleigh's estimate: of the loss, of the impact that drives the modes, and what all have.
Quantities<RayleighEstimate> of_estimate(Quantities<RayleighEstimate> quantities,
                                         const Quantities<SlowImpact>& of_impacts) {
  using E = RayleighEstimate;
  for (const Quantity<SlowImpact>& of_impact : of_impacts) {
    quantities.emplace_back(of_impact.name, of_impact.dimension, of_impact.help,
                            [value = of_impact.value](const E& e) { return value(e.impact); });
  }
  quantities.emplace_back("kinetic_share", none,
                          "Maximum kinetic energy of the modes as they follow the force, over the energy before",
                          &E::kinetic_share);
  quantities.emplace_back("beyond_perturbation", none, "Whether the modes move too much for perturbation theory",
                          &E::beyond_perturbation);
  quantities.emplace_back("modes", none, "Number of modes that the impact drives",
                          [](const E& e) { return static_cast<long>(e.modes.size()); });
  return quantities;
}

}  // namespace

const Quantities<SlowImpact>& slow_impact_quantities() {
  using I = SlowImpact;
  static const Quantities<I> all{
      {"contact_time", time, help::slow_contact_time, &I::contact_time},
      {"max_compression", length, help::slow_max_compression, &I::max_compression},
      {"max_force", force, help::max_force, &I::max_force},
  };
  return all;
}

const Quantities<SlowImpact>& point_slow_impact_quantities() {
  static const Quantities<SlowImpact> all = [] {
    auto quantities = slow_impact_quantities();
    quantities.emplace_back("max_radius", length, help::max_radius, &SlowImpact::max_radius);
    return quantities;
  }();
  return all;
}

const Quantities<RayleighEstimate>& rayleigh_quantities() {
  static const Quantities<RayleighEstimate> all =
      of_estimate({lost_fraction<RayleighEstimate>()}, slow_impact_quantities());
  return all;
}

const Quantities<RayleighEstimate>& point_rayleigh_quantities() {
  static const Quantities<RayleighEstimate> all =
      of_estimate({lost_fraction<RayleighEstimate>(),
                   {"mean_lost_fraction", none,
                    "Mean of the lost fraction over phases, without interference of compression and release",
                    &RayleighEstimate::mean_lost_fraction}},
                  point_slow_impact_quantities());
  return all;
}

const Quantities<HalfSpaceRadiation>& half_space_radiation_quantities() {
  using R = HalfSpaceRadiation;
  static const Quantities<R> all{
      lost_fraction<R>(),
      {"contact_time", time, help::slow_contact_time, &R::contact_time},
      {"max_compression", length, help::slow_max_compression, &R::max_compression},
      {"max_force", force, help::max_force, &R::max_force},
      {"max_radius", length, help::max_radius, &R::max_radius},
      {"first_order", none, "Lost fraction to the first order, of the pulse of the energy before", &R::first_order},
      {"beyond_perturbation", none, "Whether the error is above a tenth of the loss", &R::beyond_perturbation},
  };
  return all;
}

const Quantities<DrivenMode>& driven_mode_quantities() {
  using M = DrivenMode;
  static const Quantities<M> all{
      {"order", none, help::order, &M::order},
      {"index", none, help::index, &M::index},
      {"omega", frequency, help::omega, &M::omega},
      {"amplitude", none, "Fourier amplitude of the force at the frequency of the mode, over the speed before",
       &M::amplitude},
      {"after", none, "Energy of the mode after the impact, as a share of the energy before", &M::after},
  };
  return all;
}

}  // namespace stoss::quasistatic
