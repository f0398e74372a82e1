#pragma once

#include <string>

#include "stoss/cxx20.hpp"

namespace stoss {

/// The JSON Schema (draft 2020-12) of the documents of encounters (document.hpp), made of the table of kinds: their
/// parameters with ranges, units and help, and the named materials. Its `$id` ends in the version of the format.
[[nodiscard]] std::string encounter_schema();

}  // namespace stoss
