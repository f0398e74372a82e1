#include "half_disk_mesh.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace bench {
namespace {

constexpr double half_side = 0.5;  // of the square
constexpr double roundness = 0.4;  // of its sides: 0 straight, 1 a circle

Point in_square(double x, double z) {
  const double round_x = x * std::sqrt(1.0 - 0.5 * z * z);
  const double round_z = z * std::sqrt(1.0 - 0.5 * x * x);
  return {half_side * (x + roundness * (round_x - x)), half_side * (z + roundness * (round_z - z))};
}

/// Between the square's edge and the circle, from 0 to 1.
Point in_rings(double x, double z, double angle, double outwards) {
  const Point inner = in_square(x, z);
  return {inner.across + outwards * (std::sin(angle) - inner.across),
          inner.towards + outwards * (std::cos(angle) - inner.towards)};
}

Point graded(const Point& point, double grading) {
  const std::complex<double> from(point.towards, point.across);
  const std::complex<double> to = (from + grading) / (1.0 + grading * from);
  return {to.imag(), to.real()};
}

}  // namespace

std::vector<Element> half_disk(Symmetry symmetry, const MeshSize& size) {
  std::vector<Element> elements;
  const auto add_block = [&](bool at_axis, int rows, int columns, const auto& at) {  // `at` maps a unit square
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        Element element{{}, symmetry == Symmetry::axial && at_axis && row == 0};
        const SpectralRule& along_r = element.at_axis ? lobatto_at_axis : lobatto;
        for (std::size_t node = 0; node < element_nodes; ++node) {
          const double p = (row + 0.5 + 0.5 * along_r.points[node / element_side]) / rows;
          const double q = (column + 0.5 + 0.5 * lobatto.points[node % element_side]) / columns;
          element.nodes[node] = graded(at(p, q), size.grading);
        }
        elements.push_back(element);
      }
    }
  };
  constexpr double corner = 0.25 * std::numbers::pi;
  const int n = size.elements;
  add_block(true, n, 2 * n, [](double p, double q) { return in_square(p, 2.0 * q - 1.0); });
  add_block(true, n, size.rings, [](double p, double q) { return in_rings(p, 1.0, corner * p, q); });
  add_block(false, 2 * n, size.rings,
            [](double p, double q) { return in_rings(1.0, 1.0 - 2.0 * p, corner * (1.0 + 2.0 * p), q); });
  add_block(true, n, size.rings, [](double p, double q) { return in_rings(p, -1.0, corner * (4.0 - p), q); });
  return elements;
}

Point on_edge(double angle, const MeshSize& size) { return graded({std::sin(angle), std::cos(angle)}, size.grading); }

}  // namespace bench
