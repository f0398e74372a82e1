#pragma once

#include <string>

#include "encounter/json_values.hpp"
#include "stoss/impact/vibration.hpp"

/// Modes that vibrate before an impact, in JSON documents.
namespace stoss::json {

/// @throws InvalidInput for what is no list of modes
[[nodiscard]] Vibration vibration(const std::string& where, const Json& given);
[[nodiscard]] Json document_of(const Vibration& vibration);

}  // namespace stoss::json
