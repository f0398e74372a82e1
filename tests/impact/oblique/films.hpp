#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "stoss/impact/oblique.hpp"

namespace stoss::test {

/// What an observer of an oblique impact is shown, kept.
struct Instant : ObliqueSnapshot {
  std::vector<ObliquePoint> points;
};

struct Seen {
  ObliqueImpact impact;
  std::vector<Instant> instants;
};

inline ObliqueObservation into(std::vector<Instant>& instants, int every = 1) {
  return {[&](const ObliqueSnapshot& now) {
            instants.push_back({now, {now.points.begin(), now.points.end()}});
          },
          every};
}

struct FilmCase {
  std::string name;
  Contact contact;
  double speed;
  Obliquity before;
};

inline void PrintTo(const FilmCase& its, std::ostream* out) { *out << its.name; }

inline ImpactOptions options_of(const Contact& contact) {
  ImpactOptions options;
  options.resolution.step = 0.5 / contact.cutoff;
  options.resolution.nodes = 24;
  return options;
}

inline Seen seen(const FilmCase& its, int every = 1) {
  Seen result;
  result.impact =
      oblique_impact(its.contact, its.speed, its.before, options_of(its.contact), into(result.instants, every));
  return result;
}

}  // namespace stoss::test
