#include "block_mesh.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>

namespace bench {
namespace {

using Line = SpectralRule::Row;  // the nodes of elements along a line

constexpr double growth = 3.0;   // of the size of an element over that before it
constexpr double largest = 1.2;  // R; the shear waves that leave a contact are longer

/// Continues lines of elements that grow.
void grow(std::vector<Line>& lines, double from, double length, double extent) {
  while (from < extent) {
    Line line;
    for (std::size_t i = 0; i < element_side; ++i) line[i] = from + length * (0.5 + 0.5 * lobatto.points[i]);
    lines.push_back(line);
    from += length;
    length = std::min(growth * length, largest);
  }
}

std::vector<Line> outwards(const MeshSize& ball, const BlockSize& size) {
  std::vector<Line> lines;
  const double angle = 0.25 * std::numbers::pi / ball.elements;  // of an element of the ball
  while (lines.empty() || lines.back().back() < size.contact_radius) {
    const SpectralRule& rule = lines.empty() ? lobatto_at_axis : lobatto;
    Line line;
    for (std::size_t i = 0; i < element_side; ++i) {
      line[i] = on_edge(angle * (static_cast<double>(lines.size()) + 0.5 + 0.5 * rule.points[i]), ball).across;
    }
    lines.push_back(line);
  }
  const double last = lines.back().back() - lines.back().front();
  grow(lines, lines.back().back(), growth * last, size.extent);
  return lines;
}

}  // namespace

std::vector<Element> block(const MeshSize& ball, const BlockSize& size) {
  const std::vector<Line> across = outwards(ball, size);
  std::vector<Line> down;
  grow(down, 0.0, across.front().back(), size.extent);
  std::vector<Element> elements;
  for (const Line& x : across) {
    for (const Line& z : down) {
      Element element{{}, &x == &across.front()};
      for (std::size_t node = 0; node < element_nodes; ++node) {
        element.nodes[node] = {x[node / element_side], 1.0 + z[node % element_side]};
      }
      elements.push_back(element);
    }
  }
  return elements;
}

}  // namespace bench
