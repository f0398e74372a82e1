// Gases of 10⁴ rough elastic disks and spheres cool by their collisions, with rotation and friction.
//
// Run:     stoss_rough_gas FILE [COUNT]
// Expect:  temperatures of translation and of rotation against time in FILE, as CSV, of disks and of spheres with two
//          rules that lose the same at first: ε_n and s′ of stoss, and constant ε_n, ε_t; and of what mean-field theory
//          says of the constants (M. Huthmann and A. Zippelius, Phys. Rev. E 56, R6275, 1997); how fast it is.
//
// Particles are equal, and count as unexcited before each collision. Lengths in R, times in R/c, temperatures in ρc²
// times the area or the volume of a unit.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "gas.hpp"
#include "mean_field.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/table/adaptive_rule.hpp"

namespace {

constexpr double temperature = 1e-3;  // collisions at some 0.03 c
constexpr double friction = 0.3;
constexpr double least_energy = 1e-3, growth = 1.1;  // of the initial energy; of the time between two rows
constexpr double slowest = 1e-4, fastest = 0.1, tolerance = 0.05;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// What differs between disks and spheres.
struct Kind {
  std::string name;
  stoss::BodyMaker body;
  double packing;
};

/// Constant ε_n and ε_t = −s′/s.
gas::Rule constant(const gas::MeanField& rule) {
  return [rule](double, double sliding, double) { return gas::Outcome{rule.restitution, -rule.tangential * sliding}; };
}

gas::Rule of_table(const stoss::RuleTable& table) {
  return [&table](double speed, double sliding, double) {
    const stoss::Rule rule = table.unchecked(speed, sliding, friction);
    return gas::Outcome{rule.restitution.value, rule.sliding_after};
  };
}

/// A gas in equilibrium, and the constants with which its collisions lose as much as by a rule.
template <std::size_t D>
gas::MeanField same_loss(gas::Gas<D>& gas, const gas::Rule& rule) {
  const double step = 1.0 / std::sqrt(temperature);
  const auto perfect = [](double, double sliding, double) { return gas::Outcome{1.0, -sliding}; };
  const auto count = static_cast<long>(gas.size());
  while (gas.collisions() < 20 * count) gas.advance(gas.time() + step, perfect);
  double approach = 0.0, left = 0.0, slides = 0.0, slides_after = 0.0;
  while (gas.collisions() < 30 * count) {
    gas.advance(gas.time() + step, [&](double speed, double sliding, double ratio) {
      const gas::Outcome outcome = rule(speed, sliding, ratio);
      approach += speed * speed;
      left += outcome.restitution * outcome.restitution * speed * speed;
      slides += sliding * sliding;
      slides_after += outcome.sliding_after * outcome.sliding_after;
      return perfect(speed, sliding, ratio);
    });
  }
  // Of the two ε_t that lose as much, that of particles which reverse each other's sliding.
  return {D, std::sqrt(left / approach), std::sqrt(slides_after / slides)};
}

/// Lets a gas cool by a rule. One line for each time; beside the rule with what is said for the same collisions.
template <std::size_t D>
void cool(std::ostream& out, const std::string& name, gas::Gas<D> gas, const gas::Rule& rule,
          const gas::MeanField* theory) {
  gas::MeanField::State said{gas.temperature(), gas.temperature_of_rotation()};
  const double start = gas.time(), energy = gas.energy(), begin = seconds();
  const long before = gas.collisions();
  const auto count = static_cast<double>(gas.size());
  double collisions = 0.0;
  for (double time = 0.1 / std::sqrt(temperature); gas.energy() > least_energy * energy; time *= growth) {
    gas.advance(start + time, rule);
    const double now = 2.0 * static_cast<double>(gas.collisions() - before) / count;
    const auto line = [&](const std::string& law, double moving, double turning) {
      out << name << ',' << law << ',' << time << ',' << now << ',' << moving << ',' << turning << '\n';
    };
    line(theory == nullptr ? "stoss" : "constant", gas.temperature(), gas.temperature_of_rotation());
    if (theory != nullptr) {
      said = theory->after(said, now - collisions);
      line("mean field", said.moving, said.turning);
    }
    collisions = now;
  }
  const double took = seconds() - begin, all = static_cast<double>(gas.collisions() - before);
  std::printf("%-8s %-9s %8.0f collisions in %5.2f s, %7.0f a second\n", name.c_str(),
              theory == nullptr ? "stoss" : "constant", all, took, all / took);
}

template <std::size_t D>
void run(std::ostream& out, const Kind& kind, std::size_t count) {
  const double begin = seconds();
  const stoss::RuleTable table = stoss::rule_table(stoss::RefinableContact(kind.body, kind.body), slowest, fastest,
                                                   {.tolerance = tolerance, .beyond = stoss::Beyond::clamp});
  std::printf("%-8s table, errors %.1e and %.1e, %.1f s\n", kind.name.c_str(), table.greatest_restitution_error(),
              table.greatest_sliding_error(), seconds() - begin);
  gas::Gas<D> gas(std::vector<double>(count, 1.0), kind.packing, temperature, 1);
  const gas::MeanField constants = same_loss(gas, of_table(table));
  out << "# " << kind.name << ": constant restitution " << constants.restitution << ", tangential "
      << constants.tangential << "; packing " << kind.packing << '\n';
  cool(out, kind.name, gas, of_table(table), nullptr);
  cool(out, kind.name, gas, constant(constants), &constants);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::cerr << "usage: stoss_rough_gas FILE [COUNT]\n";
    return 2;
  }
  try {
    const std::size_t count = argc == 3 ? std::stoul(argv[2]) : 10'000;
    std::ofstream out(argv[1]);
    out.precision(8);
    out << "# " << count << " particles, friction " << friction << ", temperature " << temperature
        << "; made by `make results`. Columns: docs/understand/findings/gas.md.\n"
        << "body,rule,time[R/c],collisions,translation,rotation\n";
    run<2>(out, {"disks", stoss::disk(0.33), 0.3}, count);
    run<3>(out, {"spheres", stoss::sphere(0.3), 0.15}, count);
    if (!out.flush()) throw std::runtime_error(std::string("cannot write ") + argv[1]);
  } catch (const std::exception& problem) {
    std::cerr << "stoss_rough_gas: " << problem.what() << '\n';
    return 1;
  }
  return 0;
}
