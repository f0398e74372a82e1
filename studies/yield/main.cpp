// Loads and unloads an elastic-plastic half-space by a rigid paraboloid:
//   stoss_yield POISSON DEPTH ELEMENTS STEPS SIZE [HARDENING]
// DEPTH is the largest depth over that at the onset of yield, ELEMENTS the number of elements along the estimated
// radius of contact, STEPS those of the loading and of the unloading, SIZE the domain over that radius, HARDENING H/E
// (0: perfectly plastic). Lengths are in the radius of contact at onset, which with R = 1 and E* = 1 is also 1: the
// depth at onset is 1, the force 4/3.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <numbers>

#include "hertz.hpp"
#include "indentation.hpp"

namespace {

using namespace yield_study;

struct Works {
  double done = 0.0, depth = 0.0, force = 0.0;
  void add(const Reading& reading) {
    done += 0.5 * (force + reading.force) * (reading.depth - depth);
    depth = reading.depth;
    force = reading.force;
  }
};

void print(const char* branch, const Reading& reading, const Indentation& indentation, const Works& works) {
  constexpr double force = 4.0 / 3.0;
  const Energies energies = indentation.energies();
  fmt::print("{},{:.8g},{:.8g},{:.6g},{},{},{:.8g},{:.8g},{:.8g}\n", branch, reading.depth, reading.force / force,
             reading.radius, reading.nodes, reading.iterations, works.done / force, energies.stored / force,
             energies.dissipated / force);
  std::fflush(stdout);
}

/// Radius of contact at this depth, from below that of Hertz' law, √d, to that of a plastic impression.
double estimated_radius(double depth) {
  return std::sqrt(depth * (1.0 + std::min(1.4, 0.3 * std::log(std::max(depth, 1.0)))));
}

void run(double poisson, double deepest, int elements, int steps, double size, double hardening) {
  const double young = 1.0 - poisson * poisson, pressure = 2.0 / std::numbers::pi;
  const Material material{young, poisson, pressure / onset_pressure(poisson), hardening * young};
  const double radius = estimated_radius(deepest), element = radius / elements;
  const Grid grid{element * std::ceil(1.25 * elements), element, 1.0 + 3.6 / elements, size * radius};
  Indentation indentation(half_space(material, grid), 1.0);
  fmt::print("# nu {:g} depth {:g} elements {} steps {} size {:g} unknowns {} onset {:.6f} hardening {:g}\n", poisson,
             deepest, elements, steps, size, indentation.body().size(), onset_pressure(poisson), hardening);
  fmt::print("branch,d,f,a,nodes,iterations,work,stored,dissipated\n");
  Works works;
  Reading reading{};
  for (int k = 1; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    reading = indentation.go(deepest * part * part);
    works.add(reading);
    print("load", reading, indentation, works);
  }
  const auto steepest = [&] {  // Sneddon: dF/dδ = 2 E* a
    return reading.force / (2.0 * reading.radius);
  };
  const double full = 1.5 * steepest(), top = reading.depth;
  for (int k = 1; reading.nodes > 0 && k < 3 * steps; ++k) {
    reading = indentation.go(top - full * k / steps);
    works.add(reading);
    print("unload", reading, indentation, works);
  }
  for (const auto& point : indentation.surface())
    if (point[0] < 3.0 * radius) fmt::print("surface,{:.6g},{:.8g}\n", point[0], point[1]);
}

}  // namespace

int main(int count, char** words) {
  if (count != 6 && count != 7) {
    fmt::print(stderr,
               "stoss_yield: got {} arguments, allowed 5 and 6: POISSON DEPTH ELEMENTS STEPS SIZE [HARDENING]\n",
               count - 1);
    return 2;
  }
  try {
    run(std::atof(words[1]), std::atof(words[2]), std::atoi(words[3]), std::atoi(words[4]), std::atof(words[5]),
        count == 7 ? std::atof(words[6]) : 0.0);
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_yield: {}\n", error.what());
    return 1;
  }
}
