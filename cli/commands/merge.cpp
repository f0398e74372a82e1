// stoss merge: declared here, done by the Python package, which has the store of sweeps.
#include "app.hpp"
#include "process/process.hpp"

namespace stoss::cli {
namespace {

struct MergeArguments {
  std::string store, output;
  bool mix = false;
  CLI::App* command = nullptr;
};

void run(const MergeArguments& arguments) {
  std::vector<std::string> words{"merge", "--output=" + arguments.output};
  if (arguments.mix) words.emplace_back("--mix");
  words.insert(words.end(), {"--", arguments.store});
  become_python(words);
}

}  // namespace

void add_merge(CLI::App& app) {
  auto& arguments = add_subcommand<MergeArguments>(app, "merge", "Write the values of a sweep to one NetCDF file", run,
                                                   "Example:\n  stoss merge values -o values.nc");
  CLI::App& command = *arguments.command;
  add(command, "store", arguments.store, "Directory of the values", "DIR", "Output")->required();
  add(command, "-o,--output", arguments.output, "NetCDF-4 file to write; it appears whole or not at all", "FILE",
      "Output")
      ->required();
  command.add_flag("--mix", arguments.mix, "Take values of other versions too, leave out those of other grids")
      ->group("Output");
}

}  // namespace stoss::cli
