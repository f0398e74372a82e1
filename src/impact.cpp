#include "stoss/impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "check.hpp"
#include "collision.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double max_contact_time = 200.0;  // R/c; an impact lasts 5 to 30
constexpr double most_steps = 5e7;
constexpr double max_energy_error = 1e-2;   // beyond, the motion is not resolved in time and means nothing
constexpr double small_strain_limit = 0.5;  // compression, R

/// The grid must cover the contact with room to spare, and with a soft wall the gap in which it still pushes.
double initial_half_width(const Body& body, const Wall& wall, double speed) {
  constexpr double margin = 1.25;
  const double contact = margin * body.expected_half_width(speed);
  const auto* soft = std::get_if<ExponentialWall>(&wall);
  const double gap = soft == nullptr ? 0.0 : 30.0 / soft->hardness;
  return std::min(std::sqrt(contact * contact + 2.0 * gap), body.max_half_width);
}

void require_start(const State& start, double speed) {
  if (start.velocity != speed) {
    throw InvalidInput("start: got velocity " + std::to_string(start.velocity) + ", allowed the speed of the impact, " +
                       std::to_string(speed) + " (it is given twice)");
  }
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!finite(start.center) || !std::all_of(start.coordinate.begin(), start.coordinate.end(), finite) ||
      !std::all_of(start.momentum.begin(), start.momentum.end(), finite)) {
    throw InvalidInput(
        "start: got a center, coordinate or momentum that is no finite number, allowed finite ones (nan?)");
  }
}

void require_options(const Body& body, double speed, const ImpactOptions& options) {
  if (options.start) require_start(*options.start, speed);
  const double longest = 1.0 / body.cutoff;
  if (options.step) {
    require("step", *options.step, {1e-9, longest, true, true, "1e-9 to 1/cutoff"},
            "time step in R/c; 0.25/cutoff is usual");
  }
  if (options.nodes) {
    const long fewest = body.max_half_width > 0.0 ? 16 : 1;
    require("nodes", static_cast<long>(*options.nodes), fewest, 4096, "contact nodes; 64 to 256 are usual");
  }
  require("observe_every", static_cast<long>(options.observe_every), 1, 1'000'000'000,
          "steps between two calls of the observer");
}

void require_grid(const Body& body, const ContactGrid& grid) {
  const std::size_t nodes = grid.recess.size();
  const std::size_t shapes = nodes * body.groups.size();
  if (nodes == 0 || grid.coordinate.size() != nodes || grid.measure.size() != nodes || grid.impedance.size() != nodes ||
      grid.radial_shape.size() != shapes || grid.tangential_shape.size() != shapes) {
    throw InvalidInput("body: got a grid of '" + body.name +
                       "' whose arrays do not fit, allowed: one value per node, "
                       "and per node and group");
  }
}

struct Resolution {
  double half_width;
  double step;
  int nodes;
};

/// One run; empty if the contact outgrew the grid.
std::optional<Impact> run(const Body& body, const Wall& wall, double speed, const Resolution& resolution,
                          const ImpactOptions& options, const ImpactObserver& observer) {
  const ContactGrid grid = body.grid(resolution.half_width, resolution.nodes);
  require_grid(body, grid);
  Collision collision(body, wall, grid, speed, resolution.step, options.start);
  const double duration = max_contact_time + 4.0 * collision.clearance() / speed;
  const double steps = duration / resolution.step;
  if (steps > most_steps) {
    throw NotConverged("impact: would take more than " + std::to_string(static_cast<long>(most_steps)) +
                       " steps (use a larger step, or a hard wall instead of an exponential one)");
  }
  const auto observe = [&] {
    Snapshot now = collision.snapshot();
    State state;
    if (options.observe_modes) {
      state = collision.state();
      now.coordinate = state.coordinate;
      now.momentum = state.momentum;
    }
    observer(now);
  };
  if (observer) observe();
  for (long step = 1; !collision.over(); ++step) {
    if (static_cast<double>(step) > steps) {
      throw NotConverged("impact: the body has not left the wall after " + std::to_string(step) + " steps");
    }
    collision.advance();
    if (collision.overflows()) return std::nullopt;
    if (observer && (step % options.observe_every == 0 || collision.over())) observe();
  }
  return collision.result();
}

}  // namespace

double recommended_step(const Body& body, const Wall& wall, double speed) {
  if (const auto* soft = std::get_if<ExponentialWall>(&wall)) {
    // The edge layer on the soft wall oscillates at about √(α v ω_c), and what first touches it bounces within 1/(α v).
    const double bounce = soft->hardness * speed;
    return 0.25 / std::sqrt(body.cutoff * (body.cutoff + bounce) + 0.5 * bounce * bounce);
  }
  if (std::get<HardWall>(wall).tail == Tail::radiating) return 0.25 / (body.cutoff * (1.0 + speed));
  // Without damping, the nodes at the edge of the contact bounce the more the faster it spreads.
  return 0.2 / (body.cutoff * (1.0 + 16.0 * speed));
}

int recommended_nodes(const Body& body, const Wall& wall, double speed) {
  if (body.max_half_width == 0.0) return 1;
  if (const auto* soft = std::get_if<ExponentialWall>(&wall)) {
    const double half_width = initial_half_width(body, wall, speed);
    return static_cast<int>(std::clamp(std::ceil(soft->hardness * half_width * half_width), 128.0, 4096.0));
  }
  return 64;
}

Impact impact(const Body& body, const Wall& wall, double speed, const ImpactOptions& options,
              const ImpactObserver& observer) {
  require("speed", speed, {1e-8, 1.0, true, true, "1e-8 to 1"}, "speed of the centre of mass, in units of c");
  validate(body);
  validate(wall);
  require_options(body, speed, options);

  Resolution resolution{initial_half_width(body, wall, speed),
                        options.step ? *options.step : recommended_step(body, wall, speed),
                        options.nodes ? *options.nodes : recommended_nodes(body, wall, speed)};

  std::optional<Impact> result = run(body, wall, speed, resolution, options, {});
  while (!result) {
    if (resolution.half_width >= body.max_half_width) {
      throw NotConverged("impact: the contact spreads over the whole body (speed too high for this model)");
    }
    constexpr double growth = 1.4;
    resolution.half_width = std::min(growth * resolution.half_width, body.max_half_width);
    result = run(body, wall, speed, resolution, options, {});
  }
  // The observer must see one impact only, so it watches a repetition on the grid that is known to suffice.
  if (observer) result = run(body, wall, speed, resolution, options, observer);

  if (!(std::abs(result->energy_error) <= max_energy_error)) {
    throw NotConverged("impact: " + std::to_string(result->energy_error) +
                       " of the energy is unaccounted for (use a smaller step)");
  }
  result->body = body.name;
  result->wall = wall;
  result->cutoff = body.cutoff;
  result->step = resolution.step;
  result->nodes = resolution.nodes;
  result->beyond_small_strain = speed > small_strain_speed || result->max_compression > small_strain_limit;
  return *result;
}

}  // namespace stoss
