// A rigid body: no modes, no compliance, no waves.
#include "stoss/bodies/anvil.hpp"

#include <cmath>

#include "stoss/bodies/rod.hpp"

namespace stoss {

BodyMaker anvil(const Anvil& anvil) {
  (void)rod({anvil.length, anvil.young, anvil.density, anvil.area});  // refuses what is out of range
  return [anvil](double cutoff, const Poll&) {
    Body body;
    body.name = "anvil";
    body.contour = Contour::flat;
    body.mass = 1.0;
    const double mass = anvil.density * anvil.area * anvil.length;
    body.scale = {anvil.length, std::sqrt(anvil.young / anvil.density), mass};
    body.extent = 0.5;
    body.softness = 0.0;
    body.cutoff = cutoff;
    constexpr double beyond_any = 1e100;  // so that only the other body's impedance counts in series
    body.surface = [](const ContactPoints&) {
      return Surface{.recess = {0.0}, .measure = {1.0}, .impedance = {beyond_any}, .shape = {}};
    };
    const auto none = [](const ContactPoints&, const Poll&) { return std::vector{0.0}; };
    body.residual_compliance = none;
    body.residual_second_moment = none;
    return body;
  };
}

}  // namespace stoss
