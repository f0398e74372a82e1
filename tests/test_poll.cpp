// Whatever takes long polls, in its set-up too, and what the poll throws ends it.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>

#include "contact/response.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/disk/field.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/contact/wall.hpp"
#include "stoss/impact/impact.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/quasistatic.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/body_tools.hpp"
#include "support/complementarity.hpp"

namespace stoss {
using namespace bodies::disk;
using namespace quasistatic;

namespace {

struct Enough {};

const Body& body() {
  static const Body made = disk(0.33, 12.0);
  return made;
}

const ContactGrid& grid() {
  static const ContactGrid made = test::grid_of(body(), 0.5, 200);
  return made;
}

const Impact& hit() {
  static const Impact made = impact(body(), HardWall{}, 0.1);
  return made;
}

struct Job {
  int least;  ///< calls that it makes
  std::function<void(const Poll&)> run;
};

const std::map<std::string, Job>& jobs() {
  static const std::vector<double> force(200, 0.0), coordinate(mode_count(body()), 0.0);
  static const PolarGrid points{std::vector<double>(100, 0.5), {0.0}};
  static const std::vector<Mode> modes = bodies::disk::modes(0.33, 12.0);
  static const std::map<std::string, Job> all{
      {"modes", {24, [](const Poll& poll) { (void)bodies::disk::modes(0.33, 12.0, poll); }}},
      {"displacement", {100, [](const Poll& poll) { (void)displacement(0.33, modes[0], points.radius, poll); }}},
      {"disk", {24, [](const Poll& poll) { (void)disk(0.33, 12.0, poll); }}},
      {"W", {25, [](const Poll& poll) { (void)body().residual_compliance(grid().points, poll); }}},
      {"V", {100, [](const Poll& poll) { (void)body().residual_second_moment(grid().points, poll); }}},
      {"inverse",
       {14, [](const Poll& poll) { (void)Complementarity(body().residual_compliance(grid().points, {}), 200, poll); }}},
      {"static tail",
       {40,
        [](const Poll& poll) { (void)make_response(contact(body()), Tail::quasistatic, grid(), 0.1, 0.01, poll); }}},
      {"radiating tail",
       {150, [](const Poll& poll) { (void)make_response(contact(body()), Tail::radiating, grid(), 0.1, 0.01, poll); }}},
      {"impact", {400, [](const Poll& poll) { (void)impact(body(), HardWall{}, 0.1, {.poll = poll}); }}},
      {"motion",
       {5000, [](const Poll& poll) { (void)frames_at(contact(body()), hit(), std::vector<double>(5000, 1e3), poll); }}},
      {"restitution",
       {400, [](const Poll& poll) { (void)restitution(disk(0.33), 0.1, {.tolerance = 1e-2, .poll = poll}); }}},
      {"points of a field",
       {1000, [](const Poll& poll) { (void)DiskField(0.33, body(), grid().points, points, poll); }}},
      {"field",
       {100,
        [](const Poll& poll) { (void)DiskField(0.33, body(), grid().points, points).at(coordinate, force, poll); }}},
      {"static contact", {60, [](const Poll& poll) { (void)static_contact(0.33, 0.01, {.poll = poll}); }}},
      {"rayleigh", {60, [](const Poll& poll) { (void)rayleigh(CompressionLaw::center, 0.33, 1e-3, modes, poll); }}},
  };
  return all;
}

TEST(Poll, IsCalledAndMayEndEverything) {
  for (const auto& [name, job] : jobs()) {
    int calls = 0;
    job.run([&calls] { ++calls; });
    EXPECT_GE(calls, job.least) << name;
    for (const int last : {1, calls / 2, calls}) {
      int count = 0;
      const auto poll = [&count, last] {
        if (++count == last) throw Enough{};
      };
      EXPECT_THROW(job.run(poll), Enough) << name << ", call " << last;
      EXPECT_EQ(count, last) << name;
    }
  }
}

TEST(Poll, ChangesNothing) {
  const Impact polled = impact(body(), HardWall{}, 0.1, {.poll = [] {}});
  EXPECT_EQ(polled.restitution, hit().restitution);
  EXPECT_EQ(polled.steps, hit().steps);
}

}  // namespace
}  // namespace stoss
