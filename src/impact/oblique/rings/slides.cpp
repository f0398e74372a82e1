// The motion along the surface under the pressures of a normal impact, by the same kick–rotate–kick. All of it is
// divided by the coefficient of friction, so that the pressures themselves are the limits of friction.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "contact/along.hpp"
#include "contact/friction.hpp"
#include "contact/residual/residuals.hpp"
#include "contact/response.hpp"
#include "contact/touch.hpp"
#include "impact/kept_modes.hpp"
#include "impact/oblique/film.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/oblique/rings/normal_course.hpp"
#include "impact/oblique/rings/wave_memory.hpp"
#include "numeric/kernels.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/oblique.hpp"

namespace stoss {
namespace {

using Values = std::vector<double>;

Contact contact_along(const Contact& contact, const Poll& poll) {
  std::vector<Contact> along = contacts_along(contact, poll);
  if (along.size() == 1) return std::move(along.front());
  throw InvalidInput::out_of_range(
      "slides", "'" + name(contact) + "'",
      "bodies whose motions along the normal and along the surface do not act on each other, as spheres",
      "compute each oblique impact by itself");
}

ResidualMotion::Inertia inertia_of(Tail tail) {
  return tail == Tail::radiating ? ResidualMotion::Inertia::all : ResidualMotion::Inertia::none;
}

Kicks kicks_of(const Contact& contact, Tail tail) {
  return follows_at_once(contact, tail) ? Kicks::weaker : Kicks::whole;
}

}  // namespace

struct Slides::Parts {
  NormalCourse course;
  double step;
  Contact along;  // without the waves that are remembered
  double ratio;   // of softness along the surface to that along the normal
  // At rest.
  KeptModes modes;
  WaveMemory waves;
  Residuals residuals;
  Values compliance;

  static Parts of(const Contact& contact, double speed, const ImpactOptions& options) {
    // Refuse at once what has no answer along its surface.
    Contact along = contact_along(contact, options.poll);
    NormalCourse course(contact, speed, options);
    const FixedResolution& resolution = course.impact.resolution;
    const ContactGrid grid = contact_grid(along, course.nodes);
    const double step = resolution.step, ratio = touch(along).softness / touch(contact).softness;
    const Residuals residuals(along, grid, inertia_of(resolution.tail), step, options.poll);
    WaveMemory waves(along, grid, step, course.pressures.steps(), options.poll);
    auto [kept, kept_grid] = without_remembered(along, grid);
    KeptModes modes(kept, kept_grid, step, kicks_of(along, resolution.tail));
    return {std::move(course), step,
            std::move(kept),   ratio,
            std::move(modes),  std::move(waves),
            residuals,         residuals.compliance(options.poll)};
  }
};

namespace {

/// One motion along the surface.
template <typename Parts>
class Slide {
 public:
  Slide(const Parts& parts, const AlongOutcome& start)
      : parts_(parts),
        course_(parts.course),
        modes_(parts.modes),
        waves_(parts.waves),
        residuals_(parts.residuals),
        friction_(nodes()),
        tangential_(start.tangential),
        spin_(start.spin),
        force_(nodes()),
        force_before_(nodes()),
        place_(nodes()),
        give_(nodes()),
        free_(nodes()),
        displacement_(nodes()),
        moved_(nodes()) {}

  void advance(std::size_t step) {
    kick();
    centre_ += tangential_ * parts_.step;
    for (std::size_t k = 0; k < 2; ++k) turned_[k] += spin_[k] * parts_.step;
    modes_.advance();
    waves_.advance();
    Values place = kept_place();
    const Values& rest = residuals_.predict();
    const double* give = course_.pressures.give(step);
    for (std::size_t i = 0; i < nodes(); ++i) {
      free_[i] = place[i] - rest[i] - place_[i];
      give_[i] = parts_.ratio * give[i];
    }
    force_before_ = force_;
    const std::size_t touching = course_.pressures.extent(step);
    friction_.solve(parts_.compliance, give_, free_, course_.pressures.force(step), force_);
    numeric::kernels::multiply_transposed(parts_.compliance.data(), nodes(), touching, 0, nodes(), force_.data(),
                                          moved_.data());
    for (std::size_t i = 0; i < nodes(); ++i) {
      moved_[i] += rest[i];
      place[i] -= moved_[i];
      const double mean = 0.5 * (force_before_[i] + force_[i]);
      work_ += mean * (moved_[i] - displacement_[i]);
      heat_ += mean * (place[i] - place_[i]);
    }
    displacement_.swap(moved_);
    residuals_.move(displacement_, force_, touching);
    place_.swap(place);
    place_before_.swap(place);
    modes_.load(force_, touching);
    waves_.load(force_);
    kick();
  }

  /// Ways along the surface so far, and the outcome.
  [[nodiscard]] AlongMotion motion() const { return {outcome(), centre_, turned_}; }

  [[nodiscard]] std::vector<Rub> rubs() const {
    std::vector<Rub> nodes(this->nodes());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i] = {force_[i], (place_[i] - place_before_[i]) / parts_.step, friction_.sliding()[i]};
    }
    return nodes;
  }

  [[nodiscard]] AlongOutcome outcome() const {
    AlongOutcome after;
    after.tangential = tangential_;
    after.spin = spin_;
    after.impulse = impulse_;
    after.moment = moment_;
    const Values energies = modes_.energies();
    const auto second = energies.begin() + static_cast<std::ptrdiff_t>(mode_count(*parts_.along.first));
    after.vibration = {std::accumulate(energies.begin(), second, 0.0),
                       std::accumulate(second, energies.end(), waves_.energy())};
    const auto [first_lost, second_lost] = residuals_.dissipated();
    after.stored = residuals_.stored();
    after.dissipated = modes_.dissipated(0, parts_.along.groups.size()) + first_lost + second_lost;
    after.friction = heat_;
    after.unresolved = work_ - first_lost - second_lost - after.stored;
    return after;
  }

 private:
  [[nodiscard]] std::size_t nodes() const { return course_.arm[0].size(); }

  /// Half a kick of the rigid motion.
  void kick() {
    const double half = 0.5 * parts_.step;
    const double impulse = half * std::accumulate(force_.begin(), force_.end(), 0.0);
    impulse_ += impulse;
    tangential_ -= impulse / course_.frame.mass_along;
    for (std::size_t k = 0; k < 2; ++k) {
      if (course_.frame.inertia[k] == 0.0) continue;
      const double moment = half * std::inner_product(force_.begin(), force_.end(), course_.arm[k].begin(), 0.0);
      moment_[k] += moment;
      spin_[k] -= moment / course_.frame.inertia[k];
    }
  }

  /// Where the nodes would be without what is not kept.
  Values kept_place() {
    Values place(nodes());
    for (std::size_t i = 0; i < nodes(); ++i) {
      place[i] = centre_ + turned_[0] * course_.arm[0][i] + turned_[1] * course_.arm[1][i];
    }
    modes_.add_displacement(place);
    waves_.add_displacement(place);
    return place;
  }

  const Parts& parts_;
  const NormalCourse& course_;
  KeptModes modes_;
  WaveMemory waves_;
  Residuals residuals_;
  Friction friction_;
  double centre_ = 0.0, tangential_;       // place and velocity along y of the centres
  std::array<double, 2> turned_{}, spin_;  // angle and spin of each body
  Values force_, force_before_;            // q
  Values place_, place_before_;            // of each node along y; in the step before
  Values give_, free_;                     // D; slip without friction
  Values displacement_, moved_;            // u; the next one
  double work_ = 0.0, heat_ = 0.0;         // ∫ q du, ∫ q dy
  double impulse_ = 0.0;
  std::array<double, 2> moment_{};
};

/// @throws NotConverged where the motion along the surface is not resolved in time and means nothing: energy is
/// missing, or comes out of what can only take it
void require_resolved(const ObliqueImpact& impact) {
  constexpr double most = 1e-2;
  const ObliqueLedger& energy = impact.energy;
  const double missing = std::max({std::abs(impact.energy_error), -energy.friction, -energy.unresolved});
  if (missing <= most) return;
  throw NotConverged(
      "impact: " + std::to_string(missing) + " of the energy is unaccounted for in the motion along the surface",
      "step", "use a smaller step");
}

}  // namespace

Slides::Slides(const Contact& contact, double speed, const ImpactOptions& options)
    : parts_(std::make_shared<const Parts>(Parts::of(contact, speed, options))) {}

const Impact& Slides::normal() const { return parts_->course.impact; }

ObliqueImpact Slides::after(const Obliquity& obliquity, const Poll& poll, const ObliqueObservation& observation) const {
  const NormalCourse& course = parts_->course;
  course.frame.require(obliquity);
  const AlongOutcome start = ObliqueFrame::unchanged(obliquity);
  const double friction = obliquity.friction;
  if (friction == 0.0) return smooth_impact(course, obliquity, observation);
  ObliqueFilm film(course, obliquity, observation);
  film.fly(course.pressures.first() - 1, {start});
  Slide slide(*parts_, times(1.0 / friction, start));
  for (std::size_t step = 0; step < course.pressures.steps(); ++step) {
    if (poll) poll();
    slide.advance(step);
    if (film.advance()) film.show(times(friction, slide.motion()), times(friction, slide.rubs()));
  }
  const AlongMotion end = times(friction, slide.motion());
  film.fly(course.impact.steps, end);
  const double momentum = course.mass * course.impact.final_state.velocity;
  ObliqueImpact result = course.frame.joined(course.impact, obliquity, end.outcome, momentum);
  require_resolved(result);
  return result;
}

}  // namespace stoss
