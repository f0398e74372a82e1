#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "questions.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/inside.hpp"
#include "stoss/encounter/waves.hpp"
#include "stoss/errors.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/impact/sound.hpp"

namespace stoss::web {
namespace {

using emscripten::val;

bodies::PolarGrid points_of(const val& grid) { return {numbers(grid["radius"]), numbers(grid["angle"])}; }

/// An impact that can be repeated.
struct Replayed {
  Contact contact;
  Impact impact;
  ContactGrid grid;

  Replayed(Contact what, double speed, const ImpactObserver& observer = {})
      : contact(std::move(what)),
        impact(stoss::impact(contact, speed, {.poll = say_alive}, {.observer = observer})),
        grid(contact_grid(contact, impact.resolution.half_width, impact.resolution.nodes)) {}
};

/// One impact in time, with what its frames have in common.
class Collision {
 public:
  Collision(std::shared_ptr<const Meeting> meeting, double speed, double cutoff)
      : meeting_(std::move(meeting)),
        its_(contact_of(meeting_->encounter, cutoff, speed), speed,
             [this](const Snapshot& now) { snapshots_.push_back(now); }) {}

  /// Collision of the protocol.
  [[nodiscard]] val series() const {
    // Rough faces, which feel each other at any distance, touch as Impact::contact_time has it.
    double least = 0.0;
    for (const Snapshot& now : snapshots_) {
      if (its_.contact.asperities > 0.0) least = std::max(least, 1e-3 * now.force);
    }
    const auto touches = [least](const Snapshot& now) { return now.force > least; };
    const auto begin = std::find_if(snapshots_.begin(), snapshots_.end(), touches);
    const auto end = std::find_if(snapshots_.rbegin(), snapshots_.rend(), touches);
    const double second = meeting_->unit(Dimension::time);
    val units = val::object();
    val made = object({{"units", units},
                       {"modes", modes()},
                       {"begin", begin == snapshots_.end() ? 0.0 : begin->time * second},
                       {"end", end == snapshots_.rend() ? 0.0 : end->time * second}});
    for (const auto& each : snapshot_quantities()) {
      std::vector<double> values;
      for (const Snapshot& now : snapshots_) values.push_back(std::get<double>(each.value(now)));
      made.set(each.name, float64_array(values, meeting_->unit(each.dimension)));
      units.set(each.name, meeting_->unit_name(each.dimension));
    }
    return made;
  }

  /// Delivers the frames at some times, which ascend.
  void frames(const Question& asked) {
    const val grid = asked.given["grid"], under = grid["below"];
    const bodies::PolarGrid points = points_of(grid);
    bodies::half_space::PlaneGrid below;
    if (!under.isUndefined()) below = {numbers(under["distance"]), numbers(under["depth"])};
    if (points.radius != points_.radius || points.angle != points_.angle) {
      insides_.clear();
      lasting_.reset();
    }
    points_ = points;
    const double unit = meeting_->unit(Dimension::time);
    std::vector<double> own;
    for (const double each : numbers(asked.given["times"])) own.push_back(each / unit);
    const Replayed& shown = replayed(below, own);
    const std::vector<Frame> instants = frames_at(shown.contact, shown.impact, own, say_alive);
    for (std::size_t i = 0; i < instants.size(); ++i) {
      val seen = val::array();
      for (std::size_t n = 0; n < (shown.contact.second ? 2 : 1); ++n) {
        const BodyFrame its = seen_by(shown.contact, shown.grid, instants[i], static_cast<int>(n));
        if (insides_.size() == n) {
          insides_.push_back(inside(meeting_->solid(static_cast<int>(n)), its, points, below, say_alive));
        }
        const Interior now = insides_[n](its);
        seen.call<void>("push", object({{"center", its.center},
                                        {"radial", float32_array(now.radial)},
                                        {"tangential", float32_array(now.tangential)},
                                        {"vonMises", float32_array(now.von_mises, its.stress)},
                                        {"fringes", float32_array(now.principal_difference, its.stress)}}));
      }
      asked.deliver(object({{"time", instants[i].time * unit}, {"bodies", seen}}), i);
    }
  }

  /// Velocity of the struck point of a body after the impact.
  [[nodiscard]] val sound(const Question& asked) const {
    SoundOptions options{.body = asked.given["body"].as<int>(),
                         .interval = asked.number("interval") / meeting_->unit(Dimension::time),
                         .count = static_cast<std::size_t>(asked.number("count"))};
    const Body& its = options.body == 0 ? *its_.contact.first : *its_.contact.second;
    if (its.loss_time == 0.0 && its.relaxation.terms.empty()) options.quality = asked.number("quality");
    return float32_array(stoss::sound(its_.contact, its_.impact, options, say_alive));
  }

 private:
  /// Of the bodies, without the waves of a half-space.
  [[nodiscard]] val modes() const {
    std::vector<ModeEnergy> its = its_.impact.energy.modes;
    if (meeting_->against_unbounded()) std::erase_if(its, [](const ModeEnergy& mode) { return mode.body == 1; });
    return list(its, [](const ModeEnergy& mode) {
      return object({{"body", mode.body},
                     {"order", mode.order},
                     {"index", mode.index},
                     {"omega", mode.omega},
                     {"after", mode.after},
                     {"average", mode.average}});
    });
  }

  /// What is shown up to the last of some times: of a plate, which is seen farther from the axis than it is struck, one
  /// that is good for as long as waves run there.
  const Replayed& replayed(const bodies::half_space::PlaneGrid& below, const std::vector<double>& times) {
    if (!meeting_->against_plate()) return its_;
    if (!lasting_ || latest_ < times.back()) {
      latest_ = times.back();
      insides_.clear();
      lasting_.emplace(lasting(meeting_->encounter, its_.impact.cutoff, std::max(latest_, its_.impact.contact_time),
                               below, say_alive),
                       its_.impact.speed);
    }
    return *lasting_;
  }

  std::shared_ptr<const Meeting> meeting_;
  std::vector<Snapshot> snapshots_;
  Replayed its_;
  std::optional<Replayed> lasting_;
  double latest_ = 0.0;
  bodies::PolarGrid points_;     ///< of the last frames
  std::vector<Inside> insides_;  ///< of what meets, at these points
};

/// That of a question; the last one is kept.
Collision& collision_of(const Question& asked) {
  static std::tuple<std::string, double, double> last;
  static std::optional<Collision> its;
  const std::tuple which{asked.text("document"), asked.number("speed"), asked.number("cutoff")};
  if (!its || last != which) {
    its.reset();
    const auto meeting = asked.meeting();
    its.emplace(meeting, speed_in_c(meeting->encounter, asked.number("speed")), asked.number("cutoff"));
    last = which;
  }
  return *its;
}

/// One impact in time, as `stoss impact --cutoff` computes it.
/// @throws InvalidInput as impact; NotConverged where it does not end
val collision(const Question& asked) { return collision_of(asked).series(); }

/// Frames of it, one by one.
val frames(const Question& asked) {
  collision_of(asked).frames(asked);
  return val::undefined();
}

/// What is heard of a body after the impact.
val sound(const Question& asked) { return collision_of(asked).sound(asked); }

/// The shape of a mode of a body.
val shape(const Question& asked) {
  const auto meeting = asked.meeting();
  const int body = asked.given["body"].as<int>();
  if (body == 1 && !meeting->second) throw InvalidInput::out_of_range("body", "the second", "the first");
  const Interior made = mode_shape(meeting->solid(body), asked.given["order"].as<int>(), asked.given["index"].as<int>(),
                                   points_of(asked.given["grid"]));
  return object({{"radial", float32_array(made.radial)}, {"tangential", float32_array(made.tangential)}});
}

}  // namespace

EMSCRIPTEN_BINDINGS(collision) {
  emscripten::function("collision", &answered<collision>);
  emscripten::function("frames", &answered<frames>);
  emscripten::function("sound", &answered<sound>);
  emscripten::function("shape", &answered<shape>);
}

}  // namespace stoss::web
