// An impact of round bodies that relax, by springs each of which lets go by itself, without Ting's law.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "quasistatic/relaxing_motion.hpp"

namespace stoss {
using namespace quasistatic;

namespace {

/// A spring of the row, with its branches.
struct Spring {
  double elongation = 0.0, heat = 0.0;
  std::vector<double> memory{};
  bool holds = true;

  [[nodiscard]] double force(const Relaxation& its) const {
    double sum = its.relaxed() * elongation;
    for (std::size_t j = 0; j < memory.size(); ++j) sum += its.terms[j].share * memory[j];
    return sum;
  }

  [[nodiscard]] double energy(const Relaxation& its) const {
    double sum = 0.5 * its.relaxed() * elongation * elongation;
    for (std::size_t j = 0; j < memory.size(); ++j) sum += 0.5 * its.terms[j].share * memory[j] * memory[j];
    return sum;
  }

  void follow(const Relaxation& its, double speed, double time) {
    elongation += speed * time;
    for (std::size_t j = 0; j < memory.size(); ++j) {
      const double last = memory[j], steady = speed * its.terms[j].time, left = std::exp(-time / its.terms[j].time);
      memory[j] = last * left + steady * (1.0 - left);
      const double squares = (last * last + last * memory[j] + memory[j] * memory[j]) / 3.0;
      heat += its.terms[j].share / its.terms[j].time * squares * time;
    }
  }
};

/// What an impact takes over the energy before: of the speed, and as heat of all springs with what they still hold.
struct Taken {
  double of_speed, as_heat;
};

/// Springs one by one, each of which lets go by itself: leapfrog in time, midpoints in x.
Taken by_springs(const Relaxation& its, int steps) {
  const double length = 2.0 / steps, time = 4.0 / steps;
  const auto start = [length](std::size_t i) { return std::pow((static_cast<double>(i) + 0.5) * length, 2); };
  std::vector<Spring> springs;
  double place = 0.0, speed = 1.0, force = 0.0;
  do {
    for (Spring& spring : springs) {
      if (spring.holds) spring.follow(its, speed, time);
    }
    place += speed * time;
    for (; start(springs.size()) < place;
         springs.back().follow(its, speed, (place - start(springs.size() - 1)) / speed)) {
      springs.push_back({.memory = std::vector<double>(its.terms.size())});
    }
    force = 0.0;
    for (Spring& spring : springs) {
      spring.holds = spring.holds && spring.force(its) > 0.0;
      if (spring.holds) force += 1.5 * length * spring.force(its);
    }
    speed -= force * time;
  } while (force > 0.0 || springs.empty());
  double heat = 0.0;
  for (const Spring& spring : springs) heat += spring.heat + spring.energy(its);
  return {1.0 - speed * speed, 3.0 * length * heat};
}

TEST(PointRelaxingImpact, IsThatOfSpringsOneByOneAndHeatsThem) {
  for (const Relaxation& its : {Relaxation{{{0.5, 1.0}}}, {{{0.4, 0.3}, {0.4, 5.0}}}, {{{0.9, 0.3}}}}) {
    const double restitution = relaxing_motion(Rates(its)).restitution;
    const Taken coarse = by_springs(its, 300), middle = by_springs(its, 600), fine = by_springs(its, 1200);
    for (double Taken::*const way : {&Taken::of_speed, &Taken::as_heat}) {
      const double first = 2.0 * middle.*way - coarse.*way, second = 2.0 * fine.*way - middle.*way;
      EXPECT_NEAR(second, 1.0 - restitution * restitution, 2.0 * std::abs(second - first) + 1e-5);
      EXPECT_LT(std::abs(second - first), 2e-4);
    }
  }
}

}  // namespace
}  // namespace stoss
