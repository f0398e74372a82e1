#pragma once

#include <cstddef>
#include <vector>

namespace stoss {

/// The free vibration of a rod as waves, u̇(s, t) = w(t − s/c) + w(t + s/c) with w of period 2T: what arrives at one end
/// comes back to it after 2T, and at the other end after T. w is constant in pieces, in the order in which they arrive
/// at the right end. Its mean belongs to the motion of the centre, V = 2 mean(w); the energy is Z ∫ w² dt.
class RodWave {
 public:
  struct Piece {
    double duration;
    double velocity;  ///< w
  };

  /// A rod at rest. @param transit T, @param impedance Z
  RodWave(double transit, double impedance);

  /// Pieces of the period 2T. @throws InvalidInput if their durations do not add up to it
  void set(std::vector<Piece> pieces);

  /// Lets time pass, forward or back; from one end to the other it is T.
  void rotate(double time);

  /// Adds to w.
  void shift(double velocity);

  /// Multiplies w.
  void scale(double factor);

  /// Runs the wave back in time.
  void reverse();

  [[nodiscard]] double mean() const;

  /// Z ∫ w² dt
  [[nodiscard]] double energy() const;

  /// Displacement 2φ of the end at which the pieces arrive, φ̇ = w − mean(w) and the mean of φ zero: now, and its
  /// minimum and maximum over a period.
  struct Swing {
    double now, least, greatest;
  };
  [[nodiscard]] Swing swing() const;

  /// Merges pieces, those first whose merging moves the ends least, until there are `most`. Keeps the mean.
  /// @return the energy lost
  double merge(std::size_t most);

  [[nodiscard]] const Piece& front() const { return pieces_[head_]; }

  /// Takes so much of the first piece as lasts `time`, which is not more than its duration, and sends back `velocity`.
  void reflect(double time, double velocity);

  [[nodiscard]] std::size_t size() const { return pieces_.size() - head_; }
  [[nodiscard]] double transit() const { return transit_; }
  [[nodiscard]] double impedance() const { return impedance_; }

 private:
  void tidy();

  double transit_, impedance_;
  std::vector<Piece> pieces_;
  std::size_t head_ = 0;  // first piece that is still to arrive
};

}  // namespace stoss
