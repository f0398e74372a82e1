#pragma once

#include <iosfwd>

namespace validate {

/// Runs restitution() over all points, writes docs/developer/validation.md, and says whether the errors are honest.
/// @throws std::runtime_error if a reference file cannot be read
bool write_report(std::ostream& out);

/// The same of bodies that relax alone, at every tolerance.
bool write_relaxing(std::ostream& out);

}  // namespace validate
