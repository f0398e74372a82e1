#pragma once

#include <cstddef>
#include <vector>

#include "contact/response.hpp"
#include "impact/normal_motion.hpp"
#include "stoss/impact/impact.hpp"

namespace stoss {

/// What the nodes of a contact feel along the normal, step by step from the first force on: the limit of their friction
/// and the share that the edge law has in their motion along the surface.
class Pressures {
 public:
  /// Starts at this compression.
  void begin(double compression) { start_ = compression; }

  /// Adds a step, at first the instant before all steps. @param force of each node @param center at that instant
  void add(const std::vector<double>& force, const ContactResponse& response, const NormalMotion& center);

  /// Forgets what follows the first step after the last force, which has the second half of its kick.
  void end_with_contact();

  [[nodiscard]] std::size_t steps() const { return extent_.size(); }

  /// Compression at the start.
  [[nodiscard]] double start() const { return start_; }

  /// Number of the first step with a force: 0 for the instant before all steps.
  [[nodiscard]] long first() const { return first_; }

  /// Of all nodes in a step.
  [[nodiscard]] const double* force(std::size_t step) const { return &force_[step * nodes_]; }

  /// Number of leading nodes beyond which the forces of a step vanish.
  [[nodiscard]] std::size_t extent(std::size_t step) const { return extent_[step]; }

  /// Of the motion along the normal in a step.
  [[nodiscard]] double compression(std::size_t step) const { return compression_[step]; }
  [[nodiscard]] double velocity(std::size_t step) const { return velocity_[step]; }

  /// D of all nodes in a step, where both directions are equally soft (edge_compliance_along).
  [[nodiscard]] const double* give(std::size_t step) const { return &give_[step * nodes_]; }

 private:
  std::size_t nodes_ = 0;
  std::size_t last_ = 0;  // steps up to the last force
  double start_ = 0.0;
  long first_ = 0;
  std::vector<double> force_, give_;
  std::vector<double> compression_, velocity_;
  std::vector<std::size_t> extent_;
  std::vector<double> force_before_, gap_before_;  // of each node in the step before
};

/// As the public one. @param pressures receives what the nodes feel; null: nothing does
[[nodiscard]] Impact impact(const Contact& contact, double speed, const ImpactOptions& options,
                            const Observation& observation, Pressures* pressures);

}  // namespace stoss
