#pragma once

#include <vector>

#include "contact/contact_cache.hpp"
#include "contact/edge/edge_contact.hpp"
#include "contact/residual/residuals.hpp"
#include "contact/response.hpp"

namespace stoss {

/// Where a force that starts like t^p is best caught by kicks: the time of the first kick after its start, in steps,
/// at which the sum of the kicks has no error of order p + 1, the zero of Hurwitz' ζ(−p, x). A jump (p = 0) at a single
/// point, a kink (p = 1) where a line of contact begins to grow, t^{3/2} where a circle does.
[[nodiscard]] double first_kick(const Contact& contact);

/// Compression at which an unexcited body starts so that the first kick after the touch is the best one.
/// @param range  of the edge law (EdgeLaw::range)
/// @param touch  compression at which it begins to push
/// @param stride by which it moves in a step
[[nodiscard]] double start_before(double kick, double range, double touch, double stride);

/// A contact that no point passes, by the edge law, whatever the tail of the modes that are not kept.
class HardContact : public ContactResponse {
 public:
  [[nodiscard]] std::size_t extent() const override { return contact_.extent(); }
  [[nodiscard]] double gap(std::size_t node) const override;
  [[nodiscard]] double half_width() const override { return contact_.half_width(); }
  [[nodiscard]] bool overflows() const override { return contact_.overflows(); }
  [[nodiscard]] std::array<double, 2> relaxing_energy() const override;
  [[nodiscard]] std::vector<double> crept_force(std::size_t body) const override {
    return residuals_.crept_force(body);
  }
  [[nodiscard]] double range() const override { return range_; }
  [[nodiscard]] double touch() const override { return touch_; }
  [[nodiscard]] double contact_threshold() const override { return threshold_; }
  [[nodiscard]] bool is_long_range() const override { return rough_; }

  /// With the touch at the best phase within a step.
  [[nodiscard]] double start(double stride) const override;

 protected:
  HardContact(const Contact& contact, const ContactGrid& grid, ResidualMotion::Inertia inertia, double speed,
              double step, const Poll& poll);

  /// Largest displacement of a node.
  [[nodiscard]] double largest_displacement() const;

  double step_;
  Residuals residuals_;
  EdgeContact contact_;
  bool lossy_, rough_;
  double first_share_;                // of the first body in what the edge law takes
  std::vector<double> position_;      // x_dyn
  std::vector<double> gap_;           // x_dyn − h
  std::vector<double> displacement_;  // u
  std::vector<double> force_, old_force_;
  double edge_work_ = 0.0;  // of lossy bodies: ∫ f (ẋ_dyn − u̇) dt, what the edge law takes

 private:
  HardContact(const Contact& contact, const ContactGrid& grid, const SetUp& made, double speed, double step,
              const Poll& poll);

  double range_, touch_, first_kick_, threshold_;
};

/// Hard wall, quasistatic tail: u = W f, of a lossy material u = J W f (ResidualMotion without masses), and the edge
/// law between f and u − x_dyn.
class QuasistaticTail final : public HardContact {
 public:
  QuasistaticTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] double stored_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double protrusion() const override;

 private:
  std::vector<double> old_displacement_;  // of lossy bodies
};

/// Hard wall, radiating tail: the modes that are not kept have springs, masses and dashpots (ResidualMotion), and in a
/// time step u = W′f + h. The same contact problem as with the quasistatic tail, with W′ for W and x_dyn − h for x_dyn.
class RadiatingTail final : public HardContact {
 public:
  RadiatingTail(const Contact& contact, const ContactGrid& grid, double speed, double step, const Poll& poll);
  const std::vector<double>& advance(const std::vector<double>& position) override;
  [[nodiscard]] double unresolved_energy() const override;
  [[nodiscard]] std::array<double, 2> dissipated_energy() const override;
  [[nodiscard]] double stored_energy() const override;

  /// A released node swings back through its rest position, but never as far as it was displaced.
  [[nodiscard]] double protrusion() const override { return largest_displacement(); }

  [[nodiscard]] RadiatingTail* radiating() override { return this; }

  /// Whether the modes that are not kept have come to rest, but for a displacement that is negligible.
  [[nodiscard]] bool is_still(double negligible) const;

  /// Goes on for some time in which no node comes within its range, from where it is still.
  void rest(double time);

 private:
  [[nodiscard]] double held_by_asperities() const;

  std::vector<double> contact_displacement_;  // W′f
  bool at_rest_ = true;                       // before anything has touched
  // ∫ f u̇ dt = ∫ f ẋ_dyn dt, as f = 0 where the two differ; by the trapezium rule in x_dyn, which is smooth.
  double work_ = 0.0;
};

}  // namespace stoss
