#include "restitution/best_restitution.hpp"

#include <limits>
#include <string>

namespace stoss {
namespace {

/// A point at which no two impacts ended.
Restitution failed(double speed, const RestitutionOptions& options, const std::string& reason) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr Estimate nothing{none, none};
  Restitution result{.restitution = nothing,
                     .lost_fraction = nothing,
                     .contact_time = nothing,
                     .impulse_time = nothing,
                     .max_force = nothing,
                     .max_compression = nothing,
                     .lost_to_first = none,
                     .lost_to_second = none,
                     .dissipated = none,
                     .tolerance = options.tolerance,
                     .absolute = options.absolute,
                     .converged = false,
                     .reason = reason,
                     .runs = {},
                     .finest = {},
                     .steps = 0};
  result.finest.speed = speed;
  result.finest.restitution = result.finest.lost_fraction = none;
  return result;
}

}  // namespace

Restitution best_restitution(const RefinableContact& contact, double speed, const RestitutionOptions& options) {
  try {
    return restitution(contact, speed, options);
  } catch (const RestitutionNotConverged& error) {
    return error.best;
  } catch (const NotConverged& error) {
    return failed(speed, options, error.what());
  }
}

}  // namespace stoss
