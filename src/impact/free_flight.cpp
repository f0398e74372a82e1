#include "impact/free_flight.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "contact/contact_cache.hpp"
#include "contact/demands.hpp"
#include "contact/ending.hpp"
#include "impact/recommended.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

double time_to_part(KeptModes modes, const std::vector<double>& recess, const Parting& parting) {
  constexpr double most = 1000.0, most_of_modes = 1e7;  // looks, and those times modes: some ten milliseconds
  const double most_looks = std::min(most, most_of_modes / std::max(1.0, static_cast<double>(modes.count())));
  const auto [compression, velocity, range] = parting;
  const double step = modes.step();
  const double longest = std::max(0.0, (compression + range + modes.reach()) / -velocity);
  if (!(longest < most_looks * step)) return longest;
  const double between = 0.125 * step * step * modes.greatest_acceleration();
  std::vector<double> place(recess.size());
  double time = 0.0;
  for (long look = 0; static_cast<double>(look) * step < longest; ++look) {
    const double now = static_cast<double>(look) * step;
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = -recess[i];
    modes.add_displacement(place);
    const double foremost = *std::max_element(place.begin(), place.end());
    if (compression + velocity * now + foremost + between + range >= 0.0) time = now + step;
    modes.advance();
  }
  return std::min(time, longest);
}

double time_before_touch(const Contact& contact, const State& touch) {
  const double speed = touch.velocity;
  if (!ending(contact).foreseen) return clearance(contact, touch) / speed;
  constexpr double between_looks = 2.0;  // over 1/cutoff
  constexpr double margin = 0.05;        // of the reach, for what lies between the points
  constexpr int points = 32;
  const double half_width = has_single_point(contact) ? 0.0 : initial_half_width(contact, speed);
  const ContactGrid grid = contact_grid(contact, half_width, has_single_point(contact) ? 1 : points);
  State back = touch;
  for (double& momentum : back.momentum) momentum = -momentum;
  KeptModes modes(mode_tables(contact, grid, between_looks / contact.cutoff, Kicks::whole));
  modes.set(back.coordinate, back.momentum);
  const double range = force_free_distance(contact, margin * modes.reach(), speed, half_width);
  return time_to_part(std::move(modes), grid.recess, {0.0, -speed, range});
}

}  // namespace stoss
