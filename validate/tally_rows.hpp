#pragma once

#include <iosfwd>
#include <string>

#include "judgement.hpp"

namespace validate {

/// A cell of a table in Markdown, after the bar at its left. @param format of printf
std::string cell(const char* format, double value);

/// The row of a tally: bodies, quantity, points, within, strictly, maximum, median of error over true error, blurred.
void write_tally(std::ostream& out, const char* bodies, const char* quantity, const Tally& all);

/// The end of a point's row: 1 − ε² of the reference and of the answer, and the cutoff. @param format of both
void write_answer(std::ostream& out, const Point& point, const Answer& answer, const char* format = "%.8f");

}  // namespace validate
