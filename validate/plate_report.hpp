#pragma once

#include <iosfwd>
#include <vector>

#include "judgement.hpp"
#include "plate_points.hpp"

namespace validate {

/// What restitution() said of an impact on a plate, by default.
struct PlateAnswer {
  Answer its;
  double first_seconds = 0.0;  ///< processor time with the modes made
  double seconds = 0.0;        ///< and once they are there
};

/// Points, and what restitution() said of them.
struct JudgedPlates {
  std::vector<PlatePoint> points, unseen, elements;
  std::vector<PlateAnswer> answers, at_unseen, at_elements;
};
JudgedPlates judge_plates();

/// The processor times of the points, by speed.
void write_plate_times(std::ostream& out, const JudgedPlates& judged);

/// @return whether the errors are what is promised
bool write_plates(std::ostream& out, const JudgedPlates& judged);

}  // namespace validate
