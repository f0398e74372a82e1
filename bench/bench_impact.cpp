#include <sstream>
#include <vector>

#include "common.hpp"
#include "contact/response.hpp"
#include "impact/recommended.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/impact/impact.hpp"

namespace bench {
namespace {

constexpr double half_width_of_contact = 0.464;  // maximum, R

std::string with_cutoff(const std::string& name, double cutoff) {
  std::ostringstream text;
  text << name << ", cutoff " << cutoff;
  return text.str();
}

void add_set_up(double cutoff) {
  add(with_cutoff("grid and compliance", cutoff), [cutoff](benchmark::State& state) {
    const stoss::Contact contact = stoss::contact(disk_body(cutoff));
    const double half_width = 1.25 * stoss::expected_half_width(contact, speed);
    const int nodes = stoss::fixed_resolution(contact, speed).nodes;
    for (auto _ : state) {
      const stoss::ContactGrid grid = stoss::contact_grid(contact, half_width, nodes);
      const std::vector<double> compliance = stoss::residual_compliance(contact, grid);
      benchmark::DoNotOptimize(compliance.data());
    }
  });
  // In addition, what the hard wall does once: W′ and its factor.
  add(with_cutoff("grid, compliance and hard wall", cutoff), [cutoff](benchmark::State& state) {
    stoss::Contact contact = stoss::contact(disk_body(cutoff));
    contact.cache = nullptr;  // made anew each time
    const double half_width = 1.25 * stoss::expected_half_width(contact, speed);
    const int nodes = stoss::fixed_resolution(contact, speed).nodes;
    for (auto _ : state) {
      const stoss::ContactGrid grid = stoss::contact_grid(contact, half_width, nodes);
      benchmark::DoNotOptimize(stoss::make_response(contact, stoss::Tail::radiating, grid, speed, 0.5 / cutoff));
    }
  });
}

void add_impact(const std::string& name, const stoss::Wall& wall, double cutoff, double cutoff_times_step,
                stoss::Tail tail = stoss::Tail::radiating) {
  add(with_cutoff(name, cutoff), [=](benchmark::State& state) {
    const stoss::Body& body = disk_body(cutoff);
    stoss::ImpactOptions options;
    options.resolution.tail = tail;
    options.resolution.step = cutoff_times_step > 0.0
                                  ? cutoff_times_step / cutoff
                                  : stoss::fixed_resolution(stoss::contact(body, wall), speed, options.resolution).step;
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = stoss::impact(body, wall, speed, options).lost_fraction;
    count(state, lost_fraction);
  });
}

/// One impact as `restitution` resolves it: how the cost grows with the cutoff.
void add_refined(double cutoff) {
  add(with_cutoff("hard wall, as restitution resolves it", cutoff), [cutoff](benchmark::State& state) {
    stoss::Contact contact = stoss::contact(disk_body(cutoff));
    contact.cache = nullptr;  // made anew each time
    const stoss::ImpactOptions options{.resolution = stoss::refined_resolution(contact, speed, half_width_of_contact)};
    double lost_fraction = 0.0;
    for (auto _ : state) lost_fraction = stoss::impact(contact, speed, options).lost_fraction;
    count(state, lost_fraction);
  });
}

}  // namespace

void add_impacts() {
  const double cutoffs[] = {25.0, 50.0, 100.0};
  for (const double cutoff : cutoffs) add_set_up(cutoff);
  for (const double cutoff : cutoffs) {
    add_impact("hard wall, radiating", stoss::HardWall{}, cutoff, 0.5);
  }
  for (const double cutoff : cutoffs) {
    add_impact("hard wall, radiating, half the step", stoss::HardWall{}, cutoff, 0.25);
  }
  for (const double cutoff : cutoffs) {
    add_impact("hard wall, static", stoss::HardWall{}, cutoff, 0.5, stoss::Tail::quasistatic);
  }
  for (const double cutoff : cutoffs) {
    add_impact("exponential wall, αR = 500", stoss::ExponentialWall{}, cutoff, 0.0);
  }
  for (const double cutoff : {16.0, 32.0, 64.0, 128.0, 256.0}) add_refined(cutoff);
}

}  // namespace bench
