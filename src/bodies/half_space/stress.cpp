// The law of Hooke for what changes the shape, σ − σ̄ = 2μ (ε − ε̄), 2μ = E/(1 + ν).
#include "stoss/bodies/half_space/stress.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>

#include "bodies/field_arguments.hpp"
#include "check.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::half_space {
namespace {

constexpr std::size_t fewest = 3;
constexpr double rounding = 1e-6;  // of the depths of a face

void require_places(const std::string& name, const std::vector<double>& places) {
  require(name + " count", static_cast<long>(places.size()), static_cast<long>(fewest), 1'000'000, "for a parabola");
  if (std::adjacent_find(places.begin(), places.end(), std::greater_equal<>()) != places.end()) {
    throw InvalidInput::out_of_range(name, "places that do not ascend", "ascending ones", "sort them");
  }
}

/// Places from `begin` up to `end`.
struct Stretch {
  std::size_t begin, end;
};

/// Derivative at one of some places: that of the parabola through it and its neighbours, all in a stretch of them.
class Slope {
 public:
  Slope(const std::vector<double>& places, std::size_t at, Stretch among)
      : first_(std::clamp<std::size_t>(at, among.begin + 1, among.end - 2) - 1) {
    for (std::size_t i = 0; i < fewest; ++i) {
      const double own = places[first_ + i];
      const double a = places[first_ + (i + 1) % fewest], b = places[first_ + (i + 2) % fewest];
      weight_[i] = (2.0 * places[at] - a - b) / ((own - a) * (own - b));
    }
  }

  /// @param values at the places, `stride` apart
  [[nodiscard]] double of(const double* values, std::size_t stride) const {
    values += first_ * stride;
    return weight_[0] * values[0] + weight_[1] * values[stride] + weight_[2] * values[2 * stride];
  }

 private:
  std::size_t first_;
  std::array<double, fewest> weight_{};
};

/// The depths of each layer; of one with too few of them all there are.
std::vector<Stretch> stretches_of(const std::vector<ElasticLayer>& layers, const std::vector<double>& depth) {
  std::vector<Stretch> all;
  std::size_t begin = 0;
  for (const ElasticLayer& layer : layers) {
    const bool last = &layer == &layers.back();
    const auto end = last ? depth.end() : std::upper_bound(depth.begin(), depth.end(), layer.end * (1.0 + rounding));
    all.push_back({begin, static_cast<std::size_t>(end - depth.begin())});
    begin = all.back().end;
  }
  return all;
}

}  // namespace

Stress stress(Contour contour, double poisson, const PlaneGrid& points, const Field& field) {
  return stress(contour, {{std::numeric_limits<double>::infinity(), poisson, 1.0}}, points, field);
}

Stress stress(Contour contour, const std::vector<ElasticLayer>& layers, const PlaneGrid& points, const Field& field) {
  const auto& [distance, depth] = points;
  require_places("distance", distance);
  require_places("depth", depth);
  const std::size_t columns = distance.size(), count = depth.size() * columns;
  require_length("lateral", field.lateral.size(), count, "one for each point");
  require_length("normal", field.normal.size(), count, "one for each point");
  require("layers", static_cast<long>(layers.size()), 1, 1'000'000, "below the surface");
  const std::vector<Stretch> stretches = stretches_of(layers, depth);
  const Stretch across{0, columns};
  std::size_t layer = 0;
  const double* const lateral = field.lateral.data();
  const double* const normal = field.normal.data();
  Stress result;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    while (i >= stretches[layer].end) ++layer;
    const double poisson = layers[layer].poisson, modulus = layers[layer].young / (1.0 + poisson);  // 2μ
    Stretch within = stretches[layer];
    // Both layers have the points of the face between them.
    if (within.begin > 0 && depth[within.begin - 1] >= layers[layer - 1].end * (1.0 - rounding)) --within.begin;
    if (within.end - within.begin < fewest) within = {0, depth.size()};
    const Slope down(depth, i, within);
    for (std::size_t j = 0; j < columns; ++j) {
      const Slope out(distance, j, across);
      const double rr = out.of(lateral + i * columns, 1), zz = down.of(normal + j, columns);
      const double rz = 0.5 * (down.of(lateral + j, columns) + out.of(normal + i * columns, 1));
      double pp = rr;  // on the axis
      if (contour == Contour::cylinder) {
        pp = -poisson / (1.0 - poisson) * (rr + zz);
      } else if (distance[j] > 0.0) {
        pp = lateral[i * columns + j] / distance[j];
      }
      const double a = rr - zz, b = zz - pp, c = pp - rr;
      result.von_mises.push_back(modulus * std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * rz * rz));
      result.principal_difference.push_back(modulus * std::hypot(a, 2.0 * rz));
    }
  }
  return result;
}

}  // namespace stoss::bodies::half_space
