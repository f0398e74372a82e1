#include "stoss/quasistatic/point_quantities.hpp"

namespace stoss::quasistatic {

using enum Dimension;

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
    const auto lost = [](const E& e) {
      struct {
        double value, error;
      } const with_error{e.lost_fraction, e.lost_fraction_error};
      return with_error;
    };
    Quantities<E> quantities{{"lost_fraction", none, lost}, {"mean_lost_fraction", none, &E::mean_lost_fraction}};
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

}  // namespace stoss::quasistatic
