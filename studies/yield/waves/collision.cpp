#include "collision.hpp"

#include <algorithm>
#include <cmath>

#include "mesh.hpp"

namespace yield_study {
namespace {

class Collision {
 public:
  explicit Collision(const Meeting& meeting)
      : ball_(free_body(sphere(meeting.elements, meeting.side), meeting.poisson, meeting.of_ball)),
        block_(free_body(block(meeting.elements, meeting.side, meeting.size), meeting.poisson, meeting.of_block)),
        last_(meeting.elements),
        speed_(meeting.speed),
        step_(meeting.part * std::min(ball_.stable_step(), block_.stable_step())) {
    ball_.set_off(-speed_);
  }

  Outcome run() {
    constexpr double flight = 4.0;
    while (time_ < flight || time_ < outcome_.time + flight) go();
    finish();
    return outcome_;
  }

 private:
  void go() {
    time_ += step_;
    ball_.push(step_);
    block_.push(step_);
    const double impulse = meet();
    ball_.move(step_);
    block_.move(step_);
    impulse_ += impulse;
    approach_ += step_ * (speed_ - impulse_ / ball_.mass());
    outcome_.deepest = std::max(outcome_.deepest, approach_);
    if (impulse > 0.0) outcome_.time = time_, outcome_.dent = approach_;
    constexpr double window = 0.25;
    if (time_ - window_start_ < window) return;
    outcome_.force = std::max(outcome_.force, (impulse_ - window_impulse_) / (time_ - window_start_) / ball_.mass());
    window_start_ = time_;
    window_impulse_ = impulse_;
  }

  /// Returns the sum of the impulses.
  double meet() {
    double sum = 0.0;
    for (int node = 0; node <= last_; ++node) {
      const double closing = ball_.velocity(node) - block_.velocity(node);
      const double gap = ball_.place(node) - block_.place(node) + step_ * closing;
      if (gap >= 0.0) continue;
      const double impulse = -gap / step_ / (1.0 / ball_.mass(node) + 1.0 / block_.mass(node));
      ball_.hit(node, impulse);
      block_.hit(node, -impulse);
      sum += impulse;
      outcome_.radius = std::max(outcome_.radius, block_.body().mesh().nodes[static_cast<std::size_t>(node)][0]);
    }
    return sum;
  }

  void finish() {
    const double before = 0.5 * ball_.mass() * speed_ * speed_, rebound = ball_.mean_velocity() / speed_;
    const Energies in_ball = ball_.body().energies(), in_block = block_.body().energies();
    outcome_.restitution = rebound;
    outcome_.flow_ball = in_ball.dissipated / before;
    outcome_.flow_block = in_block.dissipated / before;
    outcome_.ball = (ball_.kinetic_energy() + in_ball.stored) / before - rebound * rebound;
    outcome_.block = (block_.kinetic_energy() + in_block.stored) / before;
    outcome_.imbalance =
        rebound * rebound + outcome_.ball + outcome_.block + outcome_.flow_ball + outcome_.flow_block - 1.0;
    outcome_.unknowns = ball_.body().size() + block_.body().size();
    outcome_.step = step_;
  }

  Mover ball_, block_;
  int last_;  ///< node of the surface that may touch
  double speed_, step_;
  double time_ = 0.0, impulse_ = 0.0, approach_ = 0.0;
  double window_start_ = 0.0, window_impulse_ = 0.0;
  Outcome outcome_{};
};

}  // namespace

Outcome collide(const Meeting& meeting) { return Collision(meeting).run(); }

}  // namespace yield_study
