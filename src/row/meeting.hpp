#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "contact/response.hpp"
#include "row/solid.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/resolution.hpp"

namespace stoss {

/// One contact of a row: what two neighbours, or an end and its wall, do to each other. Its contact, grid and response
/// are those of the same two bodies as a pair, in units of the first of them.
class Meeting {
 public:
  /// @param speed with which they may meet at most, c of the first of them @param step, poll as make_response
  Meeting(const Contact& contact, const FixedResolution& resolution, double speed, const Poll& poll);

  /// Points as the first (0) and the second body see them.
  [[nodiscard]] ContactPoints points(int number) const;

  /// Begins at a distance, R of the first of them: from first touch or, of rough faces, from where they begin to push.
  void begin(double gap);

  /// Finds the forces where the bodies are, and gives them to both. @param other null at a wall
  void respond(RowSolid& one, Face face, RowSolid* other);

  /// Whether no force acts, and what still moves in the contact is a small share of its greatest compression: the
  /// modes above the cutoff, some of which would ring on for long in the steps of the motion.
  [[nodiscard]] bool is_still() const;

  /// Steps for which the bodies stay apart as they fly. @param step R/c of the first of them
  [[nodiscard]] long steps_apart(const RowSolid& one, Face face, const RowSolid* other, double step) const;

  /// Goes on for some time, R/c of the first of them, in which they do.
  void rest(double time);

  /// Notes the step, with the force at its end.
  void record(double time, double step);

  /// Whether the bodies cannot touch while they fly on as they do, each in the vibration that it has.
  [[nodiscard]] bool is_clear(const RowSolid& one, Face face, const RowSolid* other) const;

  [[nodiscard]] bool overflows() const { return !has_single_point(contact_) && response_->overflows(); }
  [[nodiscard]] bool pushes() const { return force_ > response_->contact_threshold(); }
  [[nodiscard]] double force() const { return force_; }  ///< in units of the first of them
  [[nodiscard]] double compression() const { return compression_ - response_->touch(); }
  [[nodiscard]] double first_kick() const { return first_kick_; }

  /// 0.2 a/R of the widest contact so far, the mean strain there (Impact::strain); 0 between flat ends.
  [[nodiscard]] double strain() const;

  /// What it holds, and what the modes above the cutoff and materials have taken, in units of the first of them.
  [[nodiscard]] double stored() const { return response_->stored_energy(); }
  [[nodiscard]] double unresolved() const { return response_->unresolved_energy(); }
  [[nodiscard]] double dissipated() const;
  [[nodiscard]] double yielded() const;

  double first_touch = -1.0, last_touch = -1.0;  ///< −1: none
  double greatest_force = 0.0, impulse = 0.0, greatest_compression = 0.0, greatest_width = 0.0;
  int touches = 0;

 private:
  [[nodiscard]] double closing(const RowSolid& one, Face face, const RowSolid* other) const;
  [[nodiscard]] double approach(const RowSolid& one, Face face, const RowSolid* other) const;

  const Contact& contact_;
  ContactGrid grid_;
  UnitRatios of_second_;
  std::unique_ptr<ContactResponse> response_;
  std::vector<double> position_, on_second_;
  double start_ = 0.0, compression_ = 0.0, force_ = 0.0, before_ = 0.0, first_kick_;
  bool pushed_ = false;
};

}  // namespace stoss
