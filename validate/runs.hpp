#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/impact/vibration.hpp"

namespace validate {

/// How finely a reference impact is resolved.
struct Fineness {
  double cutoff;
  double step;   ///< times the cutoff
  double nodes;  ///< over those of restitution() at this cutoff
};

using Finenesses = std::array<Fineness, 3>;

/// One impact to be computed.
struct ReferencePoint {
  std::string place;  ///< its first columns in the file
  double speed;
  std::function<stoss::Contact(double cutoff)> contact;
  stoss::Vibration vibration{};  ///< of modes that the lowest cutoff keeps
};

/// Computes each point at each fineness and writes a CSV file of the header and a row for each: its place, then
/// `,value,uncertainty` of each quantity: the value of the last run, and the spread of all (of the contact time at
/// least the last run's step).
/// @throws std::runtime_error if the file cannot be written
void write_reference(const std::string& path, const std::string& header, const std::vector<ReferencePoint>& points,
                     const Finenesses& finenesses);

/// The runs at one point.
using ImpactRuns = std::array<stoss::Impact, 3>;

/// Those of restitution() refined.
ImpactRuns resolved_runs(const ReferencePoint& point, const Finenesses& finenesses);

/// The same of runs made otherwise. Points where they do not end are said, and left out.
/// @throws std::runtime_error as above
void write_reference(const std::string& path, const std::string& header, const std::vector<std::string>& places,
                     const std::function<ImpactRuns(std::size_t)>& compute);

/// Resolution of a reference impact. @param half_width maximum of the contact in a coarser run
stoss::Resolution finer(const stoss::Contact& contact, double speed, const Fineness& fineness, double half_width);

/// Rounded to what the file holds: that is what is computed. @param format of printf
double rounded(const char* format, double value);

/// The names of the columns of the quantities.
inline const std::string quantity_columns =
    "lost_fraction,uncertainty,contact_time,contact_time_uncertainty,impulse_time,impulse_time_uncertainty,"
    "max_force,max_force_uncertainty,max_compression,max_compression_uncertainty";

}  // namespace validate
