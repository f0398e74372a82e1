// Lamb's kernel of the surface of a half-space: its spectrum against its closed form, and its moments.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "bodies/half_space/lamb_kernel.hpp"

namespace stoss::bodies::half_space {
namespace {

// The first are those of half-planes with a 2-D ratio of −0.95, −0.8 and −0.5.
constexpr double poissons[] = {-19.0, -4.0, -1.0, -0.95, -0.5, -0.1, 0.0, 1e-3, 0.1, 0.25, 0.2631, 0.3, 0.45, 0.4999};
constexpr double infinity = std::numeric_limits<double>::infinity();

/// a_R f(x_R) + ∫ρ f dx for an f that falls as 1/x² or faster, in x = 1/√t.
/// @tparam Density ρ at t = 1/x²
template <typename Density, typename Function>
auto over_spectrum(const LambKernel& kernel, double rayleigh_weight, Density density, Function f) {
  boost::math::quadrature::tanh_sinh<double> integrate;
  const auto integrand = [&](double t) {
    if (t < 1e-60) return 0.0;  // of no weight, and x³ would overflow
    const double x = 1.0 / std::sqrt(t);
    return density(t) * 0.5 * x * x * x * f(x);
  };
  return rayleigh_weight * f(kernel.rayleigh_root) + integrate.integrate(integrand, 0.0, kernel.squared_ratio) +
         integrate.integrate(integrand, kernel.squared_ratio, 1.0);
}

template <typename Function>
auto over_spectrum(const LambKernel& kernel, Function f) {
  return over_spectrum(
      kernel, kernel.rayleigh_weight, [&](double t) { return kernel.density_at(t); }, f);
}

template <typename Function>
auto over_spectrum(const LambKernel& kernel, const Spectrum& spectrum, Function f) {
  return over_spectrum(
      kernel, spectrum.rayleigh_weight, [&](double t) { return spectrum.density_at(kernel, t); }, f);
}

TEST(LambKernel, HasTheNumbersOfForty) {
  // x_R, a_R and C in 40 digits, by quadrature of the kernel's own formula.
  constexpr double table[][4] = {{-19.0, 0.22357005417790876, 0.0487495763544711585, 21.864359528344073},
                                 {-4.0, 0.44584157543445115, 0.17986252413213656, 2.5866069970894221},
                                 {-1.0, 0.68889218253401811, 0.36742840277581329, 0.61003346328060495},
                                 {-0.95, 0.69649570501195069, 0.37289368811451994, 0.58619564465431196},
                                 {-0.5, 0.77423922544015418, 0.42041905779104168, 0.38936393531777657},
                                 {0.0, 0.87403204889764214, 0.43457379350328036, 0.21396397512394332},
                                 {0.1, 0.89310600502493712, 0.42766227927779118, 0.18556388574636431},
                                 {0.25, 0.91940168676196612, 0.41360215960093316, 0.14813387739032588},
                                 {0.2631, 0.9215395362502309, 0.41232960867871571, 0.14519379004194552},
                                 {0.3, 0.92741270970293665, 0.40884056222254078, 0.13722707306672996},
                                 {0.45, 0.94895969787227151, 0.39849307842683852, 0.11047433922119931},
                                 {0.4999, 0.95530019893209882, 0.39755315602429963, 0.1044328163376801}};
  for (const auto& [poisson, root, weight, coefficient] : table) {
    const LambKernel kernel = lamb_kernel(poisson);
    EXPECT_NEAR(kernel.rayleigh_root, root, 1e-15) << poisson;
    EXPECT_NEAR(kernel.rayleigh_weight, weight, 2e-15) << poisson;
    EXPECT_NEAR(radiation_coefficient(kernel), coefficient, 1e-14 * coefficient) << poisson;
  }
}

TEST(LambKernel, ObeysItsSumRules) {
  for (const double poisson : poissons) {
    const LambKernel kernel = lamb_kernel(poisson);
    EXPECT_NEAR(over_spectrum(kernel, [](double x) { return 1.0 / (x * x); }), 1.0, 1e-14) << poisson;
    EXPECT_NEAR(over_spectrum(kernel, [](double x) { return 1.0 / (x * x * x * x); }), kernel.second_moment,
                1e-14 * std::max(1.0, kernel.second_moment))
        << poisson;
    EXPECT_NEAR(over_spectrum(kernel, [](double x) { return 1.0 / (x * x * x); }) * 0.25 * (1.0 - poisson),
                radiation_coefficient(kernel), 1e-14)
        << poisson;
  }
}

TEST(LambKernel, IsTheSpectrumOfItsClosedForm) {
  using Complex = std::complex<double>;
  for (const double poisson : poissons) {
    const LambKernel kernel = lamb_kernel(poisson);
    for (const Complex zeta : {Complex{1.0, 0.0}, Complex{0.3, 0.5}, Complex{0.1, 2.0}, Complex{2.0, -3.0}}) {
      const Complex square = zeta * zeta, b = std::sqrt(1.0 + square);
      const Complex a = std::sqrt(1.0 + kernel.squared_ratio * square);
      const Complex closed = a * square / ((1.0 - poisson) * ((2.0 + square) * (2.0 + square) - 4.0 * a * b));
      const double real = over_spectrum(kernel, [&](double x) { return (1.0 / (square + x * x)).real(); });
      const double imaginary = over_spectrum(kernel, [&](double x) { return (1.0 / (square + x * x)).imag(); });
      EXPECT_NEAR(real, closed.real(), 1e-13) << poisson << " " << zeta;
      EXPECT_NEAR(imaginary, closed.imag(), 1e-13) << poisson << " " << zeta;
    }
  }
}

TEST(LambKernel, IsPositiveAndEndsAtItsLimit) {
  for (const double poisson : poissons) {
    const LambKernel kernel = lamb_kernel(poisson);
    EXPECT_GT(kernel.rayleigh_weight, 0.0);
    EXPECT_EQ(kernel.density(1.0), 0.0);
    for (double x = 1.0 + 1e-12; x < 1e6; x = 1.0 + 1.3 * (x - 1.0)) EXPECT_GE(kernel.density(x), 0.0) << poisson;
    const double limit = 2.0 / std::numbers::pi * std::sqrt(kernel.squared_ratio) / (1.0 - poisson);
    EXPECT_NEAR(kernel.density(infinity), limit, 1e-15);
    EXPECT_NEAR(kernel.density(1e9), limit, 1e-15);
  }
}

TEST(LambKernel, GivesTwoThirdsToTheRayleighWave) {
  // G. F. Miller and H. Pursey, Proc. R. Soc. A 233, 55 (1955): 67 % at ν = ¼.
  const LambKernel kernel = lamb_kernel(0.25);
  const double share = 0.1875 * kernel.rayleigh_weight / std::pow(kernel.rayleigh_root, 3);
  EXPECT_NEAR(share / radiation_coefficient(kernel), 0.67, 5e-3);
}

TEST(SpectraAlongTheSurface, ObeyTheirSumRules) {
  for (const double poisson : {-0.95, -0.5, 0.0, 0.25, 0.3, 0.45, 0.4999}) {
    const LambKernel kernel = lamb_kernel(poisson);
    const auto all = spectra(kernel, Direction::along);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_NEAR(all[0].share + all[1].share, 1.0, 1e-15);
    for (const Spectrum& its : all) {
      // The rule loses half of the digits where ρ begins as 1/√(x − 1), and at ν = 0, where it does so again at the
      // speed of pressure waves.
      const double error = its.steep ? 1e-7 : (poisson == 0.0 ? 1e-8 : 1e-13);
      EXPECT_NEAR(over_spectrum(kernel, its, [](double x) { return 1.0 / (x * x); }), 1.0, error) << poisson;
      EXPECT_NEAR(over_spectrum(kernel, its, [](double x) { return 1.0 / (x * x * x * x); }), its.second_moment,
                  error * std::max(1.0, its.second_moment))
          << poisson;
    }
  }
}

TEST(SpectraAlongTheSurface, AreThoseOfTheirClosedForms) {
  for (const double poisson : {-0.95, -0.5, 0.0, 0.25, 0.3, 0.45}) {
    const LambKernel kernel = lamb_kernel(poisson);
    const auto all = spectra(kernel, Direction::along);
    for (const double zeta : {0.2, 0.7, 3.0}) {
      const double square = zeta * zeta, b = std::sqrt(1.0 + square);
      const double a = std::sqrt(1.0 + kernel.squared_ratio * square);
      const auto response = [square](double x) { return 1.0 / (square + x * x); };
      const double closed = b * square / ((1.0 - poisson) * ((2.0 + square) * (2.0 + square) - 4.0 * a * b));
      EXPECT_NEAR(over_spectrum(kernel, all[0], response), closed, poisson == 0.0 ? 1e-8 : 1e-12)
          << poisson << ' ' << zeta;
      EXPECT_NEAR(over_spectrum(kernel, all[1], response), 1.0 / b, 1e-7) << poisson << ' ' << zeta;
    }
  }
}

}  // namespace
}  // namespace stoss::bodies::half_space
