#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "check.hpp"
#include "stoss/bodies/round.hpp"
#include "stoss/body/body.hpp"

namespace stoss {

/// Throws InvalidInput unless all numbers are finite.
void require_finite(std::string_view name, std::span<const double> numbers, std::string_view hint);

/// Throws InvalidInput unless length == wanted.
void require_length(const std::string& name, std::size_t length, std::size_t wanted, const std::string& hint);

/// Throws InvalidInput for points outside a round body. @param kind "disk" or "sphere"
void require_points(const bodies::PolarGrid& points, const std::string& kind);

/// Throws InvalidInput for contact points that no impact has. @param radius allowed for their circle
void require_nodes(const ContactPoints& contact, const Range& radius, const std::string& hint);

}  // namespace stoss
