// A gas of 10⁴ elastic disks of radii R … 2R cools by its collisions, and Haff's law fails.
//
// Run:     stoss_gas FILE DISKS [COUNT]
// Expect:  energy against time in FILE, as CSV, for three laws of ε that lose the same at first: ε(v, ratio) of stoss,
//          a constant, and 1 − ε ∝ v^(1/5); where the disks are at the end with the constant in DISKS; how fast it is.
//
//     constant ε      E = E₀ (1 + t/τ)^(−2)     (Haff 1983)
//     1 − ε ∝ v^(1/5)     E ~ t^(−5/3)           (Brilliantov and Pöschel, Phys. Rev. E 61, 5573, 2000)
//
// Disks are smooth, and count as unexcited before each collision. Lengths in R, times in R/c.
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
#include "stoss/table/adaptive_pairs.hpp"

namespace {

constexpr double poisson = 0.33, packing = 0.3;
constexpr double largest = 2.0;                       // radius of the largest disk over that of the smallest
constexpr double temperature = 0.016;                 // collisions at some 0.1 c
constexpr double least_energy = 3e-4, growth = 1.08;  // of the initial energy; of the time between two rows
constexpr long most_collisions = 2000;                // of a disk
constexpr double slowest = 1e-6, fastest = 0.5, error = 1e-3;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::vector<double> radii(std::size_t count) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(1.0 + (largest - 1.0) * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return all;
}

/// Speeds and ratios of collisions of a gas that keeps its energy, to judge and to time laws with.
struct Collisions {
  std::vector<double> speed, ratio;

  /// Share of the energy along the line of centres that a law takes of all of them.
  [[nodiscard]] double lost(const gas::Law& law) const {
    double energy = 0.0, gone = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
      const double e = law(speed[i], ratio[i]), share = speed[i] * speed[i];
      energy += share;
      gone += (1.0 - e * e) * share;
    }
    return gone / energy;
  }

  /// ns that a call of a law takes.
  [[nodiscard]] double time_of(const gas::Law& law) const {
    constexpr int repetitions = 50;
    double sum = 0.0, best = 1.0;
    for (int k = 0; k < repetitions; ++k) {
      const double begin = seconds();
      for (std::size_t i = 0; i < speed.size(); ++i) sum += law(speed[i], ratio[i]);
      best = std::min(best, seconds() - begin);
    }
    if (!(sum > 0.0)) throw std::logic_error("a law of no restitution");
    return 1e9 * best / static_cast<double>(speed.size());
  }
};

/// A gas that has forgotten its lattice, with some collisions of it.
gas::Gas<2> prepared(std::size_t count, Collisions& seen) {
  constexpr std::size_t enough = 4096;
  gas::Gas<2> gas(radii(count), packing, temperature, 1);
  const double step = 1.0 / std::sqrt(temperature);
  while (gas.collisions() < 20 * static_cast<long>(count)) {
    gas.advance(gas.time() + step, gas::smooth([](double, double) { return 1.0; }));
  }
  while (seen.speed.size() < enough) {
    gas.advance(gas.time() + step, gas::smooth([&seen](double speed, double ratio) {
                  seen.speed.push_back(speed);
                  seen.ratio.push_back(ratio);
                  return 1.0;
                }));
  }
  return gas;
}

/// Variance of the number of disks in a square over its mean; some 25 are in a square.
double fluctuation(const gas::Gas<2>& gas) {
  const std::vector<gas::Particle<2>> disks = gas.particles();
  const auto row = static_cast<std::size_t>(std::sqrt(static_cast<double>(disks.size()) / 25.0));
  std::vector<double> number(row * row);
  const auto index = [&](double place) {
    const double share = place / gas.side();
    return static_cast<std::size_t>((share - std::floor(share)) * static_cast<double>(row)) % row;
  };
  for (const gas::Particle<2>& disk : disks) number[index(disk.place[1]) * row + index(disk.place[0])] += 1.0;
  const double mean = static_cast<double>(disks.size()) / static_cast<double>(number.size());
  double sum = 0.0;
  for (const double each : number) sum += (each - mean) * (each - mean);
  return sum / static_cast<double>(number.size()) / mean;
}

/// Lets a gas cool by a law. One line for each time.
void cool(std::ostream& out, const std::string& name, gas::Gas<2>& gas, const gas::Law& law, double time_of_law) {
  const double energy = gas.energy(), start = gas.time(), begin = seconds();
  const long before = gas.collisions();
  const auto count = static_cast<double>(gas.particles().size());
  const gas::Rule limited = gas::smooth([&](double speed, double ratio) {
    if (static_cast<double>(gas.collisions() - before) > 0.5 * most_collisions * count) {
      throw std::runtime_error(name + ": the gas collapses (take an ε nearer to 1)");
    }
    return law(speed, ratio);
  });
  double left = 1.0;
  for (double time = 0.1 / std::sqrt(temperature); left > least_energy; time *= growth) {
    gas.advance(start + time, limited);
    left = gas.energy() / energy;
    out << name << ',' << time << ',' << 2.0 * static_cast<double>(gas.collisions() - before) / count << ',' << left
        << ',' << fluctuation(gas) << '\n';
  }
  const double took = seconds() - begin, all = static_cast<double>(gas.collisions() - before);
  std::printf("%-10s %8.0f collisions in %5.2f s, %7.0f a second; %5.1f ns for the law, %4.2f %% of the time\n",
              name.c_str(), all, took, all / took, time_of_law, 1e-7 * time_of_law * all / took);
}

/// The parameter between 0 and 1 with which a law takes as much as wanted, which rises with it.
template <typename MakeLaw>
double fitted(const Collisions& seen, double lost, MakeLaw law) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (seen.lost(law(middle)) < lost ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

void run(const std::string& file, const std::string& places, std::size_t count) {
  using stoss::PairTable;
  const double begin = seconds();
  const PairTable table = stoss::pair_table(stoss::mixture(stoss::Disk{.poisson = poisson}), slowest, fastest, 1.0,
                                            largest, {.error = error, .beyond = stoss::Beyond::clamp});
  std::printf("table      %zu speeds, %zu ratios, error %.1e, %.2f s\n", table.values().speeds.size(),
              table.values().ratios.size(), table.greatest_error(), seconds() - begin);
  Collisions seen;
  const gas::Gas<2> start = prepared(count, seen);
  const gas::Law computed = [&table](double speed, double ratio) { return table.value(speed, ratio); };
  const auto constant = [](double lost) -> gas::Law { return [e = 1.0 - lost](double, double) { return e; }; };
  const auto power = [](double factor) -> gas::Law {
    return [factor](double speed, double) { return 1.0 - factor * std::pow(speed, 0.2); };
  };
  const double lost = seen.lost(computed), a = fitted(seen, lost, constant), b = fitted(seen, lost, power);

  std::ofstream out(file);
  out.precision(8);
  out << "# " << count << " disks, nu = " << poisson << ", R to " << largest << " R, packing " << packing
      << ", mean energy " << temperature << " rho c^2 R^2; table: error " << error << ", constant: restitution "
      << 1.0 - a << ", power: 1 - " << b
      << " (v/c)^(1/5); made by `make results`. Columns: docs/understand/findings/gas.md.\n"
      << "law,time[R/c],collisions,energy,fluctuation\n";
  gas::Gas<2> gas = start;
  cool(out, "stoss", gas, computed, seen.time_of(computed));
  gas = start;
  cool(out, "power", gas, power(b), seen.time_of(power(b)));
  gas = start;
  cool(out, "constant", gas, constant(a), seen.time_of(constant(a)));

  std::ofstream last(places);
  last << "x,y,radius,side\n";
  for (const gas::Particle<2>& disk : gas.particles()) {
    last << disk.place[0] << ',' << disk.place[1] << ',' << disk.radius << ',' << gas.side() << '\n';
  }
  if (!out.flush() || !last.flush()) throw std::runtime_error("cannot write " + file + " or " + places);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    std::cerr << "usage: stoss_gas FILE DISKS [COUNT]\n";
    return 2;
  }
  try {
    run(argv[1], argv[2], argc == 4 ? std::stoul(argv[3]) : 10'000);
  } catch (const std::exception& problem) {
    std::cerr << "stoss_gas: " << problem.what() << '\n';
    return 1;
  }
  return 0;
}
