// stoss sweep: declared here, done by the Python package, which has the store of sweeps.
#include <fmt/format.h>

#include "app.hpp"
#include "process/process.hpp"

namespace stoss::cli {
namespace {

struct SweepArguments {
  std::string grid, store, shard;
  int threads = 0;
  CLI::App* command = nullptr;
};

void run(const SweepArguments& arguments) {
  std::vector<std::string> words{"sweep", "--store=" + arguments.store, fmt::format("--threads={}", arguments.threads)};
  if (!arguments.shard.empty()) words.push_back("--shard=" + arguments.shard);
  words.insert(words.end(), {"--", arguments.grid});
  become_python(words);
}

}  // namespace

void add_sweep(CLI::App& app) {
  auto& arguments = add_subcommand<SweepArguments>(
      app, "sweep", "Compute a grid of bodies, partners and speeds; run shards on several machines", run,
      "Examples:\n"
      "  stoss sweep grid.toml --store values\n"
      "  stoss sweep grid.toml --store values --shard $SLURM_ARRAY_TASK_ID/100 --threads 1");
  CLI::App& command = *arguments.command;
  add(command, "grid", arguments.grid, "TOML file of bodies, partners and speeds", "GRID", "Grid")->required();
  add(command, "--store", arguments.store,
      "Directory of the values: each worker appends to its own file there;\nonly what is missing is computed", "DIR",
      "Grid")
      ->required();
  add(command, "--shard", arguments.shard, "Only the I-th of N parts, from 1/N to N/N (default: 1/1)", "I/N", "Grid");
  add_threads(command, arguments.threads);
}

}  // namespace stoss::cli
