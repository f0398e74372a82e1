// A body that does not fit together, and a start that contradicts the call, are refused before anything moves.
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/impact/impact.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(BodyRefusal, NamesTheBodyAndTheRule) {
  const std::vector<std::pair<const char*, std::function<void(Body&)>>> flaws = {
      {"mass", [](Body& body) { body.mass = 0.0; }},
      {"mass", [](Body& body) { body.mass = not_a_number; }},
      {"extent", [](Body& body) { body.extent = -1.0; }},
      {"cutoff", [](Body& body) { body.cutoff = std::numeric_limits<double>::infinity(); }},
      {"highest", [](Body& body) { body.highest_cutoff = 39.0; }},
      {"scale", [](Body& body) { body.scale.length = 0.0; }},
      {"scale", [](Body& body) { body.scale.mass = not_a_number; }},
      {"one length", [](Body& body) { body.groups[0].upper.pop_back(); }},
      {"finite weights", [](Body& body) { body.groups[0].lower[0] = not_a_number; }},
      {"frequencies", [](Body& body) { body.groups[0].omega[0] = 0.0; }},
      {"frequencies", [](Body& body) { body.groups[0].omega[0] = 1e9; }},
      {"functions", [](Body& body) { body.surface = nullptr; }},
      {"functions", [](Body& body) { body.residual_compliance = nullptr; }},
      {"functions", [](Body& body) { body.residual_second_moment = nullptr; }},
      {"stable_step", [](Body& body) { body.stable_step = 0.0; }},
      {"sampling", [](Body& body) { body.sampling.points = 0.0; }},
      {"sampling", [](Body& body) { body.sampling.cutoff = not_a_number; }},
      {"sampling", [](Body& body) { body.sampling.power = not_a_number; }},
      {"sampling", [](Body& body) { body.sampling.along_edge = -1.0; }},
      {"sampling", [](Body& body) { body.sampling.fewest = 0; }},
  };
  for (const auto& [rule, spoil] : flaws) {
    Body body = rod(40.0);
    spoil(body);
    test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1); }, {"body: got 'rod'", rule});
  }
}

TEST(BodyRefusal, OfASurfaceOrAComplianceOfTheWrongSize) {
  Body body = rod(40.0);
  body.surface = [](const ContactPoints&) { return Surface{{0.0}, {1.0}, {1.0}, {}}; };
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1); }, {"body", "surface"});
  for (const Tail tail : {Tail::radiating, Tail::quasistatic}) {
    body = rod(40.0);
    body.residual_compliance = [](const ContactPoints&, const Poll&) { return std::vector<double>(4, 1.0); };
    test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.resolution = {.tail = tail}}); },
                         {"body", "residual"});
  }
  body = rod(40.0);
  body.residual_second_moment = [](const ContactPoints&, const Poll&) { return std::vector<double>{}; };
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1); }, {"body", "residual"});
}

TEST(BodyRefusal, OfWhatHasNoEndAsARigidBody) {
  test::expect_refusal([] { (void)rigid(half_space({})); }, {"rigid: got 'half-space", "a size and a mass"});
  test::expect_refusal([] { (void)rigid(half_plane({})(1e-6, {})); }, {"rigid: got 'half-plane"});
}

TEST(StartRefusal, OfAVelocityThatIsNotTheSpeed) {
  const Body body = rod(40.0);
  const std::vector<double> rest(mode_count(body), 0.0);
  const State start{-1.0, 0.2, rest, rest};
  test::expect_refusal([&] { (void)impact(body, HardWall{}, 0.1, {.start = start}); }, {"start", "0.2", "0.1"});
  EXPECT_NO_THROW((void)impact(body, HardWall{}, 0.2, {.start = start}));
}

}  // namespace
}  // namespace stoss
