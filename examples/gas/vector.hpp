#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace gas {

template <std::size_t D>
using Vector = std::array<double, D>;

/// Angular velocity: about the normal of the plane, or a vector in space.
template <std::size_t D>
using Spin = std::array<double, D == 2 ? 1 : 3>;

template <std::size_t N>
[[nodiscard]] double dot(const std::array<double, N>& a, const std::array<double, N>& b) {
  double sum = a[0] * b[0];
  for (std::size_t k = 1; k < N; ++k) sum += a[k] * b[k];
  return sum;
}

template <std::size_t N>
[[nodiscard]] double length(const std::array<double, N>& a) {
  if constexpr (N == 2) return std::hypot(a[0], a[1]);
  return std::sqrt(dot(a, a));
}

/// Adds a multiple of b to a.
template <std::size_t N>
void add(std::array<double, N>& a, double factor, const std::array<double, N>& b) {
  for (std::size_t k = 0; k < N; ++k) a[k] += factor * b[k];
}

[[nodiscard]] inline Vector<3> cross(const Vector<3>& a, const Vector<3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Velocity of a place by rotation: spin × place.
[[nodiscard]] inline Vector<2> turned(const Spin<2>& spin, const Vector<2>& place) {
  return {-spin[0] * place[1], spin[0] * place[0]};
}
[[nodiscard]] inline Vector<3> turned(const Spin<3>& spin, const Vector<3>& place) { return cross(spin, place); }

/// Moment of a force at a place: place × force.
[[nodiscard]] inline Spin<2> moment(const Vector<2>& place, const Vector<2>& force) {
  return {place[0] * force[1] - place[1] * force[0]};
}
[[nodiscard]] inline Spin<3> moment(const Vector<3>& place, const Vector<3>& force) { return cross(place, force); }

}  // namespace gas
