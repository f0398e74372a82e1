// Laws of slow impacts against values computed directly.
#include "stoss/table/slow_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "stoss/encounter/solid.hpp"
#include "stoss/relaxation/constant_quality.hpp"
#include "stoss/restitution/curve.hpp"
#include "support/refusal.hpp"

namespace stoss {
namespace {

struct LawCase {
  std::string name;
  RefinableContact contact;
  SlowLaw law;
};

void PrintTo(const LawCase& each, std::ostream* stream) { *stream << each.name; }

std::vector<LawCase> cases() {
  std::vector<LawCase> all;
  const auto named = [](const char* what, double poisson, double loss_time) {
    return std::string(what) + "_" + std::to_string(std::lround(100.0 * std::abs(poisson))) +
           (poisson < 0.0 ? "_below_0" : "") + "_lossy_" + std::to_string(std::lround(100.0 * loss_time));
  };
  for (const double poisson : {-0.5, 0.0, 0.3, 0.49}) {
    for (const double loss_time : {0.0, 0.01, 0.5}) {
      const Sphere ball{.poisson = poisson, .loss_time = loss_time};
      all.push_back({named("sphere", poisson, loss_time), RefinableContact(sphere(ball)), slow_law(ball)});
      const Disk plate{.poisson = poisson, .loss_time = loss_time};
      all.push_back({named("disk", poisson, loss_time), RefinableContact(disk(plate)), slow_law(plate)});
    }
  }
  // In units of the first, whose size is not 1.
  const Sphere large{.poisson = 0.2, .radius = 2.0, .young = 9.0, .density = 4.0, .loss_time = 0.4};
  all.push_back({"two_spheres", RefinableContact(sphere(large), sphere(large)), slow_law(large, large)});
  // Materials that relax: of one quality, and with terms about the time of contact.
  const Relaxation even = constant_quality(20.0, lowest_of_body, highest_of_body), terms{{{0.1, 1.0}, {0.05, 60.0}}};
  for (const auto& [name, relaxation] : {std::pair{"quality", even}, std::pair{"terms", terms}}) {
    const Sphere round{.poisson = 0.3};
    all.push_back({std::string("sphere_of_") + name, RefinableContact(maker(Solid(round), relaxation)),
                   slow_law(round, relaxation)});
  }
  const Sphere other{.poisson = 0.2, .radius = 2.0, .young = 9.0, .density = 4.0};
  const BodyMaker its = maker(Solid(other), terms);
  all.push_back({"two_spheres_that_relax", RefinableContact(its, its), slow_law(other, other, terms)});
  const Disk wide{.poisson = 0.33, .radius = 2.0, .young = 9.0, .density = 4.0};
  all.push_back({"two_disks", RefinableContact(disk(wide), disk(wide)), slow_law(wide, wide)});
  const Sphere ball{.poisson = 0.3, .radius = 3.0, .young = 2.0};
  for (const double young : {0.5, 20.0}) {
    const HalfSpace block{.poisson = 0.2, .young = young, .density = 1.5};
    const std::string name = "half_space_" + std::to_string(std::lround(10.0 * young));
    all.push_back({name, RefinableContact(sphere(ball), half_space(block)), slow_law(ball, block)});
    all.push_back(
        {"rigid_on_" + name, RefinableContact(rigid(sphere(ball)), half_space(block)), slow_law(ball, block, true)});
  }
  return all;
}

class Laws : public testing::TestWithParam<LawCase> {};

TEST_P(Laws, HoldWithinTheirErrors) {
  const auto& [name, contact, law] = GetParam();
  for (const double speed : {1e-6, 1e-5, 1e-4, 1e-3, 0.005, 0.02}) {
    const auto& [value, error] = law(speed);
    const CurveOptions options{
        .each = {.tolerance = 1e-3, .absolute = 0.1 * error}};  // as accurate as can be told apart
    const Estimate found = restitution_curve(contact, {speed}, options).front().restitution;
    EXPECT_LE(std::abs(value - found.value), error + found.error) << name << ", v = " << speed;
    EXPECT_GE(error, 0.0);
    if (speed <= 1e-3) {
      EXPECT_LT(error, 0.2) << name << ", v = " << speed;
    }
  }
  EXPECT_EQ(law(0.0).value, 1.0);
  EXPECT_EQ(law(0.0).error, 0.0);
  EXPECT_LT(law(1e-8).error, law(1e-2).error);
}

INSTANTIATE_TEST_SUITE_P(SlowLaw, Laws, testing::ValuesIn(cases()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(SlowLaw, TakesOverBelowTheRange) {
  const Sphere ball{.poisson = 0.3};
  TableValues values{.values = std::vector<Estimate>(6, {0.99, 1e-6})};
  for (int k = 0; k < 6; ++k) values.speeds.push_back(1e-3 * std::pow(2.0, k));
  const RestitutionFunction function(values, Beyond::law, slow_law(ball));
  const Estimate slow = function(-1e-5);
  EXPECT_EQ(slow.value, slow_law(ball)(1e-5).value);
  EXPECT_EQ(slow.error, slow_law(ball)(1e-5).error);
}

TEST(SlowLaw, IsThereForSomeBodiesOnly) {
  const Sphere ball{.poisson = 0.3};
  const Disk plate{.poisson = 0.3};
  test::expect_refusal([&] { (void)slow_law(ball, Sphere{.poisson = 0.3, .radius = 2.0}); }, {"second", "law"});
  test::expect_refusal([&] { (void)slow_law(plate, Disk{.poisson = 0.2}); }, {"second", "law"});
  test::expect_refusal([&] { (void)slow_law(ball, HalfSpace{.poisson = 0.3, .loss_time = 0.1}); }, {"loss_time"});
  test::expect_refusal([] { (void)slow_law(Sphere{.poisson = 0.7}); }, {"poisson"});
  test::expect_refusal([] { (void)slow_law(Disk{.poisson = 0.3, .radius = -1.0}); }, {"radius"});
}

}  // namespace
}  // namespace stoss
