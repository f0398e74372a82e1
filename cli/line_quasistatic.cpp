// What stoss quasistatic says of a disk.
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

CompressionLaw to_law(const std::string& law) {
  if (law == "center") return CompressionLaw::center;
  if (law == "diameter") return CompressionLaw::diameter;
  if (law == "printed") return CompressionLaw::printed;
  throw InvalidInput(fmt::format("law: got {} with --body disk, allowed center, diameter or printed", law));
}

}  // namespace

QuasistaticBody line_quasistatic(const Encounter& disk, const std::string& chosen) {
  const CompressionLaw law = to_law(chosen);
  const Units units = units_of(disk);
  const double poisson = std::get<Disk>(first_solid(disk)).poisson;
  const double last_force = std::min(limit_force(law, poisson), max_hertz_force);
  QuasistaticBody body{units, poisson, {}, std::min(compression(law, poisson, last_force), greatest_compression),
                       {},    {}};
  body.speeds = {min_slow_speed, limit_speed(law, poisson),
                 "of the centre of mass, 1e-100 c to where the static law ends"};
  body.impacts = [=](double cutoff) {
    return [=, modes = bodies::disk::modes(poisson, cutoff)](double speed, Record& record) -> SlowRow {
      RayleighEstimate estimate = rayleigh(law, poisson, speed, modes, heed_interrupts);
      add_quantities(record, rayleigh_table(), estimate, units);
      return {estimate.beyond_perturbation, std::move(estimate.modes)};
    };
  };
  body.compress = [=](double compression, Record& record) {
    // The rounding of the inversion must not lead beyond the last force.
    const double force = std::min(compression_force(law, poisson, compression), last_force);
    const Compressed result{compression, force, compression_energy(law, poisson, force), hertz_half_width(force),
                            static_contact(poisson, compression, {.poll = heed_interrupts})};
    add_quantities(record, compression_table(), result, units);
  };
  return body;
}

}  // namespace stoss::cli
