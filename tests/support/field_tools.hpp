#pragma once

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss::test {

/// Weights of f(x + kh)/h, k = −4 … 4, for f'(x): exact for polynomials of degree 8.
inline constexpr std::array<double, 9> derivative_weights{1.0 / 280.0, -4.0 / 105.0, 1.0 / 5.0,   -4.0 / 5.0,  0.0,
                                                          4.0 / 5.0,   -1.0 / 5.0,   4.0 / 105.0, -1.0 / 280.0};

/// x + kh, k = −4 … 4.
inline std::vector<double> stencil(double x, double h) {
  std::vector<double> points;
  for (int k = -4; k <= 4; ++k) points.push_back(x + k * h);
  return points;
}

/// Derivative from the nine values first, first + stride, … at the points of a stencil.
inline double derivative(const std::vector<double>& values, std::size_t first, std::size_t stride, double h) {
  double sum = 0.0;
  for (std::size_t k = 0; k < 9; ++k) sum += derivative_weights[k] * values[first + k * stride];
  return sum / h;
}

/// Gauss points and weights of [0, 1] in four panels.
struct RadialRule {
  std::vector<double> radius, weight;

  RadialRule() {
    using Rule = boost::math::quadrature::gauss<double, 20>;
    for (int panel = 0; panel < 4; ++panel) {
      for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
        for (const double sign : {-1.0, 1.0}) {
          radius.push_back(0.125 * (2 * panel + 1 + sign * Rule::abscissa()[i]));
          weight.push_back(0.125 * Rule::weights()[i]);
        }
      }
    }
  }
};

/// Equally spaced angles of a whole turn, over which the mean is exact for all harmonics below `count`.
inline std::vector<double> whole_turn(int count) {
  std::vector<double> angle;
  for (int k = 0; k < count; ++k) angle.push_back(2.0 * std::numbers::pi * k / count);
  return angle;
}

/// Coordinates of the kept modes at rest under node forces in units of mc²/R: −Σ F_i (C c_i + S s_i)/ω².
inline std::vector<double> static_coordinates(const Body& body, const ContactGrid& grid,
                                              const std::vector<double>& force) {
  std::vector<double> coordinate;
  for (const ModeGroup& group : body.groups) {
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      double load = 0.0;
      for (std::size_t i = 0; i < force.size(); ++i) {
        const double phi = grid.coordinate[i];
        load -= force[i] * (group.upper[l] * std::cos((group.order + 1) * phi) +
                            group.lower[l] * std::cos((group.order - 1) * phi));
      }
      coordinate.push_back(load / (group.omega[l] * group.omega[l]));
    }
  }
  return coordinate;
}

}  // namespace stoss::test
