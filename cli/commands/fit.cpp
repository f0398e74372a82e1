// stoss fit: declared here, done by the Python package, which has the force laws and an optimiser.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/programs.hpp"
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
  std::vector<std::string> laws, programs;
  std::string law_help = "The force law or rule", program_help =
                                                      "Fit the law as this program integrates it, and print\n"
                                                      "input lines for it";
  for (const auto& [name, what] : fitted_laws()) {
    laws.push_back(name);
    law_help += fmt::format("\n  {:<14} {}", name + ":", what);
  }
  for (const FittedProgram& each : fitted_programs()) {
    programs.push_back(each.name);
    program_help +=
        fmt::format("\n  {:<11} {} ({}; {})", each.name + ":", each.writes, fmt::join(each.laws, ", "), each.tried);
  }
  add_choice(command, "--law", arguments.law, laws, law_help, "NAME", "Law")->required();
  arguments.approach.add_to(command, Question::fit, "Law");
  add_input(command, Question::fit, "friction", arguments.friction, "Law");
  arguments.who.add_to(command);
  add_choice(command, "--program", arguments.program, programs, program_help, "NAME", "Output");
  add(command, "-o,--output", arguments.output, "Write to FILE instead of stdout; it appears whole or not at all",
      "FILE", "Output");
  add_threads(command, arguments.threads);
}

}  // namespace stoss::cli
