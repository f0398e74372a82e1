#pragma once

#include <string>

namespace validate {

/// Computes the reference values and writes them to a CSV file. Takes minutes.
/// @throws std::runtime_error if the file cannot be written
void make_reference(const std::string& path);

}  // namespace validate
