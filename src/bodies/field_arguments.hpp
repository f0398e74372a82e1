#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace stoss {

/// Throws InvalidInput unless all numbers are finite.
void require_finite(std::string_view name, std::span<const double> numbers, std::string_view hint);

/// Throws InvalidInput unless length == wanted.
void require_length(const std::string& name, std::size_t length, std::size_t wanted, const std::string& hint);

}  // namespace stoss
