#include "stoss/quasistatic/quantities.hpp"

namespace stoss::quasistatic {
namespace {

struct LossWithError {
  double value, error;
};

}  // namespace

using enum Dimension;

const Quantities<SlowImpact>& slow_impact_quantities() {
  static const Quantities<SlowImpact> all{
      {"contact_time", time, &SlowImpact::contact_time},
      {"max_compression", length, &SlowImpact::max_compression},
      {"max_force", force, &SlowImpact::max_force},
  };
  return all;
}

const Quantities<RayleighEstimate>& rayleigh_quantities() {
  using E = RayleighEstimate;
  static const Quantities<E> all = [] {
    Quantities<E> quantities{
        {"lost_fraction", none,
         [](const E& e) {
           return LossWithError{e.lost_fraction, e.lost_fraction_error};
         }},
    };
    for (const Quantity<SlowImpact>& of_impact : slow_impact_quantities()) {
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

}  // namespace stoss::quasistatic
