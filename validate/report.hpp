#pragma once

#include <iosfwd>

namespace validate {

/// Runs restitution() over all points, writes docs/developer/validation.md, and says whether the errors are honest.
/// @throws std::runtime_error if a reference file cannot be read
bool write_report(std::ostream& out);

}  // namespace validate
