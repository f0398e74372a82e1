#include "stoss/quasistatic/point_quantities.hpp"

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

}  // namespace

const Quantities<PointSlowImpact>& point_slow_impact_quantities() {
  using S = PointSlowImpact;
  static const Quantities<S> all{
      {"contact_time", time, &S::contact_time},
      {"max_compression", length, &S::max_compression},
      {"max_force", force, &S::max_force},
      {"max_radius", length, &S::max_radius},
  };
  return all;
}

const Quantities<PointRayleighEstimate>& point_rayleigh_quantities() {
  using E = PointRayleighEstimate;
  static const Quantities<E> all = [] {
    Quantities<E> quantities{{"lost_fraction", none, lost_fraction<E>},
                             {"mean_lost_fraction", none, &E::mean_lost_fraction}};
    for (const auto& of_impact : point_slow_impact_quantities()) {
      quantities.emplace_back(of_impact.name, of_impact.dimension,
                              [value = of_impact.value](const E& e) { return value(e.impact); });
    }
    quantities.emplace_back("kinetic_share", none, &E::kinetic_share);
    quantities.emplace_back("beyond_perturbation", none, &E::beyond_perturbation);
    quantities.emplace_back("modes", none, [](const E& e) { return static_cast<long>(e.modes.size()); });
    return quantities;
  }();
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
