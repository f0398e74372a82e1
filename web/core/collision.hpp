#pragma once

#include <emscripten/val.h>

#include <map>
#include <memory>
#include <vector>

#include "encounter.hpp"
#include "inside.hpp"
#include "stoss/impact/replay.hpp"

namespace stoss::web {

/// One impact in time, as `stoss impact --cutoff` computes it.
class Collision {
 public:
  /// @param cutoff of a converged ε, c/R of the first body
  /// @throws InvalidInput as impact; NotConverged where the impact does not end
  Collision(const Encounter& encounter, double speed, double cutoff);

  /// Collision of the protocol.
  [[nodiscard]] emscripten::val series() const;

  /// Calls deliver(Frame, index) for each of the times, which ascend.
  void frames(const std::vector<double>& times, const Points& points, const emscripten::val& deliver);

 private:
  [[nodiscard]] emscripten::val body_frame(const Frame& frame, int number);
  [[nodiscard]] emscripten::val surface(const Frame& frame);
  [[nodiscard]] emscripten::val bodies() const;

  Encounter encounter_;
  Contact contact_;
  Impact impact_;
  std::vector<Snapshot> snapshots_;
  ContactGrid grid_;
  std::vector<double> compliance_;  ///< of a half-space, of its modes that are not kept
  Points points_;                   ///< of the last frames
  std::map<int, Inside> insides_;   ///< of the bodies, at these points
};

}  // namespace stoss::web
