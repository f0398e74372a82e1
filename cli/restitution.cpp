// stoss restitution: the coefficient of restitution against speed, with errors.
#include "stoss/restitution.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "numbers.hpp"
#include "ordered_jobs.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

struct RestitutionArguments {
  DiskArguments disk;
  std::string speeds;
  double tolerance = 1e-2;
  int threads = 0;
  OutputArguments output;
};

struct Timed {
  Restitution restitution;
  double seconds;
};

/// Writes rows as they come and remembers what has to be said about them at the end.
class Curve {
 public:
  Curve(const RestitutionArguments& arguments, double poisson, std::optional<Scales> si, Report& report)
      : arguments_(arguments), poisson_(poisson), si_(si), report_(report) {}

  void add(const Timed& timed) {
    const Restitution& r = timed.restitution;
    const Impact& finest = r.finest;
    const bool converged = r.lost_fraction_error <= arguments_.tolerance * r.lost_fraction;
    not_converged_ += converged ? 0 : 1;
    beyond_small_strain_ = beyond_small_strain_ || finest.beyond_small_strain;
    std::vector<Entry> record{{"poisson", "", poisson_, si_ ? 0 : 8}, {"speed", "c", finest.speed, si_ ? 0 : 12}};
    const auto add = [&record](Entry entry) { record.push_back(std::move(entry)); };
    if (si_) add({"speed_si", "m/s", finest.speed * si_->speed, 12});
    add({"restitution", "", r.value, 22, with_error(r.value, r.error)});
    add({"restitution_error", "", r.error});
    const std::string mark = converged ? "  " : " !";
    add({"lost_fraction", "", r.lost_fraction, 25, with_error(r.lost_fraction, r.lost_fraction_error) + mark});
    add({"lost_fraction_error", "", r.lost_fraction_error});
    add({"contact_time", "R/c", finest.contact_time, si_ ? 0 : 13});
    add({"max_compression", "R", finest.max_compression});
    add({"max_force", "piRE", finest.max_force});
    add({"cutoff", "c/R", finest.cutoff});
    add({"modes", "", static_cast<long>(finest.energy.modes.size())});
    add({"steps", "", r.steps});
    add({"energy_error", "", finest.energy_error});
    add({"seconds", "s", timed.seconds});
    add({"converged", "", converged});
    add({"beyond_small_strain", "", finest.beyond_small_strain});
    if (si_) {
      add({"contact_time_si", "s", finest.contact_time * si_->time, 17});
      add({"max_force_si", "N/m", finest.max_force * si_->force});
      add({"max_compression_si", "m", finest.max_compression * si_->length});
    }
    report_.add(record);
  }

  /// A row without values in place of one that could not be computed.
  void fail(double speed, const std::string& reason) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    Timed nothing{{none, none, none, none, {}, 0}, none};
    Impact& impact = nothing.restitution.finest;
    impact.speed = speed;
    for (double* value :
         {&impact.contact_time, &impact.max_compression, &impact.max_force, &impact.cutoff, &impact.energy_error}) {
      *value = none;
    }
    add(nothing);
    fmt::print(stderr, "stoss: error: speed {}: {}\n", speed, reason);
  }

  /// The exit code.
  [[nodiscard]] int conclude() const {
    if (beyond_small_strain_) {
      arguments_.output.warn(
          "speed above 0.5 c or compression above 0.5 R: linear elasticity has lost its meaning there");
    }
    if (not_converged_ == 0) return 0;
    arguments_.output.warn(fmt::format("{} of the values not within the tolerance {} of 1-eps^2 (marked)",
                                       not_converged_, arguments_.tolerance));
    return 1;
  }

 private:
  const RestitutionArguments& arguments_;
  double poisson_;
  std::optional<Scales> si_;
  Report& report_;
  int not_converged_ = 0;
  bool beyond_small_strain_ = false;
};

/// A bar on a terminal, nothing elsewhere.
void show_progress(const OutputArguments& output, std::size_t done, std::size_t total) {
  if (output.quiet || output.path.empty() || output.path == "-" || isatty(STDERR_FILENO) == 0) return;
  constexpr std::size_t width = 40;
  const std::size_t full = width * done / total;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{}{}", "", full, "", width - full, done, total, done == total ? "\n" : "");
}

void check(const RestitutionArguments& arguments) {
  if (!(arguments.tolerance > 0.0 && arguments.tolerance < 1.0)) {
    throw InvalidInput(
        fmt::format("tolerance: got {}, allowed above 0 and below 1 (relative error of 1-eps^2)", arguments.tolerance));
  }
  if (arguments.threads < 0 || arguments.threads > 1024) {
    throw InvalidInput(fmt::format("threads: got {}, allowed 0 to 1024 (0: all cores)", arguments.threads));
  }
}

int run(const RestitutionArguments& arguments) {
  const auto si = arguments.disk.si();
  const std::vector<double> speeds = parse_speeds(arguments.speeds, si);
  check(arguments);
  const double poisson = arguments.disk.plane_poisson();
  const RefinedBody body = refine(disk(poisson));

  Provenance provenance{"restitution", command_line(), {}};
  arguments.disk.describe(provenance.inputs);
  provenance.inputs["wall"] = "hard";
  provenance.inputs["tolerance"] = arguments.tolerance;
  catch_interrupts();
  Report report(arguments.output.path, arguments.output.chosen_format(), provenance);
  Curve curve(arguments, poisson, si, report);

  const auto job = [&](std::size_t i) {
    const auto start = std::chrono::steady_clock::now();
    Restitution result = restitution(body, speeds[i]);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    return Timed{std::move(result), elapsed.count()};
  };
  const auto deliver = [&](std::size_t i, std::variant<Timed, std::exception_ptr> outcome) {
    if (const auto* timed = std::get_if<Timed>(&outcome)) {
      curve.add(*timed);
    } else {
      try {
        std::rethrow_exception(std::get<std::exception_ptr>(outcome));
      } catch (const NotConverged& error) {
        curve.fail(speeds[i], error.what());
      }
    }
    show_progress(arguments.output, i + 1, speeds.size());
  };
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int wanted = arguments.threads == 0 ? cores : arguments.threads;
  const int threads = static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(wanted), speeds.size()));
  try {
    run_in_order<Timed>(speeds.size(), threads, job, deliver);
  } catch (const OutputError&) {
    throw;
  } catch (...) {
    report.finish(false);
    throw;
  }
  report.finish();
  return curve.conclude();
}

}  // namespace

void add_restitution(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("restitution", "Coefficient of restitution of a disk against a hard wall, with errors");
  auto arguments = std::make_shared<RestitutionArguments>();
  arguments->disk.add_to(*command);
  command
      ->add_option("--speed", arguments->speeds,
                   "Speeds, 1e-8 to 1 in c (m/s with a material): a,b,c or log:a:b:n or lin:a:b:n")
      ->required()
      ->type_name("SPEEDS")
      ->group("Body");
  command
      ->add_option("--tolerance", arguments->tolerance,
                   "Relative error of 1-eps^2 above which a value is marked (default: 0.01)")
      ->type_name("TOL")
      ->group("Resolution");
  command
      ->add_option("--threads", arguments->threads,
                   "Threads, 0 for all cores; results do not depend on it (default: 0)")
      ->type_name("N")
      ->group("Resolution");
  arguments->output.add_to(*command);
  command->footer(
      "Example:\n  stoss restitution --poisson 0.33 --speed log:1e-4:0.3:40 --format csv -o curve.csv\n"
      "  stoss restitution --poisson 0.3 --young 2.1e11 --density 7850 --radius 0.01 --speed 1,5,10\n"
      "Two equal disks that each move at SPEED towards each other are the same problem.");
  command->callback([arguments, &exit_code] { exit_code = run(*arguments); });
}

}  // namespace stoss::cli
