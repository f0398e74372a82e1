// The C interface gives what the C++ one gives.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/stoss.h"
#include "stoss/table/adaptive.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/version.hpp"
#include "support/c_handles.hpp"

namespace stoss {
using namespace test;

namespace {

void expect_same(const stoss_contact* in_c, const RefinableContact& contact) {
  const std::vector<double> speeds{0.02, 0.1};
  std::array<stoss_result, 2> results{};
  const stoss_control control{2, nullptr, nullptr};
  ASSERT_EQ(stoss_curve(in_c, speeds.data(), speeds.size(), 1e-2, 1e-5, &control, results.data()), STOSS_OK)
      << stoss_message();
  const auto expected = restitution_curve(contact, speeds, {.each = {.tolerance = 1e-2, .absolute = 1e-5}});
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    EXPECT_EQ(results[i].speed, speeds[i]);
    EXPECT_EQ(results[i].restitution.value, expected[i].restitution.value);
    EXPECT_EQ(results[i].restitution.error, expected[i].restitution.error);
    EXPECT_EQ(results[i].lost_fraction.value, expected[i].lost_fraction.value);
    EXPECT_EQ(results[i].contact_time.value, expected[i].contact_time.value);
    EXPECT_EQ(results[i].max_force.error, expected[i].max_force.error);
    EXPECT_EQ(results[i].max_compression.value, expected[i].max_compression.value);
    EXPECT_EQ(results[i].converged, 1);
  }
}

TEST(CInterface, BodiesAtAWallAreThoseOfCpp) {
  CBody disk, sphere, hollow, rod;
  CContact of_disk, of_sphere, of_hollow, of_rod;
  ASSERT_EQ(stoss_disk_make(0.33, 2.0, 3.0, 4.0, 0.5, &disk), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_sphere_make(0.3, 0.5, 2.0, 3.0, 0.0, &sphere), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_hollow_sphere_make(0.3, 0.7, 0.5, 2.0, 3.0, 0.1, &hollow), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_rod_make(2.0, 3.0, 4.0, 0.1, 0.2, &rod), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_wall_contact_make(rod, &of_rod), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(disk, &of_disk), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(sphere, &of_sphere), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(hollow, &of_hollow), STOSS_OK);
  expect_same(of_disk, RefinableContact(stoss::disk(Disk{0.33, 2.0, 3.0, 4.0, 0.5})));
  expect_same(of_rod, RefinableContact(stoss::rod(Rod{2.0, 3.0, 4.0, 0.1, 0.2})));
  expect_same(of_sphere, RefinableContact(stoss::sphere(Sphere{0.3, 0.5, 2.0, 3.0, 0.0})));
  expect_same(of_hollow, RefinableContact(hollow_sphere(HollowSphere{0.3, 0.7, 0.5, 2.0, 3.0, 0.1})));
}

TEST(CInterface, PairsAreThoseOfCpp) {
  CBody sphere, space, plane, disk, rigid;
  CContact on_space, on_plane;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &sphere), STOSS_OK);
  ASSERT_EQ(stoss_half_space_make(0.22, 0.5, 0.4, 0.0, &space), STOSS_OK);
  ASSERT_EQ(stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, &disk), STOSS_OK);
  ASSERT_EQ(stoss_rigid_make(disk, &rigid), STOSS_OK);
  ASSERT_EQ(stoss_half_plane_make(0.2, 0.5, 0.4, 0.1, &plane), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(sphere, space, &on_space), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_pair_contact_make(rigid, plane, &on_plane), STOSS_OK) << stoss_message();
  CBody plate, strip;
  CContact on_plate, on_strip;
  ASSERT_EQ(stoss_plate_make(1.5, 0.22, 0.5, 0.4, 0.0, &plate), STOSS_OK);
  ASSERT_EQ(stoss_strip_make(3.0, 0.2, 0.5, 0.4, 0.1, &strip), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(sphere, plate, &on_plate), STOSS_OK) << stoss_message();
  ASSERT_EQ(stoss_pair_contact_make(disk, strip, &on_strip), STOSS_OK) << stoss_message();
  expect_same(on_plate, {stoss::sphere(0.3), stoss::plate(Plate{1.5, 0.22, 0.5, 0.4, 0.0})});
  expect_same(on_strip, {stoss::disk(0.33), stoss::strip(Strip{3.0, 0.2, 0.5, 0.4, 0.1})});
  expect_same(on_space, {stoss::sphere(0.3), half_space({0.22, 0.5, 0.4, 0.0})});
  expect_same(on_plane, {stoss::rigid(stoss::disk(0.33)), half_plane({0.2, 0.5, 0.4, 0.1})});
}

TEST(CInterface, TheFunctionIsThatOfCpp) {
  CContact contact;
  make_disk_contact(contact);
  CFunction function;
  ASSERT_EQ(stoss_function_make(contact, 0.01, 0.2, 1e-2, STOSS_BEYOND_CLAMP, nullptr, &function), STOSS_OK);
  const auto expected =
      restitution_function(RefinableContact(disk(0.33)), 0.01, 0.2, {.error = 1e-2, .beyond = Beyond::clamp});
  const std::vector<double> speeds{0.01, -0.0345, 0.17, 0.5, 1e-3, 0.0, -0.0};
  std::vector<double> values(speeds.size()), errors(speeds.size()), alone(speeds.size());
  EXPECT_EQ(stoss_function_evaluate(function, speeds.data(), speeds.size(), values.data(), errors.data()), STOSS_OK);
  EXPECT_EQ(stoss_function_evaluate(function, speeds.data(), speeds.size(), alone.data(), nullptr), STOSS_OK);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    EXPECT_EQ(values[i], expected(speeds[i]).value);
    EXPECT_EQ(errors[i], expected(speeds[i]).error);
    EXPECT_EQ(alone[i], values[i]);
  }
  for (const std::size_t below : {4U, 5U, 6U}) {
    EXPECT_EQ(values[below], values[0]);
    EXPECT_EQ(errors[below], infinity);
  }
  double slowest = 0.0, fastest = 0.0, error = 0.0;
  EXPECT_EQ(stoss_function_range(function, &slowest, &fastest, &error), STOSS_OK);
  EXPECT_EQ(slowest, 0.01);
  EXPECT_EQ(fastest, 0.2);
  EXPECT_EQ(error, expected.greatest_error());
  EXPECT_EQ(stoss_function_range(function, nullptr, nullptr, nullptr), STOSS_OK);
}

TEST(CInterface, BelowItsRangeAFunctionHasTheLawOfItsBodies) {
  CBody disk, sphere, space, rigid;
  ASSERT_EQ(stoss_disk_make(0.33, 2.0, 3.0, 4.0, 0.0, &disk), STOSS_OK);
  ASSERT_EQ(stoss_sphere_make(0.3, 2.0, 3.0, 4.0, 0.0, &sphere), STOSS_OK);
  ASSERT_EQ(stoss_half_space_make(0.2, 3.0, 4.0, 0.0, &space), STOSS_OK);
  ASSERT_EQ(stoss_rigid_make(sphere, &rigid), STOSS_OK);
  CContact disk_at_wall, sphere_at_wall, disks, spheres, on_space, of_rigid;
  ASSERT_EQ(stoss_wall_contact_make(disk, &disk_at_wall), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(sphere, &sphere_at_wall), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(disk, disk, &disks), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(sphere, sphere, &spheres), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(sphere, space, &on_space), STOSS_OK);
  ASSERT_EQ(stoss_pair_contact_make(rigid, space, &of_rigid), STOSS_OK);
  const Disk a_disk{0.33, 2.0, 3.0, 4.0};
  const Sphere a_sphere{0.3, 2.0, 3.0, 4.0};
  const HalfSpace a_space{0.2, 3.0, 4.0};
  const std::vector<std::pair<const stoss_contact*, SlowLaw>> cases{
      {disk_at_wall, slow_law(a_disk)},        {sphere_at_wall, slow_law(a_sphere)},
      {disks, slow_law(a_disk, a_disk)},       {spheres, slow_law(a_sphere, a_sphere)},
      {on_space, slow_law(a_sphere, a_space)}, {of_rigid, slow_law(a_sphere, a_space, true)}};
  for (const auto& [contact, law] : cases) {
    CFunction function;
    ASSERT_EQ(stoss_function_make(contact, 0.01, 0.05, 2e-2, STOSS_BEYOND_LAW, nullptr, &function), STOSS_OK)
        << stoss_message();
    const double slow = 1e-4, fast = 0.06;
    double value = 0.0, error = 0.0;
    ASSERT_EQ(stoss_function_evaluate(function, &slow, 1, &value, &error), STOSS_OK);
    EXPECT_EQ(value, law(slow).value);
    EXPECT_EQ(error, law(slow).error);
    EXPECT_EQ(stoss_function_evaluate(function, &fast, 1, &value, &error), STOSS_INVALID_INPUT);
  }
}

TEST(CInterface, ASpeedBeyondTheRangeSpoilsNoOther) {
  CContact contact;
  make_disk_contact(contact);
  CFunction function;
  ASSERT_EQ(stoss_function_make(contact, 0.01, 0.2, 1e-2, STOSS_BEYOND_ERROR, nullptr, &function), STOSS_OK);
  const std::vector<double> speeds{0.001, 0.1, 0.0, nan, infinity};
  std::vector<double> values(speeds.size(), 7.0), errors(speeds.size(), 7.0);
  EXPECT_EQ(stoss_function_evaluate(function, speeds.data(), speeds.size(), values.data(), errors.data()),
            STOSS_INVALID_INPUT);
  EXPECT_NE(std::string(stoss_message()).find("speed"), std::string::npos);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    EXPECT_EQ(std::isnan(values[i]), i != 1);
    EXPECT_EQ(std::isinf(errors[i]), i != 1);
  }
}

TEST(CInterface, PollsOnTheThreadOfTheCaller) {
  CContact contact;
  make_disk_contact(contact);
  struct Seen {
    std::thread::id caller = std::this_thread::get_id();
    int calls = 0, elsewhere = 0;
  } seen;
  const stoss_control control{2,
                              [](void* context) {
                                auto& its = *static_cast<Seen*>(context);
                                ++its.calls;
                                its.elsewhere += std::this_thread::get_id() != its.caller;
                                return its.calls >= 3 ? 1 : 0;
                              },
                              &seen};
  CFunction function;
  EXPECT_EQ(stoss_function_make(contact, 1e-4, 1.0, 1e-5, 0, &control, &function), STOSS_INTERRUPTED);
  EXPECT_EQ(seen.calls, 3);
  EXPECT_EQ(seen.elsewhere, 0);
  EXPECT_EQ(function.handle, nullptr);
}

TEST(CInterface, MessagesBelongToThreads) {
  EXPECT_NE(stoss_wall_contact_make(nullptr, nullptr), STOSS_OK);
  const std::string own = stoss_message();
  std::string first, then;
  std::thread([&] {
    first = stoss_message();
    (void)stoss_function_range(nullptr, nullptr, nullptr, nullptr);
    then = stoss_message();
  }).join();
  EXPECT_EQ(first, "");
  EXPECT_EQ(then.rfind("function: ", 0), 0U);
  EXPECT_EQ(stoss_message(), own);
}

TEST(CInterface, HasTheVersionOfTheLibrary) { EXPECT_EQ(stoss_version(), version()); }

}  // namespace
}  // namespace stoss
