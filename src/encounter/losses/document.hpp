#pragma once

#include <string>

#include "encounter/json_values.hpp"
#include "stoss/encounter/encounter.hpp"

/// Materials, and how they relax, in JSON documents.
namespace stoss::json {

/// A material of numbers in SI. @throws InvalidInput for other keys, and for one that is missing
[[nodiscard]] Material material_of_numbers(const std::string& where, const Json& given);
[[nodiscard]] Json document_of(const Material& material);

/// Pairs of shares and times. @throws InvalidInput
[[nodiscard]] Relaxation relaxing_terms(const std::string& where, const Json& given);
[[nodiscard]] Json document_of(const Relaxation& relaxation);

/// Whether the modulus that is given is the relaxed one. @throws InvalidInput for other words
[[nodiscard]] bool is_relaxed(const std::string& where, const Json& given);

}  // namespace stoss::json
