// stoss restitution: the coefficient of restitution against speed and Poisson's ratio, with errors.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/fields.hpp"
#include "output/row_run.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss::cli {
namespace {

/// The impacts of `stoss restitution`: for each Poisson's ratio all speeds.
struct Job {
  Encounter encounter;
  std::vector<double> poissons;
  std::vector<double> speeds;  ///< c
  Units units = units_of(encounter);

  [[nodiscard]] std::size_t size() const { return poissons.size() * speeds.size(); }
  [[nodiscard]] double poisson(std::size_t row) const { return poissons[row / speeds.size()]; }
  [[nodiscard]] double speed(std::size_t row) const { return speeds[row % speeds.size()]; }

  /// What meets at one of the Poisson's ratios, at any cutoff.
  [[nodiscard]] RefinableContact contact(double poisson) const {
    Encounter its = encounter;
    if (!units.si && has_poisson(its.first)) its.first.values["poisson"] = poisson;
    return refinable(its);
  }

  /// What tells a row from the others, with which it begins; with a material the speed in SI besides.
  [[nodiscard]] Row key(std::size_t row) const {
    Row key;
    if (has_poisson(encounter.first)) key.emplace_back(poisson(row));
    append(key, speed_row(units, speed(row)));
    return key;
  }

  /// A row: its key, the fields of its result, and what is said of yielding.
  template <typename Result>
  [[nodiscard]] Row row(std::size_t row, const Fields<Result>& fields, const Result& result) const {
    Row made = key(row);
    append(made, fields.row(result), yielding(encounter).row(speed(row)));
    return made;
  }

  /// All its rows, with the columns of the results; the job must outlive them.
  [[nodiscard]] RowPlan plan(const Columns& results) const;
};

RowPlan Job::plan(const Columns& results) const {
  Columns columns;
  if (has_poisson(encounter.first)) columns.push_back({"poisson", "", units.si ? 0 : 8});
  append(columns, speed_columns(units), results, yielding(encounter).columns());
  const auto name = [this](std::size_t row) {
    const std::string body = has_poisson(encounter.first) ? fmt::format("poisson {}, ", poisson(row)) : "";
    return fmt::format("{}speed {:.6g} c", body, speed(row));
  };
  return {.size = size(),
          .columns = columns,
          .key = [this](std::size_t row) { return key(row); },
          .name = name,
          .encounter = encounter};
}

struct RestitutionArguments {
  EncounterOptions who;
  std::string poissons;
  ApproachOptions approach;
  double tolerance = 1e-3;
  double absolute = 1e-6;
  int threads = 0;
  RowOptions rows;
  CLI::App* command = nullptr;
};

Job make_job(RestitutionArguments& arguments) {
  std::vector<double> poissons{units_of_rigid.at("poisson")};  // of what has none, or is rigid
  if (given(*arguments.command, "--poisson")) {
    poissons = parse_series("poisson", arguments.poissons);
    arguments.who.first.set_poisson(poissons.front());
  }
  Job job{arguments.who.encounter(), std::move(poissons), {}};
  if (job.units.si && job.poissons.size() > 1) {
    throw InvalidInput::out_of_range("poisson", fmt::format("{} numbers with a material", job.poissons.size()), "one",
                                     "a material has only one");
  }
  if (job.units.si) job.poissons = {poisson_of(job.encounter).value_or(0.0)};
  job.speeds = arguments.approach.series(job.units);
  if (job.size() > longest_series) {
    throw InvalidInput::out_of_range("speed",
                                     fmt::format("{} speeds for each of {} Poisson's ratios, {} values",
                                                 job.speeds.size(), job.poissons.size(), job.size()),
                                     fmt::format("up to {}", longest_series));
  }
  return job;
}

Provenance describe(const RestitutionArguments& arguments, const Job& job) {
  Provenance its = provenance(*arguments.command, job.encounter);
  if (job.poissons.size() > 1) its.inputs["first"]["poisson"] = arguments.poissons;
  return its;
}

Fields<Restitution> restitution_fields(const Units& units) {
  return Fields<Restitution>(restitution_quantities(), units,
                             {{"restitution", {.width = 22, .with_error = true}},
                              {"lost_fraction", {.width = 25, .with_error = true, .mark = {{"converged", false}}}},
                              {"contact_time", {.width = 13, .si_width = 17}},
                              {"cutoff", {.in_si = false}}});
}

nlohmann::ordered_json details(const Restitution& r) {
  nlohmann::ordered_json object{{"runs", to_json(run_quantities(), r.runs)}};
  if (!r.runs.empty()) object["ledger"] = to_json(ledger_quantities(), std::vector{r.finest.energy}).front();
  if (!r.converged) object["reason"] = r.reason;
  return object;
}

std::string describe(const Attempt& attempt) {
  const Estimate& lost = attempt.lost_fraction;
  const std::string error = lost.error > 0.0 ? fmt::format("{:.1e}", lost.error / lost.value) : "unknown";
  return fmt::format("cutoff {:.0f}, relative error of 1-eps^2 so far {}", attempt.cutoff, error);
}

/// @throws InvalidInput for what the core does not accept, before anything is computed
void check(const Job& job, const CurveOptions& asked) {
  validate(job.speeds, asked);
  const double slowest = *std::min_element(job.speeds.begin(), job.speeds.end());
  for (const double poisson : job.poissons) {
    const RefinableContact contact = job.contact(poisson);
    if (!asked.each.vibration.empty()) validate(contact, slowest, asked.each.vibration, heed_interrupts);
  }
}

/// The speeds of one Poisson's ratio that the run does not have yet.
void compute(const Job& job, RowRun& run, CurveOptions options, const Fields<Restitution>& fields) {
  const auto first = static_cast<std::ptrdiff_t>(run.done() % job.speeds.size());
  const std::vector<double> speeds(job.speeds.begin() + first, job.speeds.end());
  std::string state = "begins";
  options.each.poll = [&] {
    heed_interrupts();
    run.wait(state);
  };
  options.each.attempt_observer = [&state](const Attempt& attempt) { state = describe(attempt); };
  restitution_curve(job.contact(job.poisson(run.done())), speeds, options, [&](std::size_t, const Restitution& result) {
    heed_interrupts();
    run.add(job.row(run.done(), fields, result), details(result), result.converged ? "" : result.reason);
  });
}

void run(const RestitutionArguments& asked) {
  RestitutionArguments arguments = asked;
  arguments.rows.redirect();
  const Job job = make_job(arguments);
  const CurveOptions options{
      .each = {.tolerance = arguments.tolerance, .absolute = arguments.absolute, .vibration = job.encounter.vibration},
      .threads = arguments.threads};
  check(job, options);
  const Fields<Restitution> fields = restitution_fields(job.units);
  RowRun run(job.plan(fields.columns()), arguments.rows);
  run.write(describe(arguments, job), [&] {
    while (run.done() < job.size()) compute(job, run, options, fields);
  });
  run.conclude();
}

void add_resolution(CLI::App& command, RestitutionArguments& arguments) {
  add_input(command, Question::restitution, "tolerance", arguments.tolerance, "Resolution");
  add_input(command, Question::restitution, "absolute", arguments.absolute, "Resolution");
  add_threads(command, arguments.threads);
}

}  // namespace

void add_restitution(CLI::App& app) {
  auto& arguments = add_subcommand<RestitutionArguments>(
      app, "restitution", "Coefficient of restitution at a wall, a half-space or of two bodies", run,
      "Examples:\n"
      "  stoss restitution --body sphere --poisson 0.3 --speed 0.01\n"
      "  stoss restitution --body sphere --material 'bearing steel' --radius 0.005\n"
      "      --speed 0.01,0.1 --against half-space,material=glass\n"
      "  stoss restitution --body disk --poisson 0.33 --speed log:1e-4:0.3:40 --format csv -o curve.csv\n"
      "  stoss restitution --body sphere --poisson 0.3 --speed 0.01\n"
      "      --against sphere,radius=2,young=4\n"
      "They are a sphere at a wall, a ball in SI, a curve in a file, and two bodies; the manual has more.");
  CLI::App& command = *arguments.command;
  add(command, "--poisson", arguments.poissons,
      "Poisson's ratios, -0.95 to 0.995 of a disk, to 0.4999 of a sphere: a number, a,b,c, log:a:b:n or lin:a:b:n. "
      "For disks in SI: of the solid; otherwise the 2-D ratio (see the manual)",
      "NUS", "Body");
  arguments.approach.add_to(command, Question::restitution, "Motion");
  arguments.who.add_to(command);
  add_modes_to(command, arguments.who.modes);
  add_resolution(command, arguments);
  arguments.rows.add_to(command);
}

}  // namespace stoss::cli
