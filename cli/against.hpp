#pragma once

#include <map>
#include <string>

namespace stoss::cli {

/// Hardness of an exponential wall without one.
inline constexpr double default_hardness = 500.0;

/// What --against says: KIND[,key=value…].
struct Against {
  std::string kind = "wall";             ///< wall, same, disk, sphere, rod, half-space, half-plane or exponential
  std::map<std::string, double> values;  ///< of the keys that were given

  /// Of a key, or what holds without it.
  [[nodiscard]] double value(const std::string& key, double otherwise) const;

  /// Whether it is a body, not a wall.
  [[nodiscard]] bool is_body() const { return kind != "wall" && kind != "exponential"; }

  /// Whether it extends to infinity, and has no size.
  [[nodiscard]] bool is_unbounded() const { return kind == "half-space" || kind == "half-plane"; }
};

/// @throws InvalidInput for an unknown kind or key, a key that comes twice, and what is no number
[[nodiscard]] Against parse_against(const std::string& text);

}  // namespace stoss::cli
