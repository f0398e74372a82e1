// stoss sweep and stoss merge: declared here, done by the Python package, which has the store of sweeps.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "options.hpp"
#include "output.hpp"
#include "stoss/version.hpp"

namespace stoss::cli {
namespace {

struct HandOverArguments {
  std::string what;  ///< the file of the grid, or the store
  std::string store;
  std::string shard;
  std::string output;
  int threads = 0;
  bool mix = false;
};

/// What Python runs. A package of another version would compute other values.
std::string program() {
  return fmt::format(
      "import sys\n"
      "sys.path = [each for each in sys.path if each]\n"
      "try:\n"
      "    import stoss\n"
      "    from stoss.sweeps import _command as command\n"
      "except ImportError as error:\n"
      "    got, allowed = 'none', 'the package stoss for python3 (make python; put its bin into PATH): ' + str(error)\n"
      "else:\n"
      "    got, allowed = stoss.__version__, '{0}'\n"
      "    if got == allowed: sys.exit(command.main(sys.argv[1:]))\n"
      "print(f'stoss: error: Python package: got {{got}}, allowed {{allowed}}', file=sys.stderr)\n"
      "sys.exit(4)\n",
      version());
}

/// Becomes Python with these words. @throws OutputError if there is none
[[noreturn]] void hand_over(const std::vector<std::string>& words) {
  std::vector<std::string> all{"python3", "-c", program()};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> pointers;
  pointers.reserve(all.size() + 1);
  for (std::string& word : all) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execvp(pointers.front(), pointers.data());
  throw OutputError(fmt::format("Python: cannot run python3, which has the store of sweeps: {}", std::strerror(errno)));
}

void add_sweep(CLI::App& app) {
  auto* command = app.add_subcommand("sweep", "Compute the cases of a grid, on as many machines as there are");
  auto arguments = std::make_shared<HandOverArguments>();
  command->add_option("grid", arguments->what, "TOML file of bodies, partners and speeds")
      ->required()
      ->type_name("GRID")
      ->group("Grid");
  command
      ->add_option("--store", arguments->store,
                   "Directory of the values: each worker appends to its own file there;\n"
                   "only what is missing is computed")
      ->required()
      ->type_name("DIR")
      ->group("Grid");
  command->add_option("--shard", arguments->shard, "Only the I-th of N parts, from 1/N to N/N (default: 1/1)")
      ->type_name("I/N")
      ->group("Grid");
  add_threads(*command, arguments->threads);
  command->footer(
      "Examples:\n"
      "  stoss sweep grid.toml --store values\n"
      "  stoss sweep grid.toml --store values --shard $SLURM_ARRAY_TASK_ID/100 --threads 1");
  command->callback([arguments] {
    std::vector<std::string> words{"sweep", "--store=" + arguments->store,
                                   fmt::format("--threads={}", arguments->threads)};
    if (!arguments->shard.empty()) words.push_back("--shard=" + arguments->shard);
    words.insert(words.end(), {"--", arguments->what});
    hand_over(words);
  });
}

void add_merge(CLI::App& app) {
  auto* command = app.add_subcommand("merge", "Write the values of a sweep to one NetCDF file");
  auto arguments = std::make_shared<HandOverArguments>();
  command->add_option("store", arguments->what, "Directory of the values")
      ->required()
      ->type_name("DIR")
      ->group("Output");
  command->add_option("-o,--output", arguments->output, "NetCDF-4 file to write; it appears whole or not at all")
      ->required()
      ->type_name("FILE")
      ->group("Output");
  command->add_flag("--mix", arguments->mix, "Take values of other versions too, leave out those of other grids")
      ->group("Output");
  command->footer("Example:\n  stoss merge values -o values.nc");
  command->callback([arguments] {
    std::vector<std::string> words{"merge", "--output=" + arguments->output};
    if (arguments->mix) words.emplace_back("--mix");
    words.insert(words.end(), {"--", arguments->what});
    hand_over(words);
  });
}

}  // namespace

void add_sweeps(CLI::App& app) {
  add_sweep(app);
  add_merge(app);
}

}  // namespace stoss::cli
