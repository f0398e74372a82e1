#pragma once

#include "yield/body.hpp"

namespace yield_study {

/// A body of density 1 in motion, by central differences with lumped masses.
class Mover {
 public:
  explicit Mover(Body body);

  /// Below the largest stable time step, by Gershgorin's circles of the elastic body.
  [[nodiscard]] double stable_step();
  /// All nodes get this velocity along the axis.
  void set_off(double velocity);
  /// Inner forces act for a step.
  void push(double step);
  /// The nodes move for a step.
  void move(double step) { at_ += step * speed_; }

  /// A node on the axis' side of the surface: what it weighs, where it is along the axis, and an impulse on it.
  [[nodiscard]] double mass(int node) const { return body_.volumes()[along(node)]; }
  [[nodiscard]] double place(int node) const;
  [[nodiscard]] double velocity(int node) const { return speed_[along(node)]; }
  void hit(int node, double impulse) { speed_[along(node)] += impulse / mass(node); }

  [[nodiscard]] double mass() const { return mass_; }
  [[nodiscard]] double mean_velocity() const;
  [[nodiscard]] double kinetic_energy() const;
  [[nodiscard]] const Body& body() const { return body_; }

 private:
  [[nodiscard]] int along(int node) const { return body_.freedom(node, 1).unknown; }
  [[nodiscard]] int nodes() const { return static_cast<int>(body_.mesh().nodes.size()); }

  Body body_;
  Eigen::VectorXd at_, speed_;
  double mass_ = 0.0;
};

}  // namespace yield_study
