// Oblique impact with friction: ε_t of spheres and disks, what size and dynamics add to Maw's curve, alumina on glass,
// coupling, superballs, and the force laws of particle codes. Writes CSV files into a folder.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <future>
#include <string>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "study.hpp"

namespace study {

double contact_radius(double poisson, double speed, bool half_space) {
  const double modulus = (half_space ? 0.5 : 1.0) / (1.0 - poisson * poisson);
  return std::pow(1.25 * M_PI * speed * speed / modulus, 0.2);
}

std::vector<stoss::ObliqueRestitution> rules(const stoss::RefinableContact& contact, double speed, double friction,
                                             const std::vector<double>& obliquities, double tolerance) {
  std::vector<stoss::Obliquity> all;
  for (const double x : obliquities) all.push_back({.tangential = x * friction * speed, .friction = friction});
  return stoss::oblique_restitution(contact, speed, all, {.tolerance = tolerance});
}

std::vector<double> range(double from, double to, double step) {
  std::vector<double> all;
  for (int i = 0; from + i * step < to + 0.5 * step; ++i) all.push_back(from + i * step);
  return all;
}

stoss::RefinableContact disk_at_wall(double poisson) { return stoss::RefinableContact(stoss::disk(poisson)); }

stoss::RefinableContact equal_disks(double poisson) { return {stoss::disk(poisson), stoss::disk(poisson)}; }

}  // namespace study

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: stoss_oblique FOLDER\n");
    return 2;
  }
  try {
    const std::string folder = std::string(argv[1]) + "/";
    const std::vector<std::pair<void (*)(const std::string&), std::string>> tables{
        {study::write_coupling, "coupling"},   {study::write_curves, "curves"},
        {study::write_normal, "normal"},       {study::write_size, "size"},
        {study::write_superball, "superball"}, {study::write_finite_elements, "finite_elements"},
        {study::write_glass, "glass"},         {study::write_dem, "dem"},
    };
    std::vector<std::future<void>> running;
    for (const auto& [write, name] : tables) {
      running.push_back(std::async(std::launch::async, write, folder + name + ".csv"));
    }
    for (std::future<void>& each : running) each.get();
  } catch (const std::exception& error) {
    fmt::print(stderr, "stoss_oblique: {}\n", error.what());
    return 1;
  }
  return 0;
}
