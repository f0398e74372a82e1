// stoss quasistatic: slow impacts and static compression, in closed form where there is one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "app.hpp"
#include "commands/quasistatic.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/errors.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/restitution/restitution.hpp"

namespace stoss::cli {
namespace {

using namespace quasistatic;

struct QuasistaticArguments {
  EncounterOptions encounter;
  std::string speeds;
  std::string compressions;
  std::string law = "center";
  double cutoff = 60.0;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// A body that is pressed to a wall: by the law of compression, and as the exact static contact has it.
struct Compressed {
  double compression = 0.0;
  double force = 0.0;
  double energy = 0.0;
  double half_width = 0.0;
  StaticContact contact;
};

template <typename Of>
Fields<Compressed> compressed_fields(const Units& units) {
  using C = Compressed;
  using enum Dimension;
  const auto static_force = [](const C& c) { return Estimate{c.contact.force, c.contact.force_error}; };
  const Quantities<C> quantities{
      {"compression", length, "Compression of the body", &C::compression},  //
      {"force", force, "Force of the contact", &C::force},                  //
      {"energy", energy, "Energy of the compression", &C::energy},          //
      {Of::size, length, "Size of the contact", &C::half_width},            //
      {"static_force", force, "Force of the static contact, computed", static_force},
  };
  return Fields<C>(quantities, units,
                   {{"compression", {.width = 13, .si_width = 16}},
                    {"force", {.width = 13, .si_width = 13}},
                    {"energy", {.width = 13, .si_width = 13}},
                    {Of::size, {.width = Of::width, .si_width = Of::width + 3}},
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

/// A number of rows that are written one by one, until Ctrl-C.
void write_rows(const OutputOptions& output, Writer& writer, std::size_t count,
                const std::function<Row(std::size_t, const Poll&)>& make) {
  Progress progress(output, count);
  Progress all(output, 1);  // of rows that each take little
  writer.finish_after([&] {
    for (std::size_t i = 0; i < count; ++i) {
      const Poll poll = [&] {
        heed_interrupts();
        all.wait(fmt::format("row {} of {}", i + 1, count));
      };
      poll();
      writer.add(make(i, poll));
      progress.show(i + 1);
    }
  });
}

/// As typed, in units of the body, of an input whose range ends where a law does.
std::vector<double> series_within(std::string_view name, Dimension dimension, double low, double high,
                                  std::string_view help, const std::string& text, const Units& units) {
  const std::string range = fmt::format("{:g} to {:.6g}", low, std::floor(high * 1e6) / 1e6);
  const Input input{name, dimension, {}, low, high, true, true, range, help, {}};
  return series_of(input, text, units);
}

/// Computes an impact at a speed. @param cutoff of the modes that take the energy
template <typename Of>
auto computing(const Of& of, double cutoff, const Poll& poll) {
  return [of, modes = of.modes(cutoff, poll)](double speed, const Poll& at) {
    return rayleigh(of.law, of.poisson, speed, modes, at);
  };
}

auto computing(const BlockContact& of, double /*cutoff*/, const Poll& /*poll*/) {
  return [of](double speed, const Poll& /*poll*/) { return half_space_radiation(of.law, of.bodies, speed); };
}

template <typename Of>
void impacts(const QuasistaticArguments& arguments, const Of& of, const Encounter& encounter, Provenance provenance) {
  const Yielding yielding = cli::yielding(encounter);
  const Units& units = yielding.units;
  const OutputOptions& output = arguments.output;
  const std::vector<double> speeds = series_within("speed", Dimension::speed, of.slowest, of.fastest,
                                                   "Of the centre of mass", arguments.speeds, units);
  constexpr bool by_modes = requires { of.last_force; };  // a half-space has a continuum of them
  if (by_modes) provenance.inputs["cutoff"] = arguments.cutoff;
  const auto fields = estimate_fields(of.quantities(), units);
  Columns columns{{"poisson"}};
  append(columns, speed_columns(units), fields.columns(), yielding.columns());
  Writer writer = output.writer(provenance, columns);
  catch_interrupts();
  const auto compute = computing(of, arguments.cutoff, waiting(output, "modes"));
  std::size_t beyond = 0;
  write_rows(output, writer, speeds.size(), [&](std::size_t i, const Poll& poll) {
    const auto its = compute(speeds[i], poll);
    beyond += its.beyond_perturbation ? 1 : 0;
    if constexpr (by_modes) {
      if (speeds.size() == 1 && output.chosen_format() == Format::json) {
        writer.attach("modes", to_json(driven_mode_quantities(), its.modes));
      }
    }
    Row row{of.poisson};
    append(row, speed_row(units, speeds[i]), fields.row(its), yielding.row(speeds[i]));
    return row;
  });
  if (beyond > 0) {
    output.warn(fmt::format(
        "{} of {} rows beyond perturbation theory (marked): lost_fraction is {} (see stoss restitution)", beyond,
        speeds.size(), by_modes ? "no estimate there, but far too large" : "known no better than to a tenth there"));
  }
  warn_of_materials(output, encounter, *std::max_element(speeds.begin(), speeds.end()));
}

void refuse_with(const QuasistaticArguments& arguments, const std::string& name, const std::string& other,
                 const std::string& allowed, const std::string& hint) {
  if (!given(*arguments.command, "--" + name)) return;
  throw InvalidInput::out_of_range(name, fmt::format("--{} with --{}", name, other), allowed, hint);
}

template <typename Of>
void compressions(const QuasistaticArguments& arguments, const Of& of, const Yielding& yielding,
                  const Provenance& provenance) {
  refuse_with(arguments, "cutoff", "compression", "only with --speed", "here all modes count");
  const OutputOptions& output = arguments.output;
  constexpr double least = 1e-12, greatest = 0.5;  // of a static contact, R
  const std::vector<double> values = series_within(
      "compression", Dimension::length, least, std::min(compression(of.law, of.poisson, of.last_force), greatest),
      "Beyond, a law or a contact ends", arguments.compressions, yielding.units);
  catch_interrupts();
  const auto fields = compressed_fields<Of>(yielding.units);
  Columns columns{{"poisson"}};
  append(columns, fields.columns());
  Writer writer = output.writer(provenance, columns);
  write_rows(output, writer, values.size(), [&](std::size_t i, const Poll& poll) {
    // The rounding of the inversion must not lead beyond the last force.
    const double force = std::min(compression_force(of.law, of.poisson, values[i]), of.last_force);
    const double energy = compression_energy(of.law, of.poisson, force);
    Row row{of.poisson};
    append(row, fields.row({values[i], force, energy, of.half_width(force), of.exact(values[i], poll)}));
    return row;
  });
  constexpr double great_compression = 0.1;  // beyond it small strains mean little
  const auto great = std::count_if(values.begin(), values.end(), [](double v) { return v > great_compression; });
  if (great > 0) {
    output.warn(fmt::format("{} of {} compressions above {} R: linear elasticity means little there", great,
                            values.size(), great_compression));
  }
}

void run(const QuasistaticArguments& arguments) {
  const bool speeds = given(*arguments.command, "--speed");
  if (!speeds && !given(*arguments.command, "--compression")) throw CLI::RequiredError("--speed or --compression");
  const Encounter encounter = arguments.encounter.encounter();
  const auto contact = slow_contact(encounter, arguments.law);
  if (std::holds_alternative<BlockContact>(contact)) {
    refuse_with(arguments, "compression", "against half-space", "only at a wall", "static contacts are at a wall");
    refuse_with(arguments, "cutoff", "against half-space", "only at a wall", "a half-space takes all frequencies");
  }
  Provenance provenance = cli::provenance(*arguments.command, encounter);
  provenance.inputs["law"] = arguments.law;
  const auto write = [&](const auto& of) {
    if constexpr (requires { of.last_force; }) {
      if (!speeds) return compressions(arguments, of, yielding(encounter), provenance);
    }
    impacts(arguments, of, encounter, provenance);
  };
  std::visit(write, contact);
}

}  // namespace

void add_quasistatic(CLI::App& app) {
  auto& arguments = add_subcommand<QuasistaticArguments>(
      app, "quasistatic", "Slow impacts with an estimate of the loss, or static compression", run,
      "Examples:\n"
      "  stoss quasistatic --body disk --poisson 0.33 --speed log:1e-6:0.1:50\n"
      "  stoss quasistatic --body disk --poisson 0.33 --speed 1e-12 --format json\n"
      "  stoss quasistatic --body disk --poisson 0.33 --compression lin:0.001:0.03:20\n"
      "  stoss quasistatic --body sphere --poisson 0.3 --speed log:1e-9:0.01:50\n"
      "  stoss quasistatic --body sphere --poisson 0.3 --speed log:1e-9:0.01:50 --against half-space\n"
      "Two equal bodies that each move at SPEED towards each other are the same problem.");
  CLI::App& command = *arguments.command;
  BodyOptions& body = arguments.encounter.first;
  body.add_kind_to(command, {"disk", "sphere"});
  body.add_poisson_to(command);
  body.add_material_to(command);
  auto* speed = add(command, "--speed", arguments.speeds,
                    "Slow impacts at these speeds, in c (m/s with a material): a number,\n"
                    "a,b,c, log:a:b:n or lin:a:b:n; 1e-100 c (of a sphere 1e-12 c) to\n"
                    "0.16 c or more, where the law ends",
                    "SPEEDS", "Body");
  add(command, "--compression", arguments.compressions,
      "In place of --speed: static contacts at these compressions, in R\n"
      "(m with a material): a number, a,b,c, log:a:b:n or lin:a:b:n; 1e-12\n"
      "to 0.2 or more, where the law or the contact ends (at most 0.5 R).\n"
      "Gives force, energy and half-width or radius of the contact by the\n"
      "law, and the force of the exact static contact with its error",
      "DELTAS", "Body")
      ->excludes(speed);
  add(command, "--against", arguments.encounter.against,
      "What the body meets at the speeds (default: wall); numbers in units of\n"
      "the body, or in SI if it has a material\n"
      "  wall: a rigid wall; the vibration of the body takes the energy\n"
      "  half-space: of a sphere, a large block, whose waves take the energy,\n"
      "   keys poisson, young, density, material, c_p, c_s",
      "{wall,half-space}[,KEY=VALUE]...", "Against");
  add_choice(command, "--law", arguments.law, {"center", "diameter", "hertz"},
             "Force against compression (default: center)\n"
             "  center:   approach of the centre of mass to the wall\n"
             "  diameter: of a disk, shortening of the diameter between two walls\n"
             "  hertz:    of a sphere, two half-spaces",
             "LAW", "Body");
  add(command, "--cutoff", arguments.cutoff,
      "With --speed: highest frequency in Rayleigh's estimate, in c/R,\nup to 1000 (default: 60)", "OMEGA",
      "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
