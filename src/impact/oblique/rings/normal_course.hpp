#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "impact/oblique/frame.hpp"
#include "impact/pressures.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/oblique_snapshot.hpp"

namespace stoss {

/// A normal impact with its pressures, from which it can be seen again.
struct NormalCourse {
  NormalCourse(const Contact& contact, double speed, const ImpactOptions& options);

  Impact impact;
  Pressures pressures;
  ObliqueFrame frame;
  double mass;    ///< of what is there
  double extent;  ///< distance of the centres at first touch
  double unit;    ///< of force, mc²/R of the first
  ContactPoints nodes;
  std::array<std::vector<double>, 2> arm;  ///< of friction at each node about the centre of each body that turns
  std::vector<ObliquePoint> points;        ///< at rest
};

/// It again, as Collision moves it, step by step.
class NormalReplay {
 public:
  explicit NormalReplay(const NormalCourse& course);

  /// Moves on by one step.
  void advance();

  [[nodiscard]] long step() const { return step_; }
  [[nodiscard]] double time() const { return static_cast<double>(step_) * course_.impact.resolution.step; }

  /// Of whole bodies (WholeBodies): velocity along the normal, and place as Snapshot::center.
  [[nodiscard]] double velocity() const;
  [[nodiscard]] double center() const;

  /// Pressure of a node times its area.
  [[nodiscard]] double force(std::size_t node) const { return force_ == nullptr ? 0.0 : force_[node]; }

 private:
  void load();

  const NormalCourse& course_;
  double part_;  // κ
  long step_ = 0;
  double compression_, velocity_;  // before the kick that is due
  const double* force_ = nullptr;  // of the nodes; null: none
  double total_ = 0.0;
};

}  // namespace stoss
