// stoss oblique: the collision rule of bodies that meet at an angle, with spin and friction.
#include "stoss/restitution/oblique_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "app.hpp"
#include "commands/oblique_values.hpp"
#include "input/encounter.hpp"
#include "output/row_run.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

struct ObliqueArguments {
  EncounterOptions who;
  double friction = 0.0;
  std::string speeds;
  std::string tangentials = "0";
  std::string angles;
  std::string spins = "0";
  std::string second_spins = "0";
  std::string kinematics = "linear";
  double tolerance = 1e-2;
  int threads = 0;
  RowOptions rows;
  CLI::App* command = nullptr;

  [[nodiscard]] bool has_angles() const { return given(*command, "--angle"); }
};

/// Every speed with every motion along the surface.
struct Collisions {
  Encounter encounter;
  std::vector<ObliqueCase> cases{};
  std::vector<double> angles{};  ///< of the cases, degrees; empty where velocities along the surface were given
  bool spinning = false;
  Units units = units_of(encounter);

  [[nodiscard]] Columns key_columns() const;
  [[nodiscard]] Row key(std::size_t row) const;
};

void check_kinematics(const std::string& name) {
  if (name == "linear") return;
  const char* const why = name == "turning" ? " (that what is elastic turns with the body is not computed)" : "";
  throw InvalidInput::out_of_range("kinematics", fmt::format("{}", shortened(name)), fmt::format("linear{}", why));
}

Columns Collisions::key_columns() const {
  Columns columns = speed_columns(units);
  if (!angles.empty()) columns.push_back({"angle", "deg", 9});
  append(columns, input_columns("tangential", Dimension::speed, units, angles.empty() ? 14 : 0),
         input_columns("spin", Dimension::frequency, units, spinning ? 13 : 0),
         input_columns("second_spin", Dimension::frequency, units, 0), Columns{{"friction"}});
  return columns;
}

Row Collisions::key(std::size_t row) const {
  const auto& [speed, before] = cases[row];
  Row key = speed_row(units, speed);
  if (!angles.empty()) key.emplace_back(angles[row]);
  append(key, input_row(before.tangential, Dimension::speed, units),
         input_row(before.spin, Dimension::frequency, units),
         input_row(before.second_spin, Dimension::frequency, units), Row{before.friction});
  return key;
}

Collisions make_collisions(const ObliqueArguments& arguments) {
  Collisions made{.encounter = arguments.who.encounter()};
  made.encounter.friction = arguments.friction;
  validate(made.encounter);
  refuse_soft(made.encounter);
  constexpr double any = std::numeric_limits<double>::infinity();  // the core knows the radius of the second body
  const Units& units = made.units;
  const std::vector<double> speeds = parse_speeds(arguments.speeds, units);
  const bool by_angle = arguments.has_angles();
  const std::vector<double> along = by_angle
                                        ? parse_series("angle", arguments.angles)
                                        : parse_series_in("tangential", arguments.tangentials, Dimension::speed, units,
                                                          {-1.0, 1.0, "velocity along the surface, -1 to 1 c"});
  const std::vector<double> spins = parse_series_in("spin", arguments.spins, Dimension::frequency, units,
                                                    {-1.0, 1.0, "spin of the first body, -1 to 1 c/R"});
  const std::vector<double> second_spins =
      parse_series_in("second-spin", arguments.second_spins, Dimension::frequency, units, {-any, any, ""});
  const double size = static_cast<double>(speeds.size()) * static_cast<double>(along.size()) *
                      static_cast<double>(spins.size()) * static_cast<double>(second_spins.size());
  if (size > longest_series) {
    throw InvalidInput::out_of_range("speed",
                                     fmt::format("{:.0f} values in all, speeds times tangentials times spins", size),
                                     fmt::format("up to {}", longest_series));
  }
  for (const double speed : speeds) {
    for (const double motion : along) {
      const double tangential = by_angle ? tangential_at(motion, speed) : motion;
      for (const double spin : spins) {
        for (const double second_spin : second_spins) {
          made.cases.push_back({speed, {tangential, spin, second_spin, made.encounter.friction}});
          if (by_angle) made.angles.push_back(motion);
          made.spinning = made.spinning || spin != 0.0;
        }
      }
    }
  }
  return made;
}

Provenance describe(const ObliqueArguments& arguments, const Collisions& collisions) {
  Provenance provenance{"oblique", command_line(), {}};
  auto& inputs = provenance.inputs;
  cli::describe(collisions.encounter, inputs);
  const bool in_si = collisions.units.si.has_value();
  inputs[in_si ? "speed[m/s]" : "speed"] = as_typed(arguments.speeds);
  if (arguments.has_angles()) {
    inputs["angle[deg]"] = as_typed(arguments.angles);
  } else {
    inputs[in_si ? "tangential[m/s]" : "tangential"] = as_typed(arguments.tangentials);
  }
  inputs[in_si ? "spin[rad/s]" : "spin"] = as_typed(arguments.spins);
  inputs[in_si ? "second_spin[rad/s]" : "second_spin"] = as_typed(arguments.second_spins);
  inputs["friction"] = arguments.friction;
  inputs["kinematics"] = arguments.kinematics;
  inputs["tolerance"] = arguments.tolerance;
  return provenance;
}

RowPlan plan_of(const Collisions& collisions, const Columns& results, NeglectedNote& note) {
  Columns columns = collisions.key_columns();
  append(columns, results, yielding(collisions.encounter).columns());
  const auto name = [&collisions](std::size_t row) {
    const auto& [speed, before] = collisions.cases[row];
    const std::string spin = collisions.spinning ? fmt::format(", spin {:.6g}", before.spin) : "";
    return fmt::format("speed {:.6g} c, tangential {:.6g} c{}", speed, before.tangential, spin);
  };
  return {.size = collisions.cases.size(),
          .columns = columns,
          .key = [&collisions](std::size_t row) { return collisions.key(row); },
          .name = name,
          .encounter = collisions.encounter,
          .observer = [columns, &note](const Row& row) { note.take(columns, row); }};
}

void run(const ObliqueArguments& asked) {
  ObliqueArguments arguments = asked;
  check_kinematics(arguments.kinematics);
  arguments.rows.redirect();
  const Collisions collisions = make_collisions(arguments);
  const RefinableContact contact = refinable(collisions.encounter);
  ObliqueCurveOptions options{.each = {.tolerance = arguments.tolerance, .vibration = collisions.encounter.vibration},
                              .threads = arguments.threads};
  catch_interrupts();
  options.each.poll = heed_interrupts;
  validate(contact, collisions.cases, options);
  const Fields<ObliqueRestitution> fields = oblique_fields(collisions.units, collisions.spinning);
  const Yielding yields = yielding(collisions.encounter);
  NeglectedNote note;
  RowRun run(plan_of(collisions, fields.columns(), note), arguments.rows);
  run.write(describe(arguments, collisions), [&] {
    const std::vector<ObliqueCase> cases(collisions.cases.begin() + static_cast<std::ptrdiff_t>(run.done()),
                                         collisions.cases.end());
    options.each.poll = [&run] {
      heed_interrupts();
      run.wait("begins");
    };
    oblique_curve(contact, cases, options, [&](std::size_t, const ObliqueRestitution& result) {
      heed_interrupts();
      Row row = collisions.key(run.done());
      append(row, fields.row(result), yields.row(result.speed));
      run.add(row, oblique_details(result), result.converged ? "" : result.reason);
    });
  });
  note.say(arguments.rows.output, arguments.tolerance);
  run.conclude();
}

void add_motion(CLI::App& command, ObliqueArguments& arguments) {
  add(command, "--speed", arguments.speeds,
      "Speeds of approach along the normal, 1e-8 to 1 in c of the body (m/s\n"
      "with a material): a number, a,b,c, log:a:b:n or lin:a:b:n",
      "SPEEDS", "Motion")
      ->required();
  auto* tangential = add(command, "--tangential", arguments.tangentials,
                         "Velocities of the centre of the body along the surface, relative to\n"
                         "what it meets, -1 to 1 c (default: 0)",
                         "SPEEDS", "Motion");
  add(command, "--angle", arguments.angles,
      "In place of --tangential: angles between the velocity of the centre and\nthe normal, in degrees", "DEGREES",
      "Motion")
      ->excludes(tangential);
  add(command, "--spin", arguments.spins,
      "Spins of the body, -1 to 1 c/R (rad/s with a material); positive moves\n"
      "its foremost point along the surface as --tangential does (default: 0)",
      "SPINS", "Motion");
  add(command, "--second-spin", arguments.second_spins,
      "Spins of the second body, with the same sign of sliding (default: 0)", "SPINS", "Motion");
  add(command, "--kinematics", arguments.kinematics,
      "linear: bodies turn, and what is elastic in them keeps its directions\n(default, and the only one)", "NAME",
      "Motion");
}

}  // namespace

void add_oblique(CLI::App& app) {
  auto& arguments = add_subcommand<ObliqueArguments>(
      app, "oblique", "Collisions at an angle, with spin and friction", run,
      "Examples:\n"
      "  stoss oblique --poisson 0.33 --speed 0.1 --tangential 0.05 --friction 0.3\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.01 --angle lin:5:85:17 --friction 0.1\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.01 --tangential 0.01 --friction 1\n"
      "      --spin lin:-0.02:0.02:5 --format csv\n"
      "  stoss oblique --body sphere --material 'bearing steel' --radius 0.01 --speed 0.5,1 --angle 45\n"
      "      --friction 0.1 --against half-space,material=glass\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.1 --angle 30 --friction 0.2 --against same");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  add_motion(command, arguments);
  add(command, "--friction", arguments.friction, "Coefficient of Coulomb's law, 0 to 5", "MU", "Against")->required();
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  add(command, "--tolerance", arguments.tolerance,
      "Error to reach of the velocity at which surfaces slide afterwards, over\n"
      "that before or, if larger, the friction times the speed, 1e-6 to 0.5\n(default: 0.01)",
      "TOL", "Resolution");
  add_threads(command, arguments.threads);
  arguments.rows.add_to(command);
}

}  // namespace stoss::cli
