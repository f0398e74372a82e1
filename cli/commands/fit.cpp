// stoss fit: declared here, done by the Python package, which has the force laws and an optimiser.
#include <fmt/format.h>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

struct FitArguments {
  EncounterOptions who;
  ApproachOptions approach;
  std::string law, program, output;
  double friction = 0.0;
  int threads = 0;
  CLI::App* command = nullptr;
};

void run(const FitArguments& arguments) {
  const Encounter encounter = arguments.who.encounter();
  if (encounter.first.kind != "sphere") {
    throw InvalidInput::out_of_range("body", fmt::format("{}", encounter.first.kind), "sphere",
                                     "laws are those of balls");
  }
  (void)own_value(input(Question::fit, "friction"), arguments.friction, units_of(encounter));
  const auto [slowest, fastest] = arguments.approach.ends(units_of(encounter)).typed;
  std::vector<std::string> words{"fit",
                                 "--law=" + arguments.law,
                                 fmt::format("--friction={}", arguments.friction),
                                 "--threads",
                                 fmt::format("{}", arguments.threads),
                                 "--speed"};
  for (const double speed : {slowest, fastest}) words.push_back(fmt::format("{}", speed));
  if (!arguments.program.empty()) words.push_back("--program=" + arguments.program);
  if (!arguments.output.empty()) words.push_back("--output=" + arguments.output);
  words.insert(words.end(), {"--", to_json(encounter)});
  become_python(words);
}

}  // namespace

void add_fit(CLI::App& app) {
  auto& arguments = add_subcommand<FitArguments>(
      app, "fit", "Constants of a force law that come nearest to elasticity", run,
      "Examples:\n"
      "  stoss fit --body sphere --material 'bearing steel' --radius 0.005 --against same --speed 0.01:0.25\n"
      "      --law viscoelastic --friction 0.2 --program lammps\n"
      "  stoss fit --body sphere --material glass --radius 0.001 --speed 0.1:1 --law tsuji");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  add_choice(command, "--law", arguments.law,
             {"linear", "tsuji", "viscoelastic", "hunt-crossley", "thornton", "walton", "mujoco", "table"},
             "The force law or rule\n"
             "  linear:        spring and dashpot\n"
             "  tsuji:         Hertz with a constant alpha\n"
             "  viscoelastic:  Kuwabara and Kono, Brilliantov and Poeschel\n"
             "  hunt-crossley: Hertz times (1 + lambda v)\n"
             "  thornton:      elastic-plastic spheres\n"
             "  walton:        three numbers: e, mu, beta0\n"
             "  mujoco:        solref\n"
             "  table:         rows of speed and eps",
             "NAME", "Law")
      ->required();
  arguments.approach.add_to(command, Question::fit, "Law");
  add_input(command, Question::fit, "friction", arguments.friction, "Law");
  arguments.who.add_to(command);
  add_choice(command, "--program", arguments.program,
             {"lammps", "liggghts", "yade", "mercurydpm", "chrono", "mujoco", "acutrace", "aspherix"},
             "Fit the law as this program integrates it, and print input lines for it", "NAME", "Output");
  add(command, "-o,--output", arguments.output, "Write to FILE instead of stdout; it appears whole or not at all",
      "FILE", "Output");
  add_threads(command, arguments.threads);
}

}  // namespace stoss::cli
