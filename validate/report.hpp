#pragma once

#include <iosfwd>

#include "sets.hpp"

namespace validate {

/// Runs restitution() over all points, writes docs/developer/validation.md, and says whether the errors are honest.
/// @throws std::runtime_error if a reference file cannot be read
bool write_report(std::ostream& out);

/// The same of the impacts of one set alone: verdicts, quantities, and points.
bool write_set(std::ostream& out, const Set& set);

}  // namespace validate
