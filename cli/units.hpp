#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "stoss/quantity.hpp"

namespace stoss::cli {

/// Kind of the first body, and of the second if there is one.
enum class BodyKind { disk, sphere, rod };

/// As --body and --against have it.
[[nodiscard]] std::string_view name(BodyKind kind);

/// @param text one of these names
[[nodiscard]] BodyKind body_kind(std::string_view text);

/// The units of results: those of the first body and, with a material, SI.
struct Units {
  std::optional<Scales> si{};
  BodyKind body = BodyKind::disk;  ///< the first

  /// Name of a unit of the first body, as in R/c; "" for a pure number.
  [[nodiscard]] std::string own_name(Dimension dimension) const;

  /// Name of the SI unit, as in s.
  [[nodiscard]] std::string si_name(Dimension dimension) const;

  /// SI value of the unit of the first body; there must be a material.
  [[nodiscard]] double scale(Dimension dimension) const;
};

}  // namespace stoss::cli
