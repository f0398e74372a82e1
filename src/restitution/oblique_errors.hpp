#pragma once

#include <string>
#include <vector>

#include "restitution/calibration.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/oblique.hpp"

namespace stoss {

/// What the runs of an oblique impact must resolve, and what their differences mean.
struct ObliquePlan {
  bool mixing = false;       ///< both directions act on each other
  double spacing = 1.0;      ///< error of s′/μv by the spacing of n points, times n²
  double sign_change = 0.0;  ///< by where friction changes its sign, times n^{3/2}
  double normal = 0.0;       ///< error of ε_n by the spacing, times n²
  calibration::ObliqueDifferences from = calibration::on_rings;
  double allowed = 1.0;   ///< error of s′/μv that is wanted
  bool unstable = false;  ///< friction above stable_friction

  /// Whether it asks for more points across the contact than are computed.
  [[nodiscard]] bool too_fine() const;

  /// Cutoff, step and points, refined together. The number of points differs in every run, so that two runs do not err
  /// alike. @param half_width of the contact in a coarser run, or 0
  [[nodiscard]] Resolution resolution(const Contact& contact, double speed, double half_width, int level) const;

  /// Points that s′ needs of the grid at a level.
  [[nodiscard]] double needed(int level) const;

  /// Of the grid at a level. @param cutoff over time_scale @param nyquist points that the waves need
  [[nodiscard]] int points(double cutoff, double nyquist, int level) const;
};

/// Checks what is asked for. @throws InvalidInput for a tolerance out of range
void require_tolerance(const ObliqueOptions& options);

/// Adds a run to a result, and fills what follows from all of them.
void add_run(const ObliquePlan& plan, ObliqueImpact&& impact, ObliqueRestitution& result);

/// A run along the normal alone: NaN of what moves along the surface.
[[nodiscard]] ObliqueRun normal_run(const Impact& impact);

/// Adds those that were not runs of a result anyway.
void add_normal_runs(const std::vector<ObliqueRun>& runs, ObliqueRestitution& result);

/// Whether what is not known of a body that stays (Impact::remaining) is more than the tolerance, in any run.
[[nodiscard]] bool is_out_of_reach(const ObliqueRestitution& result);

/// What no run up to a level resolves of s′, by its points across the contact, over its scale (scale_of). 0 while the
/// width of the contact is not known.
/// @param contact of the finest run; what is said of its waves holds for finer ones in proportion
[[nodiscard]] double left_by_points(const ObliquePlan& plan, const ObliqueRestitution& result, const Contact& contact,
                                    double highest, int level);

/// Of errors of s′: the tolerance is their share of it.
[[nodiscard]] double scale_of(const ObliqueRestitution& result);

/// "(use a larger tolerance, from …)", or that there is none.
[[nodiscard]] std::string way_out(const char* hint, double least);

/// Whether finer runs up to a cutoff will hardly meet the tolerance, if the error falls with the cutoff as expected.
[[nodiscard]] bool is_hopeless(const ObliquePlan& plan, const ObliqueRestitution& result, double highest);

/// Says why a result has not converged; without two impacts there are no values.
void mark_unconverged(const ObliquePlan& plan, ObliqueRestitution& result);

/// What s′ is known to at best is more than the tolerance: its points across the contact are too few in any run.
class OutOfReach : public NotConverged {
 public:
  explicit OutOfReach(double error)
      : NotConverged("the tolerance asks for more points across the contact than are computed"), least(error) {}

  double least;  ///< tolerance
};

/// As oblique_restitution, for a table: where ε_n is that of `restitution` it is that of the ladder of s′, and what is
/// left out (Coupling) is not estimated. @throws OutOfReach before the last run, where it can be seen that none helps
[[nodiscard]] std::vector<ObliqueRestitution> motion_along(const RefinableContact& contact, double speed,
                                                           const std::vector<Obliquity>& obliquities,
                                                           const ObliqueOptions& options);

}  // namespace stoss
