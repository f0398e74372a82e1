#pragma once

#include <iosfwd>

namespace validate {

/// Judges the errors of bodies by their modes at a point, at the default tolerance, and writes it.
/// @return whether they are what is promised
bool write_modal(std::ostream& out);

}  // namespace validate
