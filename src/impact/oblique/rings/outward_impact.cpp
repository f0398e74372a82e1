#include "impact/oblique/rings/outward_impact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "contact/demands.hpp"
#include "contact/edge/edge_law.hpp"
#include "contact/friction.hpp"
#include "contact/hard_contact.hpp"
#include "contact/sided/sided_contact.hpp"
#include "contact/touch.hpp"
#include "impact/ending.hpp"
#include "impact/oblique/parity_block.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

SidedCompliance of_rings(const std::vector<double>& compliance, std::size_t points) {
  const auto n = static_cast<Index>(points);
  const Eigen::Map<const Eigen::MatrixXd> both(compliance.data(), 2 * n, 2 * n);  // symmetric: rows are columns
  return {both.topLeftCorner(n, n), both.topRightCorner(n, n), both.bottomRightCorner(n, n)};
}

/// The motion of balls that press and rub each other on rings, by kick–rotate–kick as ObliqueCollision.
class OutwardCollision {
 public:
  OutwardCollision(const Contact& contact, const Contact& outward, double speed, double friction,
                   const FixedResolution& resolution, const ContactGrid& grid, const Poll& poll)
      : contact_(contact),
        speed_(speed),
        step_(resolution.step),
        rings_(static_cast<Index>(grid.points.count)),
        block_(outward, grid.points, resolution, poll),
        law_(edge_law(contact, grid, speed)),
        nodes_(of_rings(block_.residuals.compliance(poll), grid.points.count), law_, friction, 1.0, poll),
        recess_(VectorXd::Map(grid.recess.data(), rings_)),
        range_(law_.range(grid.recess)),
        compression_(start_before(first_kick(contact), range_, touch_compression(contact, grid), speed * step_)),
        velocity_(speed),
        lossy_(longest_loss_time(contact) > 0.0),
        place_(VectorXd::Zero(rings_)),
        moved_x_(place_),
        moved_y_(place_),
        force_(place_),
        rub_(place_),
        gap_(recess_.array() - compression_) {
    impact_.resolution = resolution;
    x_ = compression_ - recess_.array();
  }

  void advance() {
    ++moved_;
    velocity_ -= total_ * step_ / contact_.mass;
    compression_ += velocity_ * step_;
    block_.modes.advance();
    const std::vector<double>& kept = block_.place();
    const VectorXd x = compression_ - recess_.array() + VectorXd::Map(kept.data(), rings_).array();
    const VectorXd y = VectorXd::Map(kept.data() + rings_, rings_);
    nodes_.follow(x_(0), x(0), step_);
    const std::vector<double>& rest = block_.residuals.predict();
    const VectorXd rest_x = VectorXd::Map(rest.data(), rings_), rest_y = VectorXd::Map(rest.data() + rings_, rings_);
    nodes_.solve(x - rest_x, y - rest_y - place_);
    const VectorXd moved_x = rest_x + nodes_.moved_x(), moved_y = rest_y + nodes_.moved_y(), place = y - moved_y;
    const VectorXd force = 0.5 * (force_ + nodes_.force()), rub = 0.5 * (rub_ + nodes_.friction());
    work_ += force.dot(x - x_) + rub.dot(moved_y - moved_y_);
    edge_work_ += force.dot((x - x_) - (moved_x - moved_x_));
    heat_ += rub.dot(place - place_);
    record(place - place_);
    x_ = x, moved_x_ = moved_x, moved_y_ = moved_y, place_ = place;
    force_ = nodes_.force(), rub_ = nodes_.friction(), gap_ = nodes_.gap();
    total_ = force_.sum();
    impact_.max_force = std::max(impact_.max_force, total_ / contact_.first->mass);
    load();
  }

  [[nodiscard]] bool overflows() const { return nodes_.extent() == static_cast<std::size_t>(rings_); }

  [[nodiscard]] bool over() const {
    if (!parts()) return false;
    const double reach = block_.modes.reach(0, static_cast<std::size_t>(rings_));
    return compression_ + reach + moved_x_.cwiseAbs().maxCoeff() < -range_;
  }

  /// The motion along the normal at present.
  [[nodiscard]] Slowing slowing() const {
    return {static_cast<double>(moved_) * step_, synchronous(), 1.0, total_ > 0.0};
  }

  /// Whether the bodies part at present.
  [[nodiscard]] bool parts() const { return total_ <= 0.0 && velocity_ < 0.0; }

  [[nodiscard]] double flight() const { return std::max(0.0, -compression_) + 4.0 * std::max(range_, 0.0); }

  /// @param rest of a ball that may stay
  [[nodiscard]] OutwardImpact result(const Rest& rest) {
    const double energy = 0.5 * contact_.mass * speed_ * speed_, velocity = synchronous();
    impact_.steps.resize(std::min(steps_with_force_ + 1, impact_.steps.size()));  // with the rest of the last kick
    impact_.restitution = rest.stays() ? 0.0 : -velocity / speed_;
    impact_.momentum = rest.stays() ? contact_.mass * velocity : 0.0;
    impact_.friction_loss = heat_ / energy;
    impact_.vibration = (block_.vibration(0) + block_.vibration(1)) / energy;
    if (rest.stays()) impact_.vibration += velocity * velocity / (speed_ * speed_);
    impact_.stored = block_.residuals.stored() / energy;
    const double lost = block_.residuals.dissipated()[0] + block_.residuals.dissipated()[1];
    const double edge = lossy_ ? edge_work_ : 0.0;
    impact_.dissipated = (block_.dissipated(0) + block_.dissipated(1) + edge) / energy;
    impact_.unresolved = (work_ - lost - edge) / energy - impact_.stored;
    impact_.energy_error = 1.0 - impact_.restitution * impact_.restitution - impact_.friction_loss - impact_.vibration -
                           impact_.stored - impact_.dissipated - impact_.unresolved;
    return std::move(impact_);
  }

 private:
  [[nodiscard]] double synchronous() const { return velocity_ - 0.5 * total_ * step_ / contact_.mass; }

  /// Makes the forces those of the kick that is due.
  void load() {
    VectorXd::Map(block_.force.data(), rings_) = force_;
    VectorXd::Map(block_.force.data() + rings_, rings_) = rub_;
    VectorXd::Map(block_.displacement.data(), rings_) = moved_x_;
    VectorXd::Map(block_.displacement.data() + rings_, rings_) = moved_y_;
    block_.residuals.move(block_.displacement, block_.force, block_.force.size());
    block_.load();
  }

  void record(const VectorXd& slip) {
    const bool pushes = nodes_.extent() > 0;
    if (!pushes && impact_.steps.empty()) return;
    OutwardStep now{nodes_.force(), nodes_.friction(), slip, VectorXd::Zero(rings_)};
    for (Index i = 0; i < rings_; ++i) {
      now.give(i) = edge_compliance_along(1.0, nodes_.gap()(i), gap_(i), now.force(i), force_(i));
    }
    impact_.steps.push_back(std::move(now));
    if (pushes) steps_with_force_ = impact_.steps.size();
  }

  const Contact& contact_;
  double speed_, step_;
  Index rings_;
  ParityBlock block_;  // (x | outward)
  EdgeLaw law_;
  SidedContact nodes_;
  VectorXd recess_;
  double range_;
  double compression_, velocity_;  // before the kick that is due
  double total_ = 0.0;             // Σ f
  bool lossy_;
  VectorXd x_, place_;          // where the modes put the rings, and how far out they are
  VectorXd moved_x_, moved_y_;  // by the modes above the cutoff, into the body and inward
  VectorXd force_, rub_, gap_;  // f, q, g
  double work_ = 0.0, edge_work_ = 0.0, heat_ = 0.0;
  OutwardImpact impact_;
  std::size_t steps_with_force_ = 0;
  long moved_ = 0;  // steps
};

/// One run; empty if the contact outgrew the grid.
std::optional<OutwardImpact> run_outward(const Contact& contact, const Contact& outward, double speed, double friction,
                                         const FixedResolution& resolution, const Poll& poll) {
  const ContactGrid grid = contact_grid(contact, resolution.half_width, resolution.nodes);
  OutwardCollision collision(contact, outward, speed, friction, resolution, grid, poll);
  const double most = (longest_duration(contact) + collision.flight() / speed) / resolution.step;
  Rest rest(contact, speed, most);
  for (long step = 1; !collision.over(); ++step) {
    if (static_cast<double>(step) > most) {
      if (rest.ends(collision.slowing())) break;
      if (contact.unbounded) throw Outlasted(static_cast<double>(step) * resolution.step, echo_time(contact));
      throw NotConverged("impact: the contact has not ended after " + std::to_string(step) + " steps");
    }
    if (poll) poll();
    collision.advance();
    rest.watch(step, [&] { return collision.slowing(); });
    if (!collision.overflows()) continue;
    if (resolution.half_width < greatest_half_width(contact)) return std::nullopt;
    throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
  }
  return collision.result(rest);
}

}  // namespace

OutwardImpact outward_impact(const Contact& contact, const Contact& outward, double speed, double friction,
                             const Resolution& resolution, const Poll& poll) {
  FixedResolution fixed = fixed_resolution(contact, speed, resolution);
  for (;; fixed = widened(contact, fixed)) {
    std::optional<OutwardImpact> result = run_outward(contact, outward, speed, friction, fixed, poll);
    if (!result) continue;
    const double lasted = result->momentum > 0.0 ? 0.0 : static_cast<double>(result->steps.size()) * fixed.step;
    if (lasted > echo_time(contact)) throw Outlasted(lasted, echo_time(contact));
    return std::move(*result);
  }
}

}  // namespace stoss
