// What stoss quasistatic says of a disk and of a sphere.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "commands/quasistatic.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/quasistatic/quantities.hpp"

namespace stoss::cli {
namespace {

using namespace quasistatic;

CompressionLaw line_law(const std::string& law) {
  if (law == "center") return CompressionLaw::center;
  if (law == "diameter") return CompressionLaw::diameter;
  if (law == "printed") return CompressionLaw::printed;
  throw InvalidInput(fmt::format("law: got {} with --body disk, allowed center, diameter or printed", law));
}

PointLaw point_law(const std::string& law) {
  if (law == "center") return PointLaw::center;
  if (law == "hertz") return PointLaw::hertz;
  throw InvalidInput(fmt::format("law: got {} with --body sphere, allowed center or hertz", law));
}

/// A body that is pressed to a wall: by the law of compression, and as the exact static contact has it.
struct Compressed {
  double compression = 0.0;
  double force = 0.0;
  double energy = 0.0;
  double half_width = 0.0;  ///< of a sphere, radius of the contact
  StaticContact contact;
};

/// @param size what the half-width is called, and how it is shown
Fields<Compressed> compressed_fields(const Units& units, const std::string& size, const Shown& shown) {
  using C = Compressed;
  using enum Dimension;
  const auto static_force = [](const C& c) { return Estimate{c.contact.force, c.contact.force_error}; };
  const Quantities<C> quantities{
      {"compression", length, &C::compression},  //
      {"force", force, &C::force},               //
      {"energy", energy, &C::energy},            //
      {size, length, &C::half_width},            //
      {"static_force", force, static_force},
  };
  return Fields<C>(quantities, units,
                   {{"compression", {.width = 13, .si_width = 16}},
                    {"force", {.width = 13, .si_width = 13}},
                    {"energy", {.width = 13, .si_width = 13}},
                    {size, shown},
                    {"static_force", {.width = 25, .si_width = 17, .with_error = true}}});
}

template <typename Made>
Fields<Made> estimate_fields(const Quantities<Made>& quantities, const Units& units) {
  return Fields<Made>(quantities, units,
                      {{"lost_fraction", {.width = 24, .with_error = true, .mark = {{"beyond_perturbation", true}}}},
                       {"contact_time", {.width = 14, .si_width = 17}},
                       {"max_compression", {.width = 17, .si_width = 20}},
                       {"max_force", {.width = 13}}});
}

/// What a kind of body has of its own: where its law ends, its modes up to a cutoff, the half-width of its contact
/// under a force, and its exact static contact at a compression.
template <typename Law, typename Modes, typename HalfWidth, typename Exact>
struct Laws {
  Law law;
  double poisson, last_force;
  Modes modes;
  HalfWidth half_width;
  Exact exact;
};
template <typename Law, typename Modes, typename HalfWidth, typename Exact>
Laws(Law, double, double, Modes, HalfWidth, Exact) -> Laws<Law, Modes, HalfWidth, Exact>;  // clang 14 needs it

template <typename Of, typename Made>
QuasistaticBody body_of(const Of& of, Allowed speeds, const Fields<Made>& impact, const Fields<Compressed>& contact) {
  const double last = compression(of.law, of.poisson, of.last_force);
  QuasistaticBody body{
      of.poisson, std::move(speeds), std::min(last, greatest_compression), impact.columns(), {}, contact.columns(), {}};
  body.impacts = [of, impact](double cutoff) {
    return [of, impact, modes = of.modes(cutoff)](double speed) -> SlowImpactRow {
      const Made estimate = rayleigh(of.law, of.poisson, speed, modes, heed_interrupts);
      return {impact.row(estimate), estimate.beyond_perturbation, estimate.modes};
    };
  };
  body.compress = [of, contact](double compression) {
    // The rounding of the inversion must not lead beyond the last force.
    const double force = std::min(compression_force(of.law, of.poisson, compression), of.last_force);
    return contact.row({compression, force, compression_energy(of.law, of.poisson, force), of.half_width(force),
                        of.exact(compression)});
  };
  return body;
}

QuasistaticBody of_disk(double poisson, CompressionLaw law, const Units& units) {
  const Laws laws{law,
                  poisson,
                  std::min(limit_force(law, poisson), max_hertz_force),
                  [=](double cutoff) { return bodies::disk::modes(poisson, cutoff); },
                  [](double force) { return hertz_half_width(force); },
                  [=](double delta) { return static_contact(poisson, delta, {.poll = heed_interrupts}); }};
  return body_of(
      laws, {min_slow_speed, limit_speed(law, poisson), "of the centre of mass, 1e-100 c to where the static law ends"},
      estimate_fields(rayleigh_quantities(), units),
      compressed_fields(units, "half_width", {.width = 12, .si_width = 15}));
}

QuasistaticBody of_sphere(double poisson, PointLaw law, const Units& units) {
  const auto exact = [=](double delta) {
    constexpr int nodes = 80;  // a row takes 0.1 s, its force is good to 1e-4
    return static_contact(Sphere{.poisson = poisson}, delta, StaticContactOptions{nodes, heed_interrupts});
  };
  const Laws laws{law,
                  poisson,
                  limit_force(law, poisson),
                  [=](double cutoff) { return bodies::sphere::modes(poisson, cutoff); },
                  [=](double force) { return contact_radius(law, poisson, force); },
                  exact};
  return body_of(
      laws, {min_point_speed, limit_speed(law, poisson), "of the centre of mass, 1e-12 c to where the static law ends"},
      estimate_fields(point_rayleigh_quantities(), units),
      compressed_fields(units, "contact_radius", {.width = 16, .si_width = 19}));
}

}  // namespace

QuasistaticBody quasistatic_body(const Encounter& encounter, const std::string& law) {
  const Units units = units_of(encounter);
  const Solid solid = first_solid(encounter);
  if (const auto* sphere = std::get_if<Sphere>(&solid)) return of_sphere(sphere->poisson, point_law(law), units);
  return of_disk(std::get<Disk>(solid).poisson, line_law(law), units);
}

}  // namespace stoss::cli
