#pragma once

#include <iosfwd>

namespace validate {

/// Writes for each constant of the error bars (src/restitution/calibration.hpp) what the references ask of it: in every
/// run on the way to a value, where its term is the greatest, the constant with which that would be the true error.
/// @returns whether none in use is less than half of the 95 % quantile of these
bool write_calibration(std::ostream& out);

}  // namespace validate
