#pragma once

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/bodies/disk/modes.hpp"
#include "support/contact_problem.hpp"

namespace stoss::test {

/// The contact of a disk with a hard wall by another method than that of the library: a given half-width a, and a
/// pressure √(1−t²) Σ c_k U_2k(t), t = φ/a, per radian, whose moments with cos mφ are Bessel functions. The gap
/// vanishes in the mean with the weights T_2k(t)/√(1−t²), which gives c_k and δ. The sum over the orders goes to aN =
/// `reach`.
struct SpectralContact {
  double half_width;
  double compression = 0.0, force = 0.0, energy = 0.0;
  std::vector<double> coefficient;

  SpectralContact(double poisson, double a, std::size_t terms = 5, double reach = 3000.0) : half_width(a) {
    constexpr double pi = std::numbers::pi;
    const std::size_t size = terms + 1;
    const auto bessel = [](std::size_t k, double z) { return boost::math::cyl_bessel_j(static_cast<int>(k), z); };
    const auto sign = [](std::size_t k) { return k % 2 == 0 ? 1.0 : -1.0; };
    const auto load = [&](int m) {  // ∫ cos mφ √(1−t²) U_2k dφ
      std::vector<double> moment(terms);
      const double z = std::abs(m) * a;
      for (std::size_t k = 0; k < terms; ++k) {
        const double order = static_cast<double>(2 * k + 1);
        moment[k] = m == 0 ? (k == 0 ? 0.5 * pi * a : 0.0) : sign(k) * a * pi * order * bessel(2 * k + 1, z) / z;
      }
      return moment;
    };
    const auto mean = [&](int m) {  // mean of cos mφ with the weight T_2k/√(1−t²)
      std::vector<double> moment(size);
      for (std::size_t k = 0; k < size; ++k) moment[k] = sign(k) * bessel(2 * k, std::abs(m) * a);
      return moment;
    };
    std::vector<long double> matrix(size * size, 0.0L), right(size);
    std::vector<double> p_low = load(-1), p_here = load(0), p_high = load(1);
    std::vector<double> t_low = mean(-1), t_here = mean(0), t_high = mean(1);
    const std::vector<double> total = p_here, lifted = p_high;
    for (std::size_t k = 0; k < size; ++k) {
      matrix[k * size + terms] = -t_here[k];
      right[k] = t_high[k] - t_here[k];
    }
    const int orders = static_cast<int>(reach / a);
    for (int n = 0; n <= orders; ++n) {
      const bodies::disk::Flexibility f = bodies::disk::static_flexibility(poisson, n);
      for (std::size_t j = 0; j < terms; ++j) {
        const double c = 0.5 * (p_low[j] + p_high[j]), s = 0.5 * (p_high[j] - p_low[j]);
        const double radial = (f.radial * c + f.mixed * s) / pi, tangential = (f.mixed * c + f.tangential * s) / pi;
        for (std::size_t k = 0; k < size; ++k) {
          matrix[k * size + j] += radial * 0.5 * (t_low[k] + t_high[k]) + tangential * 0.5 * (t_high[k] - t_low[k]);
        }
      }
      p_low = p_here, p_here = p_high, p_high = load(n + 2);
      t_low = t_here, t_here = t_high, t_high = mean(n + 2);
    }
    const std::vector<long double> solution = gauss(matrix, right);
    compression = static_cast<double>(solution[terms]);
    for (std::size_t k = 0; k < terms; ++k) {
      coefficient.push_back(static_cast<double>(solution[k]));
      force += coefficient[k] * total[k] / pi;
      energy += 0.5 * coefficient[k] * (compression * total[k] - (total[k] - lifted[k])) / pi;
    }
  }

  /// Pressure in E.
  [[nodiscard]] double pressure(double phi) const {
    if (std::abs(phi) >= half_width) return 0.0;
    const double theta = std::acos(phi / half_width);  // √(1−t²) U_2k(t) = sin (2k+1)θ
    double sum = 0.0;
    for (std::size_t k = 0; k < coefficient.size(); ++k) {
      sum += coefficient[k] * std::sin(static_cast<double>(2 * k + 1) * theta);
    }
    return sum;
  }
};

}  // namespace stoss::test
