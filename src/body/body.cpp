#include "stoss/body/body.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require(const Body& body, bool condition, const std::string& rule) {
  if (!condition) throw InvalidInput::out_of_range("body", "'" + body.name + "'", "only a body with " + rule);
}

bool positive(double x) { return std::isfinite(x) && x > 0.0; }

bool not_negative(double x) { return std::isfinite(x) && x >= 0.0; }

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

void validate(const Body& body) {
  require(body, positive(body.scale.length) && positive(body.scale.speed) && positive(body.scale.mass),
          "a positive finite scale");
  require(body, positive(body.mass) && positive(body.cutoff), "a positive finite mass and cutoff");
  require(body, not_negative(body.extent) && not_negative(body.curvature) && not_negative(body.softness),
          "a finite extent, curvature and softness, none below 0");
  require(body, not_negative(body.inertia) && body.components > 0, "a finite inertia of 0 or more, and components");
  require(body, not_negative(body.mass_along), "a finite mass along its surface, or 0");
  require(body, body.highest_cutoff >= body.cutoff, "a cutoff up to its highest");
  require(body, std::isfinite(body.loss_time) && body.loss_time >= 0.0, "a loss_time of 0 or more");
  require(body, body.loss_time == 0.0 || body.relaxation.terms.empty(), "a loss_time or a relaxation, not both");
  for (const MaterialLoss& layer : body.layers) validate(layer);
  require(body, body.stable_step > 0.0, "a positive stable_step");
  const auto& [points, cutoff, power, along_edge, fewest] = body.sampling;
  require(body, positive(points) && positive(cutoff) && finite({power, along_edge}) && along_edge >= 0.0 && fewest > 0,
          "a positive finite sampling");
  require(body, body.part.size > 0.0 && body.part.mass_not_modelled >= 0.0 && body.part.echo > 0.0,
          "part.size and part.echo above 0, part.mass_not_modelled of 0 or more");
  const double highest = kept_cutoff(body);
  for (const ModeGroup& group : body.groups) {
    require(body, group.upper.size() == group.omega.size() && group.lower.size() == group.omega.size(),
            "omega, upper and lower of one length in each group");
    require(body, group.index.empty() || group.index.size() == group.omega.size(), "as many indices as modes, or none");
    require(body, finite(group.upper) && finite(group.lower), "finite weights");
    require(body, group.moduli.size() == group.omega.size() * body.layers.size(), "moduli of each mode in each layer");
    require(body, std::all_of(group.moduli.begin(), group.moduli.end(), not_negative), "finite moduli of 0 or more");
    require(body,
            std::all_of(group.omega.begin(), group.omega.end(),
                        [highest](double omega) { return omega > 0.0 && omega <= highest; }),
            "frequencies above 0 and up to its cutoff, or kept_cutoff of a lossy one");
  }
  require(body, body.surface && body.residual_compliance && body.residual_second_moment, "all three functions set");
}

double pressure(Contour contour, const Load& load) {
  const double a = load.half_width;
  return load.force / (contour == Contour::ball ? std::numbers::pi * a * a : 2.0 * a);
}

double kept_cutoff(double cutoff, double loss_time) {
  return loss_time * cutoff > 1.0 ? std::sqrt(cutoff / loss_time) : cutoff;
}

double kept_cutoff(const Body& body) { return kept_cutoff(body.cutoff, longest_loss_time(body)); }

bool loses(const Body& body) {
  const auto its = [](double loss_time, const Relaxation& relaxation) {
    return loss_time > 0.0 || !relaxation.terms.empty();
  };
  return its(body.loss_time, body.relaxation) ||
         std::any_of(body.layers.begin(), body.layers.end(),
                     [&](const MaterialLoss& layer) { return its(layer.loss_time, layer.relaxation); });
}

double longest_loss_time(const Body& body) {
  double longest = body.loss_time;
  for (const MaterialLoss& layer : body.layers) longest = std::max(longest, layer.loss_time);
  return longest;
}

double opposite_share(const Body& body, const ModeGroup& group, std::size_t index) {
  // A rod has its modes in one group, the first of which moves both ends outward, as the order 0 of round bodies does.
  const int turns = body.contour == Contour::flat ? static_cast<int>(index) : group.order;
  return turns % 2 == 0 ? 1.0 : -1.0;
}

std::size_t mode_count(const Body& body) {
  std::size_t count = 0;
  for (const ModeGroup& group : body.groups) count += group.omega.size();
  return count;
}

double whole_mass(const Body& body) { return body.mass + body.part.mass_not_modelled; }

bool is_unbounded(const Body& body) { return std::isinf(body.part.mass_not_modelled); }

bool is_known_at_a_point(const Body& body) { return std::isfinite(body.known.max_cutoff_times_width); }

bool is_whole(const Body& body) { return body.part.size >= 1.0 && !is_unbounded(body); }

Body rigid(const Body& body) {
  if (is_unbounded(body)) {
    throw InvalidInput::out_of_range("rigid", "'" + body.name + "'", "a body with a size and a mass",
                                     "what is rigid without end is a hard wall");
  }
  Body result = body;
  result.name = "rigid " + body.name;
  result.softness = result.loss_time = 0.0;
  result.relaxation = {};
  result.layers.clear();
  result.highest_cutoff = result.stable_step = std::numeric_limits<double>::infinity();
  result.groups.clear();
  result.near_side = nullptr;
  result.surface = [surface = body.surface](const ContactPoints& points) {
    Surface same = surface(points);
    std::fill(same.impedance.begin(), same.impedance.end(), std::numeric_limits<double>::infinity());
    same.shape.clear();
    return same;
  };
  result.residual_compliance =
      result.residual_second_moment = [values = body.components](const ContactPoints& points, const Poll&) {
        return std::vector<double>(values * points.count * values * points.count);
      };
  if (body.opposite_compliance) {
    result.opposite_compliance = [](const ContactPoints& here, const ContactPoints& there) {
      return std::vector<double>(here.count * there.count);
    };
  }
  if (body.along) {
    result.along = [along = body.along](const Poll& poll) {
      std::vector<Body> bodies;
      for (const Body& each : along(poll)) bodies.push_back(rigid(each));
      return bodies;
    };
  }
  if (body.outward) result.outward = [outward = body.outward](const Poll& poll) { return rigid(outward(poll)); };
  return result;
}

BodyMaker rigid(const BodyMaker& maker) {
  constexpr double without_modes = 1e-6;
  return [made = rigid(maker(without_modes, {}))](double cutoff, const Poll&) {
    Body body = made;
    body.cutoff = cutoff;
    if (made.outward) {
      body.outward = [outward = made.outward, cutoff](const Poll& poll) {
        Body same = outward(poll);
        same.cutoff = cutoff;
        return same;
      };
    }
    if (!made.along) return body;
    body.along = [along = made.along, cutoff](const Poll& poll) {
      std::vector<Body> bodies = along(poll);
      for (Body& each : bodies) each.cutoff = cutoff;
      return bodies;
    };
    return body;
  };
}

Body with_modes(const Body& body, const std::vector<bool>& keep) {
  const std::size_t all = mode_count(body);
  const auto kept = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), true));
  if (keep.size() != all || kept == 0) {
    throw InvalidInput::out_of_range(
        "keep", std::to_string(kept) + " of " + std::to_string(keep.size()) + " modes",
        "1 to " + std::to_string(all) + " of the " + std::to_string(all) + " of '" + body.name + "'",
        "one flag for each mode up to the cutoff");
  }
  if (kept == all) return body;

  Body result = body;
  result.groups.clear();
  std::size_t mode = 0;
  for (const ModeGroup& from : body.groups) {
    ModeGroup to{from.order, {}, {}, {}, from.upper_row, from.lower_row, {}, from.wave_number};
    for (std::size_t l = 0; l < from.omega.size(); ++l) {
      if (!keep[mode++]) continue;
      to.omega.push_back(from.omega[l]);
      to.upper.push_back(from.upper[l]);
      to.lower.push_back(from.lower[l]);
      to.index.push_back(from.index.empty() ? static_cast<int>(l) : from.index[l]);
      const auto moduli = from.moduli.begin() + static_cast<std::ptrdiff_t>(l * body.layers.size());
      to.moduli.insert(to.moduli.end(), moduli, moduli + static_cast<std::ptrdiff_t>(body.layers.size()));
    }
    if (!to.omega.empty()) result.groups.push_back(std::move(to));
  }
  result.name += ", " + std::to_string(kept) + " of " + std::to_string(all) + " modes";
  const auto refuse = [name = result.name](const ContactPoints&, const Poll&) -> std::vector<double> {
    throw InvalidInput::out_of_range("body", "'" + name + "' at a hard wall",
                                     "only one with all modes up to its cutoff", "use an exponential wall");
  };
  result.residual_compliance = refuse;
  result.residual_second_moment = refuse;
  return result;
}

}  // namespace stoss
