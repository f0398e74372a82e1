#pragma once

#include <emscripten/val.h>

#include <memory>
#include <vector>

#include "encounter.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/inside.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::web {

/// One impact in time, as `stoss impact --cutoff` computes it.
class Collision {
 public:
  /// @param cutoff of a converged ε, c/R of the first body
  /// @throws InvalidInput as impact; NotConverged where the impact does not end
  Collision(std::shared_ptr<const Meeting> meeting, double speed, double cutoff);

  /// Collision of the protocol.
  [[nodiscard]] emscripten::val series() const;

  /// Calls deliver(Frame, index) for each of the times, which ascend. @param below points of a half-space
  void frames(const std::vector<double>& times, const bodies::PolarGrid& points,
              const bodies::half_space::PlaneGrid& below, const emscripten::val& deliver);

 private:
  [[nodiscard]] emscripten::val bodies() const;

  std::shared_ptr<const Meeting> meeting_;
  Contact contact_;
  Impact impact_;
  std::vector<Snapshot> snapshots_;
  ContactGrid grid_;
  bodies::PolarGrid points_;     ///< of the last frames
  std::vector<Inside> insides_;  ///< of what meets, at these points
};

}  // namespace stoss::web
