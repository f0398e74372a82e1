// stoss oblique: the collision rule of bodies that meet at an angle, with spin and friction.
#include "stoss/restitution/oblique_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/row_run.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

struct ObliqueArguments {
  EncounterOptions who;
  double friction = 0.0;
  ApproachOptions approach;
  std::string tangentials = "0";
  std::string angles;
  std::string spins = "0";
  std::string second_spins = "0";
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

  [[nodiscard]] Columns key_columns() const {
    Columns columns = speed_columns(units);
    if (!angles.empty()) columns.push_back({"angle", "deg", 9});
    append(columns, input_columns("tangential", Dimension::speed, units, angles.empty() ? 14 : 0),
           input_columns("spin", Dimension::frequency, units, spinning ? 13 : 0),
           input_columns("second_spin", Dimension::frequency, units, 0), Columns{{"friction"}});
    return columns;
  }

  [[nodiscard]] Row key(std::size_t row) const {
    const auto& [speed, before] = cases[row];
    Row key = speed_row(units, speed);
    if (!angles.empty()) key.emplace_back(angles[row]);
    append(key, input_row(before.tangential, Dimension::speed, units),
           input_row(before.spin, Dimension::frequency, units),
           input_row(before.second_spin, Dimension::frequency, units), Row{before.friction});
    return key;
  }
};

Collisions make_collisions(const ObliqueArguments& arguments) {
  Collisions made{.encounter = arguments.who.encounter()};
  const Units& units = made.units;
  const std::vector<double> speeds = arguments.approach.series(units);
  const bool by_angle = arguments.has_angles();
  const auto series = [&](const char* name, const std::string& text) {
    return series_of(input(Question::oblique, name), text, units);
  };
  const std::vector<double> along =
      by_angle ? series("angle", arguments.angles) : series("tangential", arguments.tangentials);
  const std::vector<double> spins = series("spin", arguments.spins);
  const std::vector<double> second_spins = series("second_spin", arguments.second_spins);
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
          made.cases.push_back({speed, {tangential, spin, second_spin, arguments.friction}});
          if (by_angle) made.angles.push_back(motion);
          made.spinning = made.spinning || spin != 0.0;
        }
      }
    }
  }
  return made;
}

/// The columns behind the motion before. A table of spinning bodies has no room for both errors.
Fields<ObliqueRestitution> oblique_fields(const Units& units, bool spinning) {
  return Fields<ObliqueRestitution>(
      oblique_quantities(), units,
      {{"restitution", {.width = spinning ? 13 : 22, .with_error = !spinning}},
       {"tangential_restitution", {.width = 25, .with_error = true, .mark = {{"converged", false}}}},
       {"cutoff", {.in_si = false}}});
}

/// What JSON has in addition.
nlohmann::ordered_json oblique_details(const ObliqueRestitution& result) {
  nlohmann::ordered_json object{{"runs", to_json(oblique_run_quantities(), result.runs)}};
  if (!result.runs.empty()) {
    object["ledger"] = to_json(oblique_ledger_quantities(), std::vector{result.finest.energy}).front();
  }
  if (!result.converged) object["reason"] = result.reason;
  return object;
}

/// By how much, at most, the coupling that spheres are computed without may change a row, also of an earlier run.
struct Neglected {
  double tangential = 0.0, normal = 0.0;
  bool unknown = false;

  void take(const Columns& columns, const Row& row) {
    const auto change = [&](const char* name) { return std::abs(number(*find(columns, row, name))); };
    unknown = unknown || std::isnan(change("coupling_tangential_restitution"));
    tangential = std::fmax(tangential, change("coupling_tangential_restitution"));
    normal = std::fmax(normal, change("coupling_restitution"));
  }

  /// Below a table, which has no column for it, if it is unknown or more than was asked for.
  void warn(const OutputOptions& output, double tolerance) const {
    if (output.chosen_format() != Format::table || (!unknown && tangential <= tolerance)) return;
    output.warn(unknown ? "how much neglected coupling may change tangential_restitution is unknown (friction so high "
                          "is ill-posed)"
                        : fmt::format("neglected coupling may change tangential_restitution by up to {:.2g}, "
                                      "restitution by up to {:.2g}",
                                      tangential, normal));
  }
};

RowPlan plan_of(const Collisions& collisions, const Columns& results, Neglected& note) {
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
  Neglected note;
  RowRun run(plan_of(collisions, fields.columns(), note), arguments.rows);
  run.write(provenance(*arguments.command, collisions.encounter), [&] {
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
  note.warn(arguments.rows.output, arguments.tolerance);
  run.conclude();
}

void add_motion(CLI::App& command, ObliqueArguments& arguments) {
  constexpr auto question = Question::oblique;
  arguments.approach.add_to(command, question, "Motion");
  auto* tangential = add_input(command, question, "tangential", arguments.tangentials, "Motion");
  add_input(command, question, "angle", arguments.angles, "Motion")->excludes(tangential);
  add_input(command, question, "spin", arguments.spins, "Motion");
  add_input(command, question, "second_spin", arguments.second_spins, "Motion");
  add_input(command, question, "friction", arguments.friction, "Motion");
}

}  // namespace

void add_oblique(CLI::App& app) {
  auto& arguments = add_subcommand<ObliqueArguments>(
      app, "oblique", "Collisions at an angle, with spin and friction", run,
      "Examples:\n"
      "  stoss oblique --body disk --poisson 0.33 --speed 0.1 --tangential 0.05 --friction 0.3\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.01 --angle lin:5:85:17 --friction 0.1\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.01 --tangential 0.01 --friction 1\n"
      "      --spin lin:-0.02:0.02:5 --format csv\n"
      "  stoss oblique --body sphere --material 'bearing steel' --radius 0.01 --speed 0.5,1 --angle 45\n"
      "      --friction 0.1 --against half-space,material=glass\n"
      "  stoss oblique --body sphere --poisson 0.3 --speed 0.1 --angle 30 --friction 0.2 --against same");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  add_motion(command, arguments);
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  add_input(command, Question::oblique, "tolerance", arguments.tolerance, "Resolution");
  add_threads(command, arguments.threads);
  arguments.rows.add_to(command);
}

}  // namespace stoss::cli
