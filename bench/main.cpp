// Runs all benchmarks, then prints the medians as a Markdown table, with --markdown=FILE into a file as well. All flags
// of Google Benchmark are understood; each benchmark is repeated 9 times unless --benchmark_repetitions says otherwise.
#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "common.hpp"
#include "summary.hpp"

namespace {

int run(std::vector<std::string> arguments) {
  const std::string markdown_flag = "--markdown=";
  std::string markdown;
  std::vector<char*> flags;
  for (std::string& argument : arguments) {
    if (argument.rfind(markdown_flag, 0) == 0) {
      markdown = argument.substr(markdown_flag.size());
    } else {
      flags.push_back(argument.data());
    }
  }
  int count = static_cast<int>(flags.size());
  flags.push_back(nullptr);
  benchmark::Initialize(&count, flags.data());
  if (benchmark::ReportUnrecognizedArguments(count, flags.data())) return 2;

  bench::add_paper();
  bench::add_finite_elements();
  bench::add_peak();
  bench::add_modes();
  bench::add_impacts();
  bench::add_restitutions();
  bench::add_spheres();
  bench::add_oblique();
  bench::add_rods();
  bench::add_rows();
  bench::add_seismograms();
  bench::add_quasistatic();
  bench::add_predictions();
  bench::add_table();
  bench::add_pairs();
  bench::add_python();
  bench::Summary summary;
  benchmark::RunSpecifiedBenchmarks(&summary);
  benchmark::Shutdown();

  std::cout << '\n';
  summary.write(std::cout);
  if (!markdown.empty()) {
    std::ofstream file(markdown);
    summary.write(file);
    if (!file.flush()) {
      std::cerr << "stoss_bench: cannot write " << markdown << '\n';
      return 4;
    }
  }
  return summary.failed() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> arguments{argv[0], "--benchmark_repetitions=9", "--benchmark_min_time=0.1",
                                     "--benchmark_report_aggregates_only=true"};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    std::cerr << "stoss_bench: " << error.what() << '\n';
    return 1;
  }
}
