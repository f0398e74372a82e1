#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/normal_course.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/oblique_snapshot.hpp"

namespace stoss {

/// Whether contact points lie on both sides of the axis; else they are rings, or a single one.
[[nodiscard]] bool is_sided(const Contact& contact);

/// The points of a contact with nothing on them, in order of their places.
[[nodiscard]] std::vector<ObliquePoint> points_at_rest(const Contact& contact, const ContactGrid& grid);

/// Sums up the points of an instant, and says what they do. @param unit force in units of which they are
void show_points(std::vector<ObliquePoint>& points, double unit, ObliqueSnapshot& now);

/// What friction does at one node, as ObliquePoint has it.
struct PointFriction {
  double friction = 0.0, slip = 0.0;
  int sliding = 0;  ///< as Friction has it
};

/// Shows an observer an oblique impact in which both directions do not act on each other: the normal motion is that
/// of its course. Without an observer nothing happens.
class ObliqueFilm {
 public:
  /// @throws InvalidInput for an observation out of range
  ObliqueFilm(const NormalCourse& course, const Obliquity& before, const ObliqueObservation& observation);

  [[nodiscard]] bool watched() const { return static_cast<bool>(observation_.observer); }

  /// Goes on to a step without friction. @param since motion at present, with ways since the last flight ended
  void fly(long until, const AlongMotion& since);

  /// Goes on by one step with friction. @returns whether its instant is to be shown
  [[nodiscard]] bool advance();

  /// Shows the instant. @param along with ways since the last flight ended
  void show(const AlongMotion& along, const std::vector<PointFriction>& nodes);

 private:
  void show_flight(const AlongOutcome& along);
  void show_instant(const AlongMotion& along);
  void load(const std::vector<PointFriction>& nodes);
  [[nodiscard]] bool wanted() const;

  const NormalCourse& course_;
  Obliquity before_;
  const ObliqueObservation& observation_;
  long step_ = 0;
  bool begun_ = false;
  double shift_ = 0.0;  // at the end of the last flight
  std::array<double, 2> angle_{};
  std::vector<ObliquePoint> points_;
  std::vector<PointFriction> nodes_;
};

/// The oblique impact without friction, and what is seen of it.
[[nodiscard]] ObliqueImpact smooth_impact(const NormalCourse& course, const Obliquity& before,
                                          const ObliqueObservation& observation);

}  // namespace stoss
