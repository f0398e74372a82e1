#include "stoss/encounter/materials.hpp"

#include <numbers>
#include <optional>
#include <string>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double hard = 2.0 * std::numbers::pi * 1e4;    // of contacts that last 50 µs
constexpr double soft = 2.0 * std::numbers::pi * 500.0;  // 1 ms
constexpr double unknown = 0.0;

NamedMaterial made(std::string_view name, double young, double poisson, double density, double yield, double quality,
                   std::string_view source, double frequency = hard) {
  Material material{young, poisson, density};
  if (yield != unknown) material.yield_strength = yield;
  if (quality != unknown) material.loss_time = loss_time_of_quality(quality, frequency);
  return {name, material, quality, frequency, source};
}

}  // namespace

const std::vector<NamedMaterial>& named_materials() {
  static const std::vector<NamedMaterial> all{
      made("steel", 2.1e11, 0.30, 7850.0, unknown, 3000.0, "structural steel, Eurocode 3"),
      made("glass", 7.0e10, 0.22, 2500.0, unknown, 1000.0,
           "soda-lime glass, EN 572-1; nu between the 0.20 there and the 0.23 of makers"),
      made("ice", 9.3e9, 0.33, 917.0, unknown, 200.0,
           "polycrystalline, at -16 C: Gammon et al., J. Glaciology 29, 433 (1983)"),
      made("rubber", 2e6, 0.49, 1100.0, unknown, 10.0, "soft rubber, orders of magnitude", soft),
      made("bearing steel", 2.1e11, 0.30, 7810.0, 1.7e9, 3000.0, "hardened, typical without a single source"),
      made("brass", 1.1e11, 0.33, 8530.0, 4.3e8, 2000.0, "hard-drawn CuZn30, engineering tables"),
      made("aluminium", 6.9e10, 0.33, 2700.0, 2.8e8, 10000.0, "6061-T6, engineering tables"),
      made("tungsten carbide", 6.2e11, 0.22, 14900.0, unknown, unknown,
           "6 % of cobalt, typical without a single source"),
      made("granite", 5e10, 0.25, 2650.0, unknown, 100.0, "typical without a single source; E from 20 to 70 GPa"),
      made("PMMA", 3.2e9, 0.37, 1190.0, unknown, 30.0,
           "typical without a single source; its modulus grows with the rate of loading"),
      made(
          "PVB", 5.7e8, 0.45, 1070.0, unknown, 12.0,
          "interlayer of laminated glass, at 10 kHz and 20 C: Van Duser et al., J. Eng. Mech. 125, 435 (1999); softens "
          "with heat and time"),
  };
  return all;
}

const Material& named_material(std::string_view name) {
  std::string names;
  for (const NamedMaterial& each : named_materials()) {
    if (each.name == name) return each.material;
    names += (names.empty() ? "" : ", ") + std::string(each.name);
  }
  throw InvalidInput("material: got '" + std::string(name) + "', allowed " + names + ", or numbers of your own");
}

}  // namespace stoss
