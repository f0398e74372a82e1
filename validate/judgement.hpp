#pragma once

#include <map>
#include <optional>
#include <vector>

#include "points.hpp"

namespace validate {

/// What restitution() said of one point.
struct Answer {
  PerQuantity<stoss::Estimate> value{};
  bool converged = false;
  double cutoff = 0.0;  ///< of the finest impact, c/R
};

/// The body of a point that meets a half-space, and the half-space.
struct Makers {
  stoss::BodyMaker first, second;
};
Makers makers_of(const Point& point);

/// What meets at each of the points; disks of one Poisson's ratio at the wall share their modes.
using Contacts = std::vector<stoss::RefinableContact>;
Contacts make_contacts(const std::vector<Point>& points);

/// Error of 1 − ε² that suffices at a point whatever the tolerance.
double least_error(const Point& point);

/// @param tolerance relative to 1 − ε²; of vibrating bodies the error of 1 − ε² itself
std::vector<Answer> answer(const Contacts& contacts, const std::vector<Point>& points, double tolerance);

/// The best that restitution() gives, whether or not it converges.
stoss::Restitution best(const stoss::RefinableContact& body, double speed, const stoss::RestitutionOptions& options);

/// How far an answer is off a reference value.
struct Deviation {
  double ratio = 0.0;             ///< true error over estimated error
  bool strictly_within = false;   ///< |value − reference| ≤ error, whatever the reference's uncertainty
  std::optional<double> padding;  ///< estimated error over true error, where the reference is sharp enough to tell
};

/// Where the reference's uncertainty is above a tenth of the estimated error it is taken off the difference.
Deviation deviation(const stoss::Estimate& answer, const stoss::Estimate& reference);

/// The deviations of one quantity over all points that have a reference for it.
struct Tally {
  int points = 0;
  int within = 0;  ///< the error
  int strictly_within = 0;
  int blurred = 0;      ///< judged with the reference's uncertainty
  double greatest = 0;  ///< ratio
  double padding = 0;   ///< median; infinite where no point can tell
};

/// A value, and what it is judged by.
struct Comparison {
  stoss::Estimate answer, reference;
};
Tally tally(const std::vector<Comparison>& all);
Tally tally(const std::vector<Point>& points, const std::vector<Answer>& answers, Quantity quantity);

/// What is promised of an error: the true one is within it in 95 % of all cases and never beyond three times it, and it
/// is, in the median, no more than ten times as large.
bool honest(const Tally& tally);

double median(std::vector<double> values);

/// The least of the values that the share `share` of all does not exceed.
double quantile(std::vector<double> values, double share);

}  // namespace validate
