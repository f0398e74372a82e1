#include "stoss/quasistatic/quantities.hpp"

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
      {"contact_time", time, &Impact::contact_time},
      {"max_compression", length, &Impact::max_compression},
      {"max_force", force, &Impact::max_force},
  };
}

/// Those of Rayleigh's estimate, with those of the impact that drives the modes.
template <typename Estimate, typename Impact>
Quantities<Estimate> of_estimate(Quantities<Estimate> quantities, const Quantities<Impact>& of_impacts) {
  for (const Quantity<Impact>& of_impact : of_impacts) {
    quantities.emplace_back(of_impact.name, of_impact.dimension,
                            [value = of_impact.value](const Estimate& e) { return value(e.impact); });
  }
  quantities.emplace_back("kinetic_share", none, &Estimate::kinetic_share);
  quantities.emplace_back("beyond_perturbation", none, &Estimate::beyond_perturbation);
  quantities.emplace_back("modes", none, [](const Estimate& e) { return static_cast<long>(e.modes.size()); });
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
    quantities.emplace_back("max_radius", length, &PointSlowImpact::max_radius);
    return quantities;
  }();
  return all;
}

const Quantities<RayleighEstimate>& rayleigh_quantities() {
  using E = RayleighEstimate;
  static const Quantities<E> all =
      of_estimate<E>({{"lost_fraction", none, lost_fraction<E>}}, slow_impact_quantities());
  return all;
}

const Quantities<PointRayleighEstimate>& point_rayleigh_quantities() {
  using E = PointRayleighEstimate;
  static const Quantities<E> all =
      of_estimate<E>({{"lost_fraction", none, lost_fraction<E>}, {"mean_lost_fraction", none, &E::mean_lost_fraction}},
                     point_slow_impact_quantities());
  return all;
}

const Quantities<DrivenMode>& driven_mode_quantities() {
  using M = DrivenMode;
  static const Quantities<M> all{
      {"order", none, &M::order},         {"index", none, &M::index}, {"omega", frequency, &M::omega},
      {"amplitude", none, &M::amplitude}, {"after", none, &M::after},
  };
  return all;
}

const Quantities<SoftStaticContact>& soft_static_contact_quantities() {
  using C = SoftStaticContact;
  static const Quantities<C> all{
      {"force", force, &C::force}, {"energy", energy, &C::energy}, {"wall_energy", energy, &C::wall_energy},
      {"modes", none, &C::modes},  {"nodes", none, &C::nodes},     {"newton_steps", none, &C::newton_steps},
  };
  return all;
}

const Quantities<HalfSpaceRadiation>& half_space_radiation_quantities() {
  using R = HalfSpaceRadiation;
  static const Quantities<R> all{
      {"lost_fraction", none, lost_fraction<R>},
      {"contact_time", time, &R::contact_time},
      {"max_compression", length, &R::max_compression},
      {"max_force", force, &R::max_force},
      {"max_radius", length, &R::max_radius},
      {"first_order", none, &R::first_order},
      {"beyond_perturbation", none, &R::beyond_perturbation},
  };
  return all;
}

const Quantities<LossyImpact>& lossy_impact_quantities() {
  using L = LossyImpact;
  static const Quantities<L> all{
      {"restitution", none, &L::restitution},
      {"loss_number", none, &L::loss_number},
      {"contact_time", time, &L::contact_time},
      {"max_compression", length, &L::max_compression},
  };
  return all;
}

}  // namespace stoss::quasistatic
