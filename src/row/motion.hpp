#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "row/meeting.hpp"
#include "row/solid.hpp"
#include "stoss/row/row.hpp"

namespace stoss {

/// Bodies and contacts of a row at a cutoff, which its motions share.
struct MadeRow {
  struct Joint {
    std::shared_ptr<const Contact> contact;  ///< that of all joints of the same bodies
    int one, other;                          ///< bodies; −1: a wall
    Face face;                               ///< of `one`
    double gap;                              ///< R of `one`
    FixedResolution resolution;
    double speed;     ///< with which they may meet at most, c of `one`
    double duration;  ///< that a contact then has, R/c of `one`
  };

  std::vector<std::shared_ptr<const Body>> bodies;
  std::vector<UnitRatios> units;                           ///< of each in those of the first
  std::vector<Joint> joints;                               ///< from left to right
  double step = 0.0;                                       ///< R/c of the first body
  double fastest = 0.0;                                    ///< greatest difference of speeds
  double known = std::numeric_limits<double>::infinity();  ///< until when what stands at an end is as it is computed
  Vibration vibration{};

  /// Units of a joint in those of the first body.
  [[nodiscard]] const UnitRatios& units_of(const Joint& joint) const {
    return units[static_cast<std::size_t>(joint.one)];
  }
};

[[nodiscard]] inline double energy_unit(const UnitRatios& units) { return units.force * units.length; }

[[nodiscard]] double total(const RowEnergy& its);

/// @throws InvalidInput for a tolerance out of range
void require_tolerance(const RowOptions& options);

/// Sets up a row. @param longer than usual, by which factor, what stands at an end is made for
/// @throws InvalidInput as row_impact
[[nodiscard]] MadeRow made_row(const Row& row, const std::vector<double>& speeds, double cutoff, const Poll& poll,
                               double longer = 1.0);

/// The bodies of a row in time: kicks by the forces of all contacts, drifts and free vibrations in between.
///
/// A contact sleeps while its bodies fly freely and cannot touch (steps_apart), and a body while all its contacts do:
/// it is moved at once when one of them wakes, at the end of that time or as its body is pushed elsewhere.
class RowMotion {
 public:
  /// @param start null: as the row has it
  RowMotion(const MadeRow& row, const std::vector<double>& speeds, const RowState* start, const Poll& poll);

  /// Goes on by a step, or if all sleep until one wakes. @param until where that ends
  void advance(double until);

  /// Whether all sleep, and whether for good.
  [[nodiscard]] bool sleeps() const;
  [[nodiscard]] bool is_over() const;

  /// Moves all that sleep to where they are now.
  void catch_up();

  [[nodiscard]] double time() const { return begin_ + static_cast<double>(now_) * row_.step; }
  [[nodiscard]] long steps() const { return steps_; }  ///< that were computed

  /// Until when what stands at an end is as it is computed, from its first touch on.
  [[nodiscard]] double known() const;

  /// By what the velocity of each body may still change: where bodies may meet, that of any of those that may meet in
  /// turn is known to their greatest difference, and to what their contacts hold.
  [[nodiscard]] std::vector<double> open() const;

  /// The first joint whose contact has outgrown its grid; −1: none.
  [[nodiscard]] int overflowing() const;

  [[nodiscard]] RowEnergy energy() const;
  [[nodiscard]] RowImpact result() const;
  void observe(const RowWatch& watch);

 private:
  void vibrate(const RowState* start);
  void place(const std::vector<double>& speeds);
  void respond();
  void wake(std::size_t joint);
  void wake_pushed();
  void fall_asleep(std::size_t joint);
  void rest(std::size_t joint);
  [[nodiscard]] bool is_awake(std::size_t body) const { return awake_joints_[body] > 0; }
  [[nodiscard]] RowEnergy in_units() const;
  [[nodiscard]] double left_at(std::size_t k) const;  // by what a contact may still change the velocity of a body
  [[nodiscard]] RowSolid* body(int number) { return number < 0 ? nullptr : &solids_[static_cast<std::size_t>(number)]; }
  [[nodiscard]] const RowSolid* body(int number) const {
    return number < 0 ? nullptr : &solids_[static_cast<std::size_t>(number)];
  }
  [[nodiscard]] double momentum() const;

  const MadeRow& row_;
  std::vector<Meeting> meetings_;
  std::vector<RowSolid> solids_;
  struct Sleep {
    long until = 0;  // 0: it is awake
    long since = 0;
    long next_look = 0;
    bool was_still = false;
  };
  std::vector<Sleep> sleep_;       // of each contact
  std::vector<int> awake_joints_;  // of each body
  std::vector<long> known_at_;     // where a body that sleeps is
  double begin_ = 0.0;
  long now_ = 0;
  double translation_ = 0.0, whole_ = 0.0, momentum_ = 0.0;  // at first
  long steps_ = 0;
  std::vector<double> displacement_, velocity_, force_;
};

}  // namespace stoss
