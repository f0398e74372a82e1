// Adhesion of a sphere at a rigid wall by a law of finite range, as rows of a table:
//   stoss_adhesion static TABOR RINGS [RATIO]            RATIO of ranges, push over pull; 0: Lennard-Jones' law
//   stoss_adhesion impact TABOR WORK SPEED [MODES RINGS STEPS [RATIO]]
//   stoss_adhesion stick  TABOR WORK LOW HIGH [MODES RINGS STEPS [RATIO]]
// WORK is w in ER, SPEED that over the sticking speed of Johnson, Kendall and Roberts; MODES, RINGS and STEPS multiply
// cutoff, number of rings and number of steps. `stick` bisects between two speeds. Poisson's ratio is 0.2.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "half_space.hpp"
#include "impact.hpp"
#include "published.hpp"
#include "stoss/bodies/sphere.hpp"

namespace {

using namespace adhesion_study;

void print_static(double tabor, int rings, double ratio) {
  const Static found = ratio > 0.0 ? exponential_statics(tabor, rings, ratio) : lennard_jones_statics(tabor, rings);
  fmt::print("{:g},{},{:.3g},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", tabor, rings, ratio, found.pull_off,
             maugis_pull_off(1.157 * tabor), found.jump_in, found.jump_out, found.work, found.work / jkr_work());
}

Result print_impact(const Grain& grain, const stoss::Body& body, double part) {
  const auto begin = std::chrono::steady_clock::now();
  const double speed = part * grain.jkr_speed();
  const Law law = exponential_law(grain.work, grain.range(), grain.ratio);
  const Result found = meet(body, law, speed, grain.numerics(speed));
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const double lost = 1.0 - found.restitution * found.restitution;
  fmt::print("{:g},{:g},{:.3g},{:.6g},{:.6g},{:g},{:g},{:g},{:.4g},{},{},{:.4g},{:.6f},{:.6f},{:.6f},{:.1e},{:.1e},",
             grain.tabor, grain.work, grain.ratio, part, speed, grain.modes, grain.rings, grain.steps, grain.cutoff(),
             found.modes, found.rings, grain.numerics(speed).step, found.restitution, lost, lost * part * part,
             found.imbalance, found.largest);
  fmt::print("{:.4f},{:.4g},{:.4f},{:.4g},{:.3f},{},{:.1f}\n", found.pull / grain.work, found.push, found.time,
             found.deepest, found.compliance * grain.softening(), found.steps, seconds);
  std::fflush(stdout);
  return found;
}

void stick(const Grain& grain, double low, double high) {
  const stoss::Body body = stoss::sphere(grain.poisson, grain.cutoff());
  while (high / low > 1.004) {
    const double middle = std::sqrt(low * high);
    (print_impact(grain, body, middle).restitution > 0.0 ? high : low) = middle;
  }
}

}  // namespace

int main(int count, char** arguments) try {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  const auto number = [&](std::size_t i, double otherwise) {
    return i < given.size() ? std::stod(given[i]) : otherwise;
  };
  const std::string_view what = given.empty() ? "" : given[0];
  if (what == "static" && given.size() > 2) {
    print_static(number(1, 1.0), static_cast<int>(number(2, 200.0)), number(3, 0.5));
    return 0;
  }
  if ((what == "impact" && given.size() > 3) || (what == "stick" && given.size() > 4)) {
    const std::size_t from = what == "stick" ? 5 : 4;
    const Grain grain{.tabor = number(1, 1.0),
                      .work = number(2, 1e-4),
                      .ratio = number(from + 3, 0.5),
                      .modes = number(from, 1.0),
                      .rings = number(from + 1, 1.0),
                      .steps = number(from + 2, 1.0)};
    if (what == "stick") {
      stick(grain, number(3, 1.0), number(4, 1.0));
    } else {
      (void)print_impact(grain, stoss::sphere(grain.poisson, grain.cutoff()), number(3, 1.0));
    }
    return 0;
  }
  fmt::print(stderr,
             "stoss_adhesion static TABOR RINGS [RATIO] | impact TABOR WORK SPEED [MODES RINGS STEPS [RATIO]] | "
             "stick TABOR WORK LOW HIGH [MODES RINGS STEPS [RATIO]]\n");
  return 2;
} catch (const std::exception& error) {
  fmt::print(stderr, "stoss_adhesion: {}\n", error.what());
  return 1;
}
