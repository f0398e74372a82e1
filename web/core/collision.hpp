#pragma once

#include <emscripten/val.h>

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "block.hpp"
#include "encounter.hpp"
#include "inside.hpp"
#include "stoss/contact/grid.hpp"
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
  void frames(const std::vector<double>& times, const Points& points, const bodies::half_space::PlaneGrid& below,
              const emscripten::val& deliver);

 private:
  [[nodiscard]] emscripten::val body_frame(const Frame& frame, int number);
  [[nodiscard]] emscripten::val block_frame(const Frame& frame, const bodies::half_space::PlaneGrid& below);
  [[nodiscard]] emscripten::val bodies() const;

  std::shared_ptr<const Meeting> meeting_;
  Contact contact_;
  Impact impact_;
  std::vector<Snapshot> snapshots_;
  ContactGrid grid_;
  Points points_;                  ///< of the last frames
  std::map<int, Inside> insides_;  ///< of the bodies, at these points
  std::optional<Block> block_;     ///< a half-space, at its points
};

}  // namespace stoss::web
