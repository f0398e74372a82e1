#include "mesh.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace yield_study {
namespace {

using Place = std::complex<double>;

/// The quadrant of a circle: a square of n × n elements at its middle, and rings of 2n, which turn into circles.
struct Quadrant {
  std::vector<Place> nodes;  ///< real first in the square; then by rings, from the real to the imaginary axis
  std::vector<std::array<int, 4>> elements;
  int outer;  ///< first node of the outermost ring
};

Quadrant quadrant(int n, double side, double radius) {
  Quadrant quadrant;
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= n; ++i) quadrant.nodes.emplace_back(side * i / n, side * k / n);
  for (int k = 0; k < n; ++k)
    for (int i = 0; i < n; ++i) {
      const int corner = k * (n + 1) + i;
      quadrant.elements.push_back({corner, corner + 1, corner + n + 2, corner + n + 1});
    }
  const double decades = std::log(radius / side);
  const int rings = std::max(n, static_cast<int>(std::ceil(decades / std::log1p(1.57 / n))));
  std::vector<int> inner, ring;
  for (int j = 0; j <= 2 * n; ++j) inner.push_back(j <= n ? j * (n + 1) + n : n * (n + 1) + 2 * n - j);
  const std::vector<int> square = inner;
  for (int k = 1; k <= rings; ++k) {
    const double at = side * std::exp(decades * k / rings), round = std::min(1.0, static_cast<double>(k) / n);
    ring.clear();
    for (int j = 0; j <= 2 * n; ++j) {
      const Place corner = quadrant.nodes[static_cast<std::size_t>(square[static_cast<std::size_t>(j)])] / side;
      Place turned = std::polar(1.0, 0.25 * std::numbers::pi * j / n);
      if (j == 2 * n) turned = {0.0, 1.0};
      ring.push_back(static_cast<int>(quadrant.nodes.size()));
      quadrant.nodes.push_back(at * ((1.0 - round) * corner + round * turned));
    }
    for (std::size_t j = 0; j + 1 < ring.size(); ++j)
      quadrant.elements.push_back({inner[j], ring[j], ring[j + 1], inner[j + 1]});
    inner = ring;
  }
  quadrant.outer = inner.front();
  return quadrant;
}

std::array<int, 4> flipped(const std::array<int, 4>& element) {
  return {element[0], element[3], element[2], element[1]};
}

/// The conformal map of the upper half-plane to a disk on z = 0, the unit half-disk to its lower half.
Eigen::Vector2d on_sphere(Place at) {
  const Place to = 2.0 * at / (1.0 - Place(0.0, 1.0) * at);
  return {std::max(to.real(), 0.0), to.imag()};
}

}  // namespace

Solid sphere(int elements, double side) {
  constexpr double top = 0.3;
  const Quadrant lower = quadrant(elements, 0.5 * side, 1.0), upper = quadrant(elements, top, 1.0);
  Solid solid{{}, elements};
  for (const Place& node : lower.nodes) solid.mesh.nodes.push_back(on_sphere(node));
  solid.mesh.elements = lower.elements;
  const int added = static_cast<int>(lower.nodes.size());
  for (int k = 0; k < upper.outer; ++k) {
    const Eigen::Vector2d place = on_sphere(upper.nodes[static_cast<std::size_t>(k)]);
    solid.mesh.nodes.emplace_back(place[0], 2.0 - place[1]);
  }
  for (auto element : upper.elements) {
    for (int& node : element) node = node < upper.outer ? node + added : node - upper.outer + lower.outer;
    solid.mesh.elements.push_back(flipped(element));
  }
  return solid;
}

Solid block(int elements, double side, double size) {
  const Quadrant below = quadrant(elements, 0.5 * side, 0.5 * size);
  Solid solid{{}, elements};
  for (const Place& node : below.nodes) solid.mesh.nodes.emplace_back(2.0 * node.real(), -2.0 * node.imag());
  for (const auto& element : below.elements) solid.mesh.elements.push_back(flipped(element));
  return solid;
}

Body free_body(const Solid& solid, double poisson, double strength) {
  std::vector<Freedom> freedoms;
  int unknown = 0;
  for (const auto& node : solid.mesh.nodes) {
    freedoms.push_back({node[0] < 1e-12 ? -1 : unknown++, 1.0});
    freedoms.push_back({unknown++, 1.0});
  }
  return {solid.mesh, {1.0, poisson, strength}, std::move(freedoms)};
}

}  // namespace yield_study
