#include "stoss/encounter/materials.hpp"

#include <cctype>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double hard = 2.0 * std::numbers::pi * 1e4;    // of contacts that last 50 µs
constexpr double soft = 2.0 * std::numbers::pi * 500.0;  // 1 ms
constexpr double unknown = 0.0;

/// A material without what only some know.
NamedMaterial made(std::string_view name, const Material& material, double quality, std::string_view source,
                   double frequency = hard) {
  NamedMaterial named{name, material, source, {}, {}, {}, false};
  named.material.frequency = frequency;
  if (quality != unknown) named.material.quality = quality;
  named.uncertainties.young = 0.05, named.uncertainties.poisson = 0.05, named.uncertainties.density = 0.01;
  if (quality != unknown) named.uncertainties.loss = 2.0;
  return named;
}

NamedMaterial with_strength(NamedMaterial named, double strength, double uncertainty, std::string_view source) {
  named.material.yield_strength = strength;
  named.uncertainties.yield_strength = uncertainty;
  named.strength_source = source;
  return named;
}

NamedMaterial with_surface(NamedMaterial named, double energy, double uncertainty, std::string_view source) {
  named.material.surface_energy = energy;
  named.uncertainties.surface_energy = uncertainty;
  named.surface_source = source;
  return named;
}

NamedMaterial varying(NamedMaterial named, double young, double poisson, double density) {
  named.uncertainties.young = young, named.uncertainties.poisson = poisson, named.uncertainties.density = density;
  return named;
}

/// A material that has its spectrum: its modulus is E(0) then, and what is given the one at its frequency.
NamedMaterial with_spectrum(NamedMaterial named, Relaxation spectrum) {
  named.material.young /= std::abs(modulus(spectrum, {0.0, named.material.frequency}));
  named.material.relaxation = std::move(spectrum);
  return named;
}

/// Shear relaxation of PVB at 20 C, Van Duser et al. (1999); Poisson's ratio is taken as constant.
Relaxation of_pvb() {
  return {{{0.1606, 3.2557e-11},
           {0.0787777, 4.9491e-9},
           {0.2912, 7.2427e-8},
           {0.0711155, 9.8635e-6},
           {0.2688, 2.8059e-3},
           {0.0895860, 1.6441e-1},
           {0.0301830, 2.2648},
           {0.0076056, 3.5364e1},
           {0.00096343, 9.3675e3},
           {0.00040592, 6.4141e5},
           {0.00061430, 4.1347e7}}};
}

/// |E| ∝ √ω from 1 Hz to 100 kHz, where tan δ is then about 1: a term a decade.
Relaxation of_damped_rubber() {
  Relaxation made;
  double sum = 0.0;
  for (int decade = -7; decade <= 0; ++decade) {
    made.terms.push_back({std::pow(10.0, -0.5 * decade), std::pow(10.0, decade)});
    sum += made.terms.back().share;
  }
  constexpr double left = 0.999;
  for (RelaxationTerm& term : made.terms) term.share *= left / sum;
  return made;
}

/// What cracks, roughness, frost and water let lose far more than waves and the sound material do
/// (docs/understand/measured.md).
NamedMaterial if_sound(NamedMaterial named) {
  named.sound = true;
  return named;
}

}  // namespace

const std::vector<NamedMaterial>& named_materials() {
  static const std::vector<NamedMaterial> all{
      with_strength(varying(made("structural steel", {2.1e11, 0.30, 7850.0}, 3000.0, "structural steel, Eurocode 3"),
                            0.03, 0.03, 0.01),
                    2.35e8, 0.5, "the least of S235, EN 10025; most samples have more"),
      if_sound(with_surface(varying(made("glass", {7.0e10, 0.22, 2500.0}, 1000.0,
                                         "soda-lime glass, EN 572-1; nu between the 0.20 there and the 0.23 of makers"),
                                    0.04, 0.1, 0.01),
                            0.03, 3.0, "order of magnitude of glass in air; clean in vacuum it is ten times as much")),
      if_sound(with_surface(
          varying(made("ice", {9.3e9, 0.33, 917.0}, 200.0,
                       "polycrystalline, at -16 C: Gammon et al., J. Glaciology 29, 433 (1983); stiffer by "
                       "0.14 % for each degree colder"),
                  0.03, 0.03, 0.005),
          0.19, 0.5, "from rolling of micrometre spheres: Gundlach et al., arXiv:1102.0430 (2011)")),
      with_surface(
          varying(made("rubber", {2e6, 0.49, 1100.0}, 10.0, "soft rubber, orders of magnitude", soft), 2.0, 0.01, 0.1),
          0.035, 0.5, "order of magnitude of polymers in air"),
      with_surface(varying(made("bouncy rubber", {4e6, 0.49, 1000.0}, 15.0,
                                "polybutadiene as of superballs, typical without a single source; from a rebound of "
                                "some 80 % of the height",
                                soft),
                           1.0, 0.01, 0.1),
                   0.035, 0.5, "order of magnitude of polymers in air"),
      with_spectrum(
          varying(made("damped rubber", {1e7, 0.49, 1000.0}, unknown,
                       "rubber near its glass transition, as polynorbornene or butyl, idealised: its modulus grows as "
                       "the root of the frequency from 1 Hz on, with a tan delta of 1, and is 10 MPa at 500 Hz, an "
                       "order of magnitude",
                       soft),
                  2.0, 0.01, 0.1),
          of_damped_rubber()),
      with_strength(
          varying(made("bearing steel", {2.1e11, 0.30, 7810.0}, 3000.0, "hardened, typical without a single source"),
                  0.03, 0.03, 0.01),
          1.7e9, 0.2, "hardened 100Cr6, typical without a single source"),
      with_strength(varying(made("brass", {1.1e11, 0.33, 8530.0}, 2000.0, "hard-drawn CuZn30, engineering tables"),
                            0.05, 0.05, 0.01),
                    4.3e8, 0.2, "hard-drawn, engineering tables"),
      with_strength(
          varying(made("aluminium", {6.9e10, 0.33, 2700.0}, 10000.0, "6061-T6, engineering tables"), 0.02, 0.03, 0.01),
          2.8e8, 0.1, "6061-T6, engineering tables"),
      varying(made("alumina", {3.8e11, 0.23, 4000.0}, unknown,
                   "sintered, as in benchmarks of DEM codes after Kharaz et al., Powder Technol. 120, 281 (2001)"),
              0.05, 0.1, 0.03),
      made("tungsten carbide", {6.2e11, 0.22, 14900.0}, unknown, "6 % of cobalt, typical without a single source"),
      if_sound(
          varying(made("granite", {5e10, 0.25, 2650.0}, 100.0, "typical without a single source; E from 20 to 70 GPa"),
                  0.4, 0.2, 0.03)),
      varying(made("PMMA", {3.2e9, 0.37, 1190.0}, 30.0,
                   "typical without a single source; its modulus grows with the rate of loading"),
              0.2, 0.05, 0.01),
      with_strength(varying(made("PE", {1.1e9, 0.42, 955.0}, 15.0,
                                 "high-density polyethylene, typical without a single source; its modulus grows with "
                                 "the rate of loading"),
                            0.5, 0.05, 0.01),
                    2.5e7, 0.3, "typical without a single source; grows with the rate of loading"),
      with_strength(varying(made("PA", {3e9, 0.39, 1140.0}, 30.0,
                                 "polyamide 6 or 66, dry, typical without a single source; moist it has a third"),
                            0.3, 0.05, 0.01),
                    8e7, 0.2, "dry, typical without a single source"),
      with_strength(
          varying(made("POM", {2.9e9, 0.37, 1410.0}, 40.0, "polyoxymethylene, typical without a single source"), 0.15,
                  0.05, 0.01),
          6.5e7, 0.15, "typical without a single source"),
      varying(made("phenolic resin", {5.8e9, 0.34, 1700.0}, 50.0,
                   "cast, as of billiard balls, typical without a single source"),
              0.3, 0.1, 0.05),
      with_spectrum(
          varying(
              made(
                  "PVB", {5.7e8, 0.45, 1070.0}, unknown,
                  "interlayer of laminated glass, at 10 kHz and 20 C: Van Duser et al., J. Eng. Mech. 125, 435 (1999); "
                  "softens with heat and time"),
              0.3, 0.05, 0.01),
          of_pvb()),
  };
  return all;
}

const Material& named_material(std::string_view name) { return material_of_the_list(name).material; }

const NamedMaterial& material_of_the_list(std::string_view name) {
  const auto lower = [](std::string_view text) {
    std::string made(text);
    for (char& c : made) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return made;
  };
  std::string names;
  std::vector<std::string> all;
  for (const NamedMaterial& each : named_materials()) {
    if (lower(each.name) == lower(name)) return each;
    all.emplace_back(each.name);
    names += (names.empty() ? "" : ", ") + all.back();
  }
  // In version 1.0 "steel" was the structural one, which hardly any ball is made of.
  if (lower(name) == "steel") {
    throw InvalidInput::out_of_range("material", "'steel'",
                                     "'structural steel' (yields at 235 MPa) or 'bearing steel' (at 1.7 GPa): their "
                                     "yield speeds differ by a factor of 140");
  }
  std::string similar = nearest(name, all);
  if (similar.empty() && !nearest(name, {"steel"}).empty()) similar = "structural steel or bearing steel";
  throw InvalidInput::out_of_range(
      "material", in_quotes(name),
      names + ", or numbers of your own" + (similar.empty() ? "" : ", did you mean " + similar + "?"));
}

}  // namespace stoss
