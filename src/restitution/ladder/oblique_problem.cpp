#include "restitution/ladder/oblique_problem.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/touch.hpp"
#include "impact/oblique/frame.hpp"
#include "impact/recommended.hpp"
#include "restitution/error_bar.hpp"
#include "restitution/ladder/oblique_plan.hpp"

namespace stoss {
ObliqueProblem::ObliqueProblem(const RefinableContact& contact, const ObliqueOptions& options,
                               const std::vector<ObliqueRestitution*>& all, Content content)
    : options_(options),
      own_{contact, all.front()->speed, options.poll, 1.0 / contact.part()},
      content_(content),
      all_(all),
      open_(all) {
  const double speed = own_.speed;
  if (own_.probe().unbounded) {
    own_.stretch = contact.stretch(speed);
  } else {
    (void)contact.highest_whole_level();  // which refuses bodies that are too unequal
  }
  const Contact& coarse = own_.at(0);
  const bool rings = touch(coarse).circle;
  bool has_friction = false;
  std::vector<Obliquity> before;
  for (const ObliqueRestitution* each : open_) {
    before.push_back(each->before);
    has_friction = has_friction || each->before.friction > 0.0;
  }
  plan_ = plan_of(coarse, speed, before, options.tolerance, options.poll);
  shares_ = rings && has_friction;
  along_ = levels_of(plan_, contact, speed, own_.stretch, options.poll);
  own_.levels = along_;
  normal_is_open_ = content == Content::all && (rings || !has_friction);
  if (!normal_is_open_) return;
  central_.emplace(contact, speed, RestitutionOptions{.poll = options.poll, .vibration = options.vibration});
  Levels& levels = central_->where.levels;
  if (!shares_) {
    along_ = levels;  // nothing else moves along the surface
    next_along_ = next_normal_ = levels.lowest;
    return;
  }
  const int third_last = std::max(along_.lowest, along_.highest - 2 * between());
  along_.lowest = lowest_level(contact, options.vibration, {along_.lowest, third_last}, options.poll);
  next_along_ = next_normal_ = along_.lowest;
  while (next_normal_ < levels.lowest) next_normal_ += between();
  levels.lowest = along_.lowest;
}

// Three runs make a value: of bodies so unequal that there are but three levels, at each of them.
int ObliqueProblem::between() const {
  constexpr int rungs = 2;
  return along_.highest - along_.lowest < 2 * rungs ? 1 : rungs;
}

ImpactOptions ObliqueProblem::options_at(const Contact& resolved, int level) const {
  const int above = level - along_.lowest;
  if (!central_) {
    const Resolution resolution = plan_.resolution(resolved, own_.speed, width_, above);
    ImpactOptions of_one{.resolution = resolution, .poll = options_.poll};
    if (!options_.vibration.empty()) of_one.start = approach(resolved, own_.speed, options_.vibration);
    return of_one;
  }
  ImpactOptions of_one = central_->options_at(resolved);
  if (!shares_) return of_one;
  // Friction takes time with the square of the points: the first three runs have what s′ needs of them.
  std::optional<int>& nodes = of_one.resolution.nodes;
  const int needed = static_cast<int>(std::lround(plan_.needed(above)));
  const bool is_first = above <= 2 * between();
  nodes = is_first ? *plan_.resolution(resolved, own_.speed, width_, above).nodes : std::max(*nodes, needed);
  return of_one;
}

void ObliqueProblem::compute(const Contact& resolved, int level) {
  impacts_.clear();
  const double speed = own_.speed;
  const ImpactOptions of_one = options_at(resolved, level);
  if (!central_) {
    if (!shares_) {
      for (const ObliqueRestitution* each : open_) {
        impacts_.push_back(oblique_impact(resolved, speed, each->before, of_one));
      }
      return;
    }
    const SharedNormalImpact shared(resolved, speed, of_one);
    for (const ObliqueRestitution* each : open_) impacts_.push_back(shared.with(each->before, options_.poll));
    return;
  }
  if (!shares_ || !wants_along(level)) {
    central_->take(impact(resolved, speed, of_one), level);
    if (shares_) return;
    const ObliqueFrame frame(resolved, speed, of_one);
    for (const ObliqueRestitution* each : open_) {
      impacts_.push_back(frame.joined(central_->finest(), each->before, ObliqueFrame::unchanged(each->before)));
    }
    return;
  }
  const SharedNormalImpact shared(resolved, speed, of_one);
  if (wants_normal(level)) central_->take(shared.normal(), level);
  try {
    for (const ObliqueRestitution* each : open_) impacts_.push_back(shared.with(each->before, options_.poll));
  } catch (const NotConverged& error) {
    if (!wants_normal(level)) throw;
    impacts_.clear();  // the normal impact stands
    trouble_along_ = error.what();
  }
}

int ObliqueProblem::next(int level) {
  int nearest = std::numeric_limits<int>::max();
  if (!open_.empty()) nearest = std::min(nearest, next_along_);
  if (normal_is_open_) nearest = std::min(nearest, next_normal_);
  return nearest == std::numeric_limits<int>::max() ? 0 : nearest - level;
}

int ObliqueProblem::add(int level) {
  const bool normal = wants_normal(level), along = wants_along(level);
  if (!impacts_.empty()) add_along(level);
  if (normal) add_normal(level);
  if (along) next_along_ = shares_ || !central_ ? level + between() : next_normal_;
  if (central_ && next_along_ > along_.highest) give_up(trouble_along_);
  return next(level);
}

int ObliqueProblem::skip(int level) {
  if (wants_normal(level)) {
    next_normal_ += shares_ && central_->runs() < fewest_runs ? between() : central_->skip(level);
  }
  if (wants_along(level)) next_along_ = shares_ || !central_ ? level + between() : next_normal_;
  if (central_ && next_along_ > along_.highest) give_up(where().trouble);
  return next(level);
}

void ObliqueProblem::add_normal(int level) {
  normal_runs_.push_back(normal_run(central_->finest()));
  const int own = central_->add(level);
  if (own == 0) return close_normal();
  next_normal_ += shares_ && central_->runs() < fewest_runs ? between() : own;
}

void ObliqueProblem::add_along(int level) {
  trouble_along_.clear();
  for (std::size_t k = 0; k < open_.size(); ++k) {
    width_ = std::max(width_, known_half_width(own_.probe(), own_.speed, impacts_[k].normal));
    add_run(plan_, std::move(impacts_[k]), *open_[k]);
  }
  const auto done = [](const ObliqueRestitution* each) { return each->converged; };
  open_.erase(std::remove_if(open_.begin(), open_.end(), done), open_.end());
  if (open_.empty()) return;
  const auto out_of_reach = [](const ObliqueRestitution* each) { return is_out_of_reach(*each); };
  if (std::all_of(open_.begin(), open_.end(), out_of_reach)) return give_up("");
  const Contact& resolved = where().at(level);
  const double highest = own_.contact.cutoff(along_.highest);
  if (content_ == Content::motion_along) {    // a table needs all of them
    constexpr double doubt_of_points = 1.25;  // of what is left by them at the last level
    double least = 0.0;
    for (const ObliqueRestitution* each : open_) {
      least = std::max(least, left_by_points(plan_, *each, resolved, highest, along_.highest - along_.lowest));
    }
    if (least > doubt_of_points * options_.tolerance) throw OutOfReach(least);
  }
  const auto hopeless = [&](const ObliqueRestitution* each) { return is_hopeless(plan_, *each, highest); };
  const bool costs_much = takes_seconds_after(resolved, open_.front()->finest, shares_, open_.size());
  if (costs_much && std::all_of(open_.begin(), open_.end(), hopeless)) give_up("");
}

void ObliqueProblem::give_up(const std::string& reason) {
  for (ObliqueRestitution* each : open_) {
    each->reason = reason;
    mark_unconverged(plan_, *each);
  }
  open_.clear();
}

void ObliqueProblem::close_normal() {
  normal_is_open_ = false;
  Restitution best;
  try {
    best = of_own_choice([this] { return central_->concluded(); });
  } catch (const RestitutionNotConverged& error) {
    best = error.best;
  } catch (const NotConverged&) {  // fewer than two runs
    return;
  }
  if (shares_) add_spacing(where().probe(), best);
  normal_ = best.restitution;
  where().trouble.clear();
}

double ObliqueProblem::solve() {
  try {
    climb(where(), *this);
    give_up(where().trouble.empty() ? trouble_along_ : where().trouble);
    if (normal_is_open_) close_normal();
  } catch (const DoesNotEnd& error) {
    give_up(error.what());
  }
  if (central_) {
    for (ObliqueRestitution* each : all_) {
      each->restitution = normal_;
      add_normal_runs(normal_runs_, *each);
    }
  }
  return where().stretch;
}

}  // namespace stoss
