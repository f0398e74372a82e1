// A rigid body: no modes, no compliance, no waves.
#include "stoss/bodies/anvil.hpp"

#include "check.hpp"

namespace stoss {

BodyMaker anvil(const Anvil& anvil) {
  require("mass", anvil.mass, {0.0, 1e100, false, true, "above 0"}, "of the anvil, as rods have it");
  return [anvil](double cutoff, const Poll&) {
    Body body;
    body.name = "anvil";
    body.contour = Contour::flat;
    body.mass = 1.0;
    body.scale = {1.0, 1.0, anvil.mass};
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
