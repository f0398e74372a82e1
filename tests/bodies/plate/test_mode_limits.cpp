// Modes that are known by themselves: Rayleigh's wave, waves across, and the vibrations of the thickness.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "bodies/plate/branches.hpp"
#include "support/plate_materials.hpp"

namespace stoss {
namespace plate_mode_limits {
namespace {

using namespace bodies::plate;
using std::numbers::pi;

class ModesOf : public testing::TestWithParam<test::Slab> {
 protected:
  const test::Slab its = GetParam();
  const std::vector<Sheets> parts = parts_of({its.sheet()});

  [[nodiscard]] double lowest(std::size_t part, double k) const {
    return branches<2>(parts[part], k, 1.05 * k * its.pressure_speed() + 1e-3, {}).omega.front();
  }
};

TEST_P(ModesOf, ThickPlateCarriesRayleighsWave) {
  const double ratio = std::pow(its.shear_speed() / its.pressure_speed(), 2);
  const auto rayleigh = [&](double x) {  // x = (c/c_s)²
    return std::pow(2.0 - x, 2) - 4.0 * std::sqrt((1.0 - x) * (1.0 - ratio * x));
  };
  std::uintmax_t most = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(rayleigh, 0.05, 1.0 - 1e-9,
                                                             boost::math::tools::eps_tolerance<double>(50), most);
  const double speed = its.shear_speed() * std::sqrt(0.5 * (low + high));
  for (const double kh : {150.0, 400.0}) {
    const double k = kh / its.thickness;
    for (const std::size_t part : {0U, 1U}) EXPECT_NEAR(lowest(part, k) / (k * speed), 1.0, 1e-12) << kh;
  }
}

// ω² = c_s²(k² + (nπ/h)²) with φ² = 2/ρh, for n = 0 half of it.
TEST_P(ModesOf, WavesAcrossAreThoseOfAString) {
  const double h = its.thickness;
  for (const double k : {1e-3, 0.3, 2.0, 30.0}) {
    const double cutoff = its.shear_speed() * std::hypot(k, 12.5 * pi / h);
    std::vector<std::pair<double, double>> found;
    for (const Sheets& part : parts) {
      const Branches<1> its_modes = branches<1>(part, k, cutoff, {});
      for (std::size_t m = 0; m < its_modes.omega.size(); ++m) {
        found.emplace_back(its_modes.omega[m], part.share * std::pow(its_modes.amplitude[m](0), 2));
      }
    }
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), 13U) << k;
    for (std::size_t n = 0; n < found.size(); ++n) {
      const double omega = its.shear_speed() * std::hypot(k, static_cast<double>(n) * pi / h);
      EXPECT_NEAR(found[n].first / omega, 1.0, 1e-12) << k << ' ' << n;
      EXPECT_NEAR(found[n].second * its.density * h, n == 0 ? 1.0 : 2.0, 1e-9) << k << ' ' << n;
    }
  }
}

// Long waves: pressure waves between the faces, nπc_p/h, odd n symmetric; those of shear hardly move them outward.
TEST_P(ModesOf, LongWavesAreVibrationsOfTheThickness) {
  const double h = its.thickness, k = 1e-5 / h, cutoff = 3.5 * pi * its.pressure_speed() / h;
  for (const std::size_t part : {0U, 1U}) {
    const Branches<2> found = branches<2>(parts[part], k, cutoff, {});
    for (int n = part == 0 ? 1 : 2; n <= 3; n += 2) {
      const double omega = n * pi * its.pressure_speed() / h;
      double strength = 0.0;  // shear modes may be at the same frequency
      for (std::size_t m = 0; m < found.omega.size(); ++m) {
        if (std::abs(found.omega[m] / omega - 1.0) < 1e-4) strength += std::pow(found.amplitude[m](1), 2);
      }
      EXPECT_NEAR(strength * its.density * h, 4.0, 1e-3) << n;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, ModesOf, testing::ValuesIn(test::every_slab),
                         [](const auto& its) { return "number" + std::to_string(its.index); });

}  // namespace
}  // namespace plate_mode_limits
}  // namespace stoss
