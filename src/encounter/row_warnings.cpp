// What a user of a row must be told of its materials, contact by contact.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "contact/unit_ratios.hpp"
#include "encounter/yielding.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/encounter/row.hpp"

namespace stoss {
namespace {

/// Two that meet, and how fast they would by themselves.
struct Met {
  Encounter pair;
  double speed;  // m/s
  std::size_t contact;
};

/// Masses of the bodies and of what stands behind them, in that of the first.
std::vector<double> masses_of(const Row& row) {
  constexpr double few = 1e-3;  // any cutoff
  const Body first = row.kinds[row.bodies.front()](few, {});
  std::vector<double> of_kind, all;
  for (const BodyMaker& kind : row.kinds) {
    const Body body = kind(few, {});
    of_kind.push_back(whole_mass(body) * UnitRatios(body, first).mass / whole_mass(first));
  }
  for (const std::size_t each : row.bodies) all.push_back(of_kind[each]);
  return all;
}

std::vector<Met> contacts_of(const GivenRow& given, const std::vector<double>& work) {
  const double unit = speed_unit(first_of(given));
  const std::vector<double> mass = masses_of(row_of(given));
  std::vector<Met> met;
  const auto add = [&](const Participant& first, const Participant& other, double less) {
    const std::size_t k = met.size();
    const double fastest = k < work.size() ? unit * std::sqrt(0.8 * std::max(0.0, work[k]) * less) : 0.0;  // of NaN 0
    met.push_back({{.first = first, .against = other}, fastest, k});
  };
  const Participant wall = given.after && given.after->kind == "wall" ? *given.after : Encounter{}.against;
  if (given.wall_before) add(given.bodies.front(), wall, 1.0 / mass.front());
  for (std::size_t b = 1; b < given.bodies.size(); ++b) {
    add(given.bodies[b - 1], given.bodies[b], 1.0 / mass[b - 1] + 1.0 / mass[b]);
  }
  if (given.after) add(given.bodies.back(), *given.after, 1.0 / mass[given.bodies.size() - 1]);
  return met;
}

}  // namespace

std::vector<std::string> material_warnings(const GivenRow& given, const std::vector<double>& work) {
  std::vector<std::string> all;
  if (!si_scales(first_of(given))) return all;
  std::map<std::string, Met> hardest;  // of each pair
  for (const Met& each : contacts_of(given, work)) {
    const auto [place, is_new] = hardest.emplace(to_json(each.pair), each);
    if (!is_new && each.speed > place->second.speed) place->second = each;
  }
  const auto add = [&all](const std::string& line) {
    if (!line.empty() && std::find(all.begin(), all.end(), line) == all.end()) all.push_back(line);
  };
  for (const auto& [key, each] : hardest) {
    const std::string whose = "contact " + std::to_string(each.contact) + " is pressed as hard as by";
    add(yield_warning(each.pair, each.speed, whose));
    for (const std::string& line : sound_warnings(each.pair)) add(line);
  }
  return all;
}

}  // namespace stoss
