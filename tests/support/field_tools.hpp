#pragma once

#include <gtest/gtest.h>

#include <algorithm>
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

/// Second derivative from the nine values first, first + stride, … at the points of a stencil.
inline double second_derivative(const std::vector<double>& values, std::size_t first, std::size_t stride, double h) {
  constexpr std::array<double, 9> weights{-1.0 / 560.0, 8.0 / 315.0, -0.2,        1.6,         -205.0 / 72.0,
                                          1.6,          -0.2,        8.0 / 315.0, -1.0 / 560.0};
  double sum = 0.0;
  for (std::size_t k = 0; k < 9; ++k) sum += weights[k] * values[first + k * stride];
  return sum / (h * h);
}

/// Derivatives of a component at the middle of a 9 × 9 stencil, whose columns are `across` and rows `deep` apart.
struct Derivatives {
  double value, r, z, rr, rz, zz;

  Derivatives(const std::vector<double>& u, double across, double deep) : value(u[40]) {
    std::vector<double> along(9), down(9);
    for (std::size_t i = 0; i < 9; ++i) {
      along[i] = derivative(u, 9 * i, 1, across);
      down[i] = derivative(u, i, 9, deep);
    }
    r = along[4];
    z = down[4];
    rz = derivative(along, 0, 1, deep);
    rr = second_derivative(u, 36, 1, across);
    zz = second_derivative(u, 4, 9, deep);
  }
};

/// Weights of f(x + kh)/h, k = 0 … 6, for f'(x), from one side.
inline constexpr std::array<double, 7> one_sided_weights{-49.0 / 20.0, 6.0, -7.5, 20.0 / 3.0, -3.75, 1.2, -1.0 / 6.0};

/// The coordinates of one mode by itself.
inline std::vector<double> only(const Body& body, std::size_t mode) {
  std::vector<double> coordinate(mode_count(body), 0.0);
  coordinate[mode] = 1.0;
  return coordinate;
}

/// The surface of a half-space or plate gives way, inside its field, as the body says: by its modes, wherever they are,
/// and by its residual compliance. `field` is that at distances on the surface, with coordinates and forces.
template <typename FieldAt>
void expect_surface_gives_way(const Body& body, const ContactPoints& contact, const FieldAt& field) {
  std::vector<double> distance, coordinate, force;
  for (std::size_t i = 0; i < contact.count; ++i) {
    distance.push_back(std::sin(contact.angle(i)));
    force.push_back(1e-3 * std::sin(0.1 * static_cast<double>(i) + 0.2));
  }
  for (std::size_t k = 0; k < mode_count(body); ++k) coordinate.push_back(1e-3 * std::sin(static_cast<double>(k)));
  const auto at = field(distance, coordinate, force);
  const Surface surface = body.surface(contact);
  const std::vector<double> compliance = body.residual_compliance(contact, {});
  std::vector<double> expected(contact.count, 0.0);
  double greatest = 0.0;
  for (std::size_t i = 0; i < contact.count; ++i) {
    std::size_t k = 0;
    for (const ModeGroup& group : body.groups) {
      const double shape = surface.shape[group.upper_row * contact.count + i];
      for (const double amplitude : group.upper) expected[i] -= amplitude * shape * coordinate[k++];
    }
    for (std::size_t j = 0; j < contact.count; ++j) expected[i] += compliance[i * contact.count + j] * force[j];
    greatest = std::max(greatest, std::abs(expected[i]));
  }
  // Each pair of contact points has its own highest wave number, the field only one.
  for (std::size_t i = 0; i < contact.count; ++i) EXPECT_NEAR(at.normal[i], expected[i], 2e-3 * greatest) << i;
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
