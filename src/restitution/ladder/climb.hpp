#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "restitution/lasting.hpp"
#include "restitution/own_choice.hpp"
#include "stoss/restitution/ladder.hpp"

namespace stoss {

inline constexpr std::size_t fewest_runs = 3;  // for a value: two that agree by chance say nothing

/// Impacts of one contact at one speed, at rising levels.
struct Climb {
  const RefinableContact& contact;
  double speed;
  Poll poll;
  double stretch;         ///< of the last contact (RefinableContact::stretch)
  Levels levels{};        ///< of the first run and of the finest
  std::string trouble{};  ///< why the last level gave no run, or why there is no further one

  [[nodiscard]] const Contact& probe() const { return contact.at(0, poll); }
  [[nodiscard]] const Contact& at(int level) const { return contact.at(contact.cutoff(level), stretch, poll); }
  [[nodiscard]] double highest_cutoff() const { return contact.cutoff(levels.highest); }
};

/// Runs impacts of a problem at rising levels until it has enough of them, or none is left. A problem
///
/// - begins a level, before its impact: `begin(level)`,
/// - computes the impact there, perhaps again with a contact that lasts longer: `compute(resolved, level)`,
/// - adds it to the runs before: `add(level)`; or goes on without, where the level is too coarse perhaps and `trouble`
///   says why: `skip(level)`. Both say how many levels above the next run is; 0 ends the climb.
///
/// @throws DoesNotEnd, and what `begin`, `add` and `skip` throw
template <typename Problem>
void climb(Climb& at, Problem& problem) {
  for (int level = at.levels.lowest, rungs = 1; level <= at.levels.highest && rungs > 0; level += rungs) {
    problem.begin(level);
    try {
      of_own_choice([&] {
        retry_until_contact_ends(at.contact, at.contact.cutoff(level), at.speed, at.stretch, at.poll,
                                 [&](const Contact& resolved) { problem.compute(resolved, level); });
      });
      at.trouble.clear();
    } catch (const DoesNotEnd&) {
      throw;
    } catch (const NotConverged& error) {
      at.trouble = error.what();
    }
    rungs = at.trouble.empty() ? problem.add(level) : problem.skip(level);
  }
}

/// Maximum difference of a quantity of the last run from those before, each scaled to what is left of it at the last
/// cutoff.
template <typename Run, typename Quantity>
double spread(const std::vector<Run>& runs, double order, const Quantity& quantity) {
  const Run& last = runs.back();
  double greatest = 0.0;
  for (const Run& run : runs) {
    const double difference = std::abs(std::invoke(quantity, run) - std::invoke(quantity, last));
    greatest = std::max(greatest, std::pow(run.cutoff / last.cutoff, order) * difference);
  }
  return greatest;
}

}  // namespace stoss
