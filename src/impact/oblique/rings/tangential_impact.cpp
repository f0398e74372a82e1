#include "impact/oblique/rings/tangential_impact.hpp"

#include <Eigen/Core>
#include <numeric>
#include <utility>

#include "contact/response.hpp"
#include "contact/touch.hpp"

namespace stoss {
namespace {

ResidualMotion::Inertia inertia_of(Tail tail) {
  return tail == Tail::radiating ? ResidualMotion::Inertia::all : ResidualMotion::Inertia::none;
}

KeptModes modes_of(const std::pair<Contact, ContactGrid>& along, const FixedResolution& resolution) {
  const bool weaker = follows_at_once(along.first, resolution.tail);
  return {along.first, along.second, resolution.step, weaker ? Kicks::weaker : Kicks::whole};
}

std::pair<Contact, ContactGrid> kept(const Contact& along, const ContactGrid& grid, std::size_t remembered) {
  if (remembered == 0) return {along, grid};
  return without_remembered(along, grid);
}

}  // namespace

TangentialResponse::TangentialResponse(const Contact& contact, const Contact& along_it, const ContactPoints& points,
                                       const FixedResolution& resolution, std::size_t remembered, const Poll& poll)
    : TangentialResponse(contact, along_it, contact_grid(along_it, points), resolution, remembered, poll) {}

TangentialResponse::TangentialResponse(const Contact& contact, const Contact& along_it, const ContactGrid& grid,
                                       const FixedResolution& resolution, std::size_t remembered, const Poll& poll)
    : step(resolution.step),
      ratio(touch(along_it).softness / touch(contact).softness),
      arm(arms(contact, grid.points)),
      along(kept(along_it, grid, remembered).first),
      waves(along_it, grid, step, remembered, poll),
      modes(modes_of(kept(along_it, grid, remembered), resolution)),
      residuals(along_it, grid, inertia_of(resolution.tail), step, poll),
      compliance(residuals.compliance(poll)) {}

TangentialImpact::TangentialImpact(const TangentialResponse& response, const ObliqueFrame& frame,
                                   const Obliquity& before)
    : response_(response),
      rigid_(frame, response.arm, response.step, before),
      modes_(response.modes),
      waves_(response.waves),
      residuals_(response.residuals),
      friction_(response.arm[0].size()),
      friction_before_(friction_.size()),
      at_(friction_.size()),
      place_(friction_.size()),
      place_before_(friction_.size()),
      give_(friction_.size()),
      free_(friction_.size()),
      moved_(friction_.size()),
      moved_before_(friction_.size()) {}

void TangentialImpact::begin_step(const double* give) {
  rigid_.advance();
  modes_.advance();
  waves_.advance();
  rigid_.place(at_);
  modes_.add_displacement(at_);
  waves_.add_displacement(at_);
  const Values& rest = residuals_.predict();
  moved_before_ = std::exchange(moved_, rest);
  for (std::size_t i = 0; i < at_.size(); ++i) {
    free_[i] = at_[i] - rest[i] - place_[i];
    give_[i] = response_.ratio * give[i];
  }
  friction_before_ = friction_;
}

void TangentialImpact::end_step(std::size_t touching) {
  const std::size_t nodes = at_.size();
  numeric::kernels::multiply_transposed(response_.compliance.data(), nodes, touching, 0, nodes, friction_.data(),
                                        place_before_.data());
  for (std::size_t i = 0; i < nodes; ++i) {
    moved_[i] += place_before_[i];
    place_before_[i] = place_[i];
    place_[i] = at_[i] - moved_[i];
    const double mean = 0.5 * (friction_before_[i] + friction_[i]);
    work_ += mean * (moved_[i] - moved_before_[i]);
    heat_ += mean * (place_[i] - place_before_[i]);
  }
  residuals_.move(moved_, friction_, touching);
  modes_.load(friction_, touching);
  waves_.load(friction_);
  rigid_.load(Eigen::Map<const Eigen::VectorXd>(friction_.data(), static_cast<Eigen::Index>(nodes)));
}

std::vector<PointFriction> TangentialImpact::point_friction() const {
  std::vector<PointFriction> point_friction(at_.size());
  for (std::size_t i = 0; i < point_friction.size(); ++i) {
    point_friction[i] = {friction_[i], (place_[i] - place_before_[i]) / response_.step};
  }
  return point_friction;
}

AlongMotion TangentialImpact::motion() const {
  AlongMotion motion = rigid_.motion(0.0);
  motion.outcome = outcome();
  return motion;
}

AlongOutcome TangentialImpact::outcome() const {
  AlongOutcome after = rigid_.outcome();
  const Values energies = modes_.energies();
  const auto second = energies.begin() + static_cast<std::ptrdiff_t>(mode_count(*response_.along.first));
  after.vibration = {std::accumulate(energies.begin(), second, 0.0),
                     std::accumulate(second, energies.end(), waves_.energy())};
  const auto [first_lost, second_lost] = residuals_.dissipated();
  const auto [first_stored, second_stored] = residuals_.stored();
  after.stored = first_stored + second_stored;
  after.dissipated = modes_.dissipated(0, response_.along.groups.size()) + first_lost + second_lost;
  after.friction = heat_;
  after.unresolved = work_ - first_lost - second_lost - after.stored;
  return after;
}

}  // namespace stoss
