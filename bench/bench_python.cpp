// What the Python package adds to an impact: the same call from Python and from C++, by turns, in one process.
#include <pybind11/embed.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "common.hpp"
#include "stoss/impact/impact.hpp"

namespace bench {
namespace {

namespace py = pybind11;

constexpr double cutoff = 25.0;

double seconds(const std::chrono::steady_clock::time_point& begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double from_cpp(double& lost_fraction) {
  const auto begin = std::chrono::steady_clock::now();
  lost_fraction = stoss::impact(disk_body(cutoff), stoss::HardWall{}, speed).lost_fraction;
  return seconds(begin);
}

double from_python(const py::object& call, double& lost_fraction) {
  const auto begin = std::chrono::steady_clock::now();
  lost_fraction = call().attr("lost_fraction").cast<double>();
  return seconds(begin);
}

py::object python_call() {
  py::module_::import("site").attr("addsitedir")(STOSS_PYTHON_PACKAGES);
  py::dict names;
  py::exec("import stoss\nbody = stoss.Disk(poisson=" + std::to_string(poisson) +
               ")\ncall = lambda: stoss.impact(body, speed=" + std::to_string(speed) +
               ", cutoff=" + std::to_string(cutoff) + ")\n",
           names);
  return names["call"];
}

}  // namespace

void add_python() {
  benchmark::RegisterBenchmark("impact at cutoff 25, from Python less from C++",
                               [](benchmark::State& state) {
                                 static const py::scoped_interpreter interpreter;
                                 const py::object call = python_call();
                                 double there = 0.0, here = 0.0;
                                 for (auto _ : state) {
                                   // By turns and the best of each, because the machine's speed varies by more than
                                   // the difference.
                                   double python = 1.0, cpp = 1.0;
                                   for (int i = 0; i < 20; ++i) {
                                     python = std::min(python, from_python(call, there));
                                     cpp = std::min(cpp, from_cpp(here));
                                   }
                                   state.SetIterationTime(std::max(0.0, python - cpp));
                                 }
                                 if (there != here) state.SkipWithError("Python and C++ give different values");
                                 count_apart(state, there, converged_lost_fraction);
                               })
      ->Unit(benchmark::kMillisecond)
      ->UseManualTime()
      ->Iterations(5);
}

}  // namespace bench
