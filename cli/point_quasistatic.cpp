// What stoss quasistatic says of a sphere.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interrupt.hpp"
#include "quasistatic.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic.hpp"
#include "tables.hpp"

namespace stoss::cli {
namespace {

using namespace quasistatic;

constexpr int nodes = 80;  // of the static contact: a row takes 0.1 s, its force is good to 1e-4

PointLaw to_law(const std::string& law) {
  if (law == "center") return PointLaw::center;
  if (law == "hertz") return PointLaw::hertz;
  throw InvalidInput(fmt::format("law: got {} with --body sphere, allowed center or hertz", law));
}

}  // namespace

QuasistaticBody point_quasistatic(const Encounter& sphere, const std::string& chosen) {
  const PointLaw law = to_law(chosen);
  const Units units = units_of(sphere);
  const double poisson = std::get<Sphere>(first_solid(sphere)).poisson;
  const double last_force = limit_force(law, poisson);
  QuasistaticBody body{units, poisson, {}, std::min(compression(law, poisson, last_force), greatest_compression),
                       {},    {}};
  body.speeds = {min_point_speed, limit_speed(law, poisson),
                 "of the centre of mass, 1e-12 c to where the static law ends"};
  body.impacts = [=](double cutoff) {
    return [=, modes = bodies::sphere::modes(poisson, cutoff)](double speed, Record& record) -> SlowRow {
      PointRayleighEstimate estimate = rayleigh(law, poisson, speed, modes, heed_interrupts);
      add_quantities(record, point_rayleigh_table(), estimate, units);
      return {estimate.beyond_perturbation, std::move(estimate.modes)};
    };
  };
  body.compress = [=](double compression, Record& record) {
    // The rounding of the inversion must not lead beyond the last force.
    const double force = std::min(compression_force(law, poisson, compression), last_force);
    const StaticContactOptions options{nodes, heed_interrupts};
    const Compressed result{compression, force, compression_energy(law, poisson, force),
                            contact_radius(law, poisson, force),
                            static_contact(Sphere{.poisson = poisson}, compression, options)};
    add_quantities(record, point_compression_table(), result, units);
  };
  body.yield_speed = stoss::yield_speed(sphere);
  return body;
}

}  // namespace stoss::cli
