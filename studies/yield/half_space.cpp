#include "half_space.hpp"

#include <cmath>
#include <numbers>

namespace yield_study {
namespace {

constexpr double pi = std::numbers::pi;

/// Places along an axis: equal steps, then growing ones that end at the size.
std::vector<double> places(const Grid& grid) {
  std::vector<double> at{0.0};
  const int equal = static_cast<int>(std::lround(grid.fine / grid.element));
  for (int k = 1; k <= equal; ++k) at.push_back(grid.element * k);
  const double start = at.back(), rest = grid.size - start;
  // The count that comes nearest; the sum of its steps is then scaled to the rest by the ratio, found by bisection.
  const double wanted = std::log1p(rest / grid.element * (grid.growth - 1.0) / grid.growth) / std::log(grid.growth);
  const int count = std::max(1, static_cast<int>(std::lround(wanted)));
  const auto sum = [&](double ratio) {
    double total = 0.0, step = grid.element;
    for (int k = 0; k < count; ++k) total += step *= ratio;
    return total;
  };
  double low = 1.0, high = 2.0 * grid.growth;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (sum(middle) < rest ? low : high) = middle;
  }
  double step = grid.element;
  for (int k = 0; k < count; ++k) at.push_back(at.back() + (step *= low));
  at.back() = grid.size;
  return at;
}

}  // namespace

Eigen::Vector2d point_load_displacement(const Material& material, double r, double z) {
  const double depth = -z, distance = std::hypot(r, z), factor = 1.0 / (4.0 * pi * material.shear() * distance);
  const double nu = material.poisson;
  const double outwards = r * depth / (distance * distance) - (1.0 - 2.0 * nu) * r / (distance + depth);
  const double down = depth * depth / (distance * distance) + 2.0 * (1.0 - nu);
  return {factor * outwards, -factor * down};
}

Stress point_load_stress(const Material& material, double r, double z) {
  const double depth = -z, distance = std::hypot(r, z), nu = material.poisson;
  const double fifth = std::pow(distance, 5), mixed = (1.0 - 2.0 * nu) / (distance * (distance + depth));
  const double rr = mixed - 3.0 * r * r * depth / fifth;
  const double zz = -3.0 * std::pow(depth, 3) / fifth;
  const double around = (1.0 - 2.0 * nu) * depth / std::pow(distance, 3) - mixed;
  const double rz = 3.0 * r * depth * depth / fifth;  // positive: z points upwards
  return Stress(rr, zz, around, rz) / (2.0 * pi);
}

double point_load_energy(const Material& material, double size) {
  // Work of the tractions on the cylinder's outside. Both faces are integrals of smooth functions: Simpson's rule.
  constexpr int steps = 2000;
  double work = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const double weight = (k == 0 || k == steps ? 1.0 : k % 2 ? 4.0 : 2.0) * size / (3.0 * steps);
    const double along = size * k / steps;
    const Stress side = point_load_stress(material, size, -along), bottom = point_load_stress(material, along, -size);
    const Eigen::Vector2d of_side = point_load_displacement(material, size, -along);
    const Eigen::Vector2d of_bottom = point_load_displacement(material, along, -size);
    work -= weight * 2.0 * pi * size * (side[0] * of_side[0] + side[3] * of_side[1]);
    work += weight * 2.0 * pi * along * (bottom[3] * of_bottom[0] + bottom[1] * of_bottom[1]);
  }
  return work;
}

HalfSpace half_space(const Material& material, const Grid& grid) {
  const std::vector<double> at = places(grid);
  const int count = static_cast<int>(at.size());
  Mesh mesh;
  std::vector<Freedom> freedoms;
  std::vector<int> surface;
  int unknown = 0;
  for (int layer = 0; layer < count; ++layer)
    for (int k = 0; k < count; ++k) {
      const double r = at[static_cast<std::size_t>(k)], z = -at[static_cast<std::size_t>(layer)];
      if (layer == 0) surface.push_back(static_cast<int>(mesh.nodes.size()));
      mesh.nodes.emplace_back(r, z);
      if (k == count - 1 || layer == count - 1) {
        const Eigen::Vector2d far = point_load_displacement(material, r, z);
        freedoms.push_back({-2, k == 0 ? 0.0 : far[0]});
        freedoms.push_back({-2, far[1]});
      } else {
        freedoms.push_back({k == 0 ? -1 : unknown++, 1.0});
        freedoms.push_back({unknown++, 1.0});
      }
    }
  for (Freedom& freedom : freedoms)
    if (freedom.unknown == -2) freedom.unknown = unknown;
  for (int layer = 0; layer + 1 < count; ++layer)
    for (int k = 0; k + 1 < count; ++k) {
      const int corner = (layer + 1) * count + k;  // below, on the axis' side
      mesh.elements.push_back({corner, corner + 1, corner + 1 - count, corner - count});
    }
  Body body(std::move(mesh), material, std::move(freedoms));
  body.add_spring(unknown, point_load_energy(material, grid.size));
  return {std::move(body), std::move(surface)};
}

}  // namespace yield_study
