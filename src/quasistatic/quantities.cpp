#include "stoss/quasistatic/quantities.hpp"

#include "quantity_help.hpp"

namespace stoss::quasistatic {

using enum Dimension;

namespace {

struct WithError {
  double value, error;
};

template <typename Estimate>
WithError lost_fraction(const Estimate& of) {
  return {of.lost_fraction, of.lost_fraction_error};
}

/// What all slow impacts have.
template <typename Impact>
Quantities<Impact> of_slow_impact() {
  return {
      {"contact_time", time, help::slow_contact_time, &Impact::contact_time},
      {"max_compression", length, help::slow_max_compression, &Impact::max_compression},
      {"max_force", force, help::max_force, &Impact::max_force},
  };
}

/// Those of Rayleigh's estimate, with those of the impact that drives the modes.
template <typename Estimate, typename Impact>
Quantities<Estimate> of_estimate(Quantities<Estimate> quantities, const Quantities<Impact>& of_impacts) {
  for (const Quantity<Impact>& of_impact : of_impacts) {
    quantities.emplace_back(of_impact.name, of_impact.dimension, of_impact.help,
                            [value = of_impact.value](const Estimate& e) { return value(e.impact); });
  }
  quantities.emplace_back("kinetic_share", none,
                          "Maximum kinetic energy of the modes as they follow the force, over the energy before",
                          &Estimate::kinetic_share);
  quantities.emplace_back("beyond_perturbation", none, "Whether the modes move too much for perturbation theory",
                          &Estimate::beyond_perturbation);
  quantities.emplace_back("modes", none, "Number of modes that the impact drives",
                          [](const Estimate& e) { return static_cast<long>(e.modes.size()); });
  return quantities;
}

}  // namespace

const Quantities<SlowImpact>& slow_impact_quantities() {
  static const Quantities<SlowImpact> all = of_slow_impact<SlowImpact>();
  return all;
}

const Quantities<PointSlowImpact>& point_slow_impact_quantities() {
  static const Quantities<PointSlowImpact> all = [] {
    auto quantities = of_slow_impact<PointSlowImpact>();
    quantities.emplace_back("max_radius", length, help::max_radius, &PointSlowImpact::max_radius);
    return quantities;
  }();
  return all;
}

const Quantities<RayleighEstimate>& rayleigh_quantities() {
  using E = RayleighEstimate;
  static const Quantities<E> all =
      of_estimate<E>({{"lost_fraction", none, help::lost_fraction, lost_fraction<E>}}, slow_impact_quantities());
  return all;
}

const Quantities<PointRayleighEstimate>& point_rayleigh_quantities() {
  using E = PointRayleighEstimate;
  static const Quantities<E> all =
      of_estimate<E>({{"lost_fraction", none, help::lost_fraction, lost_fraction<E>},
                      {"mean_lost_fraction", none,
                       "Mean of the lost fraction over phases, without interference of compression and release",
                       &E::mean_lost_fraction}},
                     point_slow_impact_quantities());
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
