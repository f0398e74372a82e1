#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/fields.hpp"

namespace stoss::cli {

/// The range of a number, in units of the first body, and what a refusal says of it.
struct Allowed {
  double least, greatest;
  std::string hint;
};

/// A series of lengths or speeds as typed, in units of the first body or, with a material, in SI; the result is in
/// units of the body. @throws InvalidInput unless all are in the range
[[nodiscard]] std::vector<double> parse_series_in(const std::string& name, const std::string& text, Dimension dimension,
                                                  const Units& units, const Allowed& allowed);

/// Speeds of approach, in c. @throws InvalidInput
[[nodiscard]] std::vector<double> parse_speeds(const std::string& text, const Units& units);

/// The same of one speed. @param note why only one
[[nodiscard]] double parse_speed(const std::string& text, const Units& units, const std::string& note = {});

}  // namespace stoss::cli
