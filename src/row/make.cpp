// The bodies and contacts of a row, each contact that of a pair.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "check.hpp"
#include "contact/unit_ratios.hpp"
#include "impact/recommended.hpp"
#include "row/motion.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr int most_bodies = 100;

void require_row(const Row& row, const std::vector<double>& speeds) {
  const auto count = row.bodies.size();
  const int fewest = row.wall_before && row.wall_after ? 1 : 2;
  require("bodies", static_cast<long>(count), fewest, most_bodies, "of a row, or one between two walls");
  for (const std::size_t each : row.bodies) {
    require("bodies", static_cast<long>(each), 0, static_cast<long>(row.kinds.size()) - 1, "number of a kind");
  }
  if (speeds.size() != count) {
    throw InvalidInput::out_of_range("speed", std::to_string(speeds.size()) + " values", std::to_string(count),
                                     "one for each body of the row, to the right");
  }
  const Range speed{-1.0, 1.0, true, true, "-1 to 1"};
  for (const double each : speeds) require("speed", each, speed, "in c of the first body, to the right");
  const std::size_t gaps = count - 1 + (row.wall_before ? 1 : 0) + (row.wall_after ? 1 : 0);
  if (!row.gaps.empty() && row.gaps.size() != gaps) {
    throw InvalidInput::out_of_range("gaps", std::to_string(row.gaps.size()) + " values", std::to_string(gaps),
                                     "one for each pair of neighbours, walls included, from left to right");
  }
  const Range gap{0.0, 1e3, true, true, "0 to 1000"};
  for (const double each : row.gaps) require("gap", each, gap, "in R of the first body");
}

/// The greatest speed at which two bodies, or a body and a wall, can meet at first.
double fastest_approach(const Row& row, const std::vector<double>& speeds) {
  std::vector<double> all = speeds;
  if (row.wall_before) all.insert(all.begin(), 0.0);
  if (row.wall_after) all.push_back(0.0);
  double fastest = 0.0, highest = all.front();
  for (const double each : all) {
    fastest = std::max(fastest, highest - each);
    highest = std::max(highest, each);
  }
  constexpr double least = 1e-8;
  if (fastest >= least) return fastest;
  throw InvalidInput::out_of_range("speed", "no two bodies that meet by 1e-8 c or more",
                                   "a body that is faster than one on its right", "speeds are to the right");
}

Body made_body(const BodyMaker& maker, double cutoff, double duration, const Body& first, const Poll& poll) {
  if (!maker) throw InvalidInput::out_of_range("row", "no function that makes a body", "one, such as sphere(poisson)");
  constexpr double few = 1e-3;
  const UnitRatios units(maker(few, poll), first);
  Body body = maker(cutoff * units.time, poll);
  if (is_unbounded(body) && body.near_side) body = body.near_side(duration / units.time, cutoff * units.time, poll);
  return body;
}

}  // namespace

MadeRow made_row(const Row& row, const std::vector<double>& speeds, double cutoff, const Poll& poll, double longer) {
  require_row(row, speeds);
  MadeRow made;
  made.fastest = fastest_approach(row, speeds);
  made.vibration = row.vibration;
  std::vector<std::shared_ptr<const Body>> kinds(row.kinds.size());
  const std::size_t first_kind = row.bodies.front();
  const auto first = kinds[first_kind] = std::make_shared<const Body>(row.kinds[first_kind](cutoff, poll));
  if (is_unbounded(*first)) {
    throw InvalidInput::out_of_range("row", "'" + short_name(*first) + "' as the first body",
                                     "one that moves; what stands is the last", "turn the row around");
  }
  // A half-space is made for so long: a contact lasts longer on one that is softer, and each body adds half of one.
  constexpr double times = 1.5;
  const double lasts = longer * times * (0.5 + 0.5 * static_cast<double>(row.bodies.size())) *
                       expected_duration(contact(first), std::min(1.0, made.fastest));
  for (const std::size_t kind : row.bodies) {
    auto& body = kinds[kind];
    if (body == nullptr) body = std::make_shared<const Body>(made_body(row.kinds[kind], cutoff, lasts, *first, poll));
    made.bodies.push_back(body);
    made.units.emplace_back(*body, *first);
    made.known = std::min(made.known, body->part.echo * made.units.back().time);
  }
  std::map<std::pair<const Body*, const Body*>, std::shared_ptr<const Contact>> contacts;
  const auto add = [&](std::size_t one, std::optional<std::size_t> other, Face face, double gap) {
    const auto& body = made.bodies[one];
    const auto met = other ? made.bodies[*other] : nullptr;
    auto& its = contacts[{body.get(), met.get()}];
    if (its == nullptr) its = std::make_shared<const Contact>(met == nullptr ? contact(body) : contact(body, met));
    const UnitRatios& units = made.units[one];
    const double speed = std::min(1.0, made.fastest * units.time / units.length);
    const FixedResolution resolution = fixed_resolution(*its, speed, refined_resolution(*its, speed, 0.0));
    const double step = resolution.step * units.time;
    made.step = made.joints.empty() ? step : std::min(made.step, step);
    made.joints.push_back({its, static_cast<int>(one), other ? static_cast<int>(*other) : -1, face, gap / units.length,
                           resolution, speed, expected_duration(*its, speed)});
  };
  std::size_t next = 0;
  const auto gap = [&] { return row.gaps.empty() ? 0.0 : row.gaps[next++]; };
  const std::size_t last = row.bodies.size() - 1;
  if (row.wall_before) add(0, std::nullopt, Face::left, gap());
  for (std::size_t b = 0; b < last; ++b) add(b, b + 1, Face::right, gap());
  if (row.wall_after) add(last, std::nullopt, Face::right, gap());
  for (MadeRow::Joint& joint : made.joints) {
    joint.resolution.step = made.step / made.units[static_cast<std::size_t>(joint.one)].time;
  }
  return made;
}

}  // namespace stoss
