#pragma once

#include <iosfwd>
#include <vector>

#include "oblique_points.hpp"

namespace validate {

/// What oblique_restitution() said of one point at one tolerance.
struct ObliqueAnswer {
  stoss::Estimate restitution, sliding_after;
  bool converged = false;
  double cutoff = 0.0;   ///< of the finest impact, over the time scale of the contact
  double seconds = 0.0;  ///< processor time, with modes cached
};

/// The oblique impacts and what was said of them at each tolerance.
struct JudgedOblique {
  std::vector<ObliquePoint> points;
  std::vector<double> tolerances;
  std::vector<std::vector<ObliqueAnswer>> answers;  ///< of each tolerance, in the order of the points
};
JudgedOblique judge_oblique();

/// Writes how long they took.
void write_oblique_times(std::ostream& out, const JudgedOblique& judged);

/// Writes the other tables. @return whether the errors are honest
bool write_oblique(std::ostream& out, const JudgedOblique& judged);

}  // namespace validate
