// The C interface makes a status and a message of everything that goes wrong.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>

#include "stoss/bodies/sphere.hpp"
#include "stoss/errors.hpp"
#include "stoss/stoss.h"
#include "support/c_handles.hpp"

namespace stoss {
using namespace test;

namespace {

TEST(CStatus, RefusesWhatCppRefuses) {
  CBody body;
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    EXPECT_EQ(stoss_disk_make(0.33, bad, 1.0, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_sphere_make(0.3, 1.0, bad, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_rod_make(1.0, 1.0, bad, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_half_space_make(0.3, bad, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_half_plane_make(0.3, 1.0, bad, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_plate_make(bad, 0.3, 1.0, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_strip_make(bad, 0.3, 1.0, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_plate_make(1.0, 0.3, bad, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
    EXPECT_EQ(stoss_strip_make(1.0, 0.3, 1.0, bad, 0.0, &body), STOSS_INVALID_INPUT);
  }
  EXPECT_EQ(stoss_sphere_make(0.5, 1.0, 1.0, 1.0, 0.0, &body), STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_message(), [] {
    static std::string line;
    try {
      (void)stoss::sphere(0.5);
    } catch (const InvalidInput& error) {
      line = error.what();
    }
    return line.c_str();
  }());
  const stoss_refusal refusal = stoss_last_refusal();
  EXPECT_EQ(refusal.kind, STOSS_OUT_OF_RANGE);
  EXPECT_STREQ(refusal.name, "poisson");
  EXPECT_STREQ(refusal.got, "0.5");
  EXPECT_EQ(std::string("poisson: got 0.5, allowed ") + refusal.allowed + " (" + refusal.hint + ")", stoss_message());
  EXPECT_EQ(body.handle, nullptr);

  CContact contact;
  make_disk_contact(contact);
  stoss_result result{};
  result.speed = 7.0;
  for (const double bad : {0.0, -0.1, 2.0, nan, infinity}) {
    EXPECT_EQ(stoss_curve(contact, &bad, 1, 1e-3, 1e-6, nullptr, &result), STOSS_INVALID_INPUT);
  }
  const double speed = 0.1;
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 0.0, 1e-6, nullptr, &result), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-3, -1.0, nullptr, &result), STOSS_INVALID_INPUT);
  const stoss_control no_threads{-1, nullptr, nullptr};
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-3, 1e-6, &no_threads, &result), STOSS_INVALID_INPUT);
  EXPECT_EQ(result.speed, 7.0);
  CFunction function;
  EXPECT_EQ(stoss_function_make(contact, 0.1, 0.01, 1e-2, 0, nullptr, &function), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_make(contact, 0.01, 0.1, 1.0, 0, nullptr, &function), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_make(contact, 0.01, 0.1, 1e-2, 7, nullptr, &function), STOSS_INVALID_INPUT);
  EXPECT_EQ(function.handle, nullptr);

  CBody sphere;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &sphere), STOSS_OK);
  CBody disk;
  ASSERT_EQ(stoss_disk_make(0.3, 1.0, 1.0, 1.0, 0.0, &disk), STOSS_OK);
  CContact unlike;
  EXPECT_EQ(stoss_pair_contact_make(sphere, disk, &unlike), STOSS_INVALID_INPUT);

  CBody rod;
  CContact without_law;
  ASSERT_EQ(stoss_rod_make(1.0, 1.0, 1.0, 1.0, 0.0, &rod), STOSS_OK);
  ASSERT_EQ(stoss_wall_contact_make(rod, &without_law), STOSS_OK);
  EXPECT_EQ(stoss_function_make(without_law, 0.01, 0.1, 1e-2, STOSS_BEYOND_LAW, nullptr, &function),
            STOSS_INVALID_INPUT);
  EXPECT_EQ(std::string(stoss_message()).rfind("beyond: ", 0), 0U);
}

TEST(CStatus, RefusesWhatCannotMeetWhereItIsMade) {
  CBody sphere, space, plane, rigid, none;
  ASSERT_EQ(stoss_sphere_make(0.3, 1.0, 1.0, 1.0, 0.0, &sphere), STOSS_OK);
  ASSERT_EQ(stoss_half_space_make(0.2, 1.0, 1.0, 0.0, &space), STOSS_OK);
  ASSERT_EQ(stoss_half_plane_make(0.2, 1.0, 1.0, 0.0, &plane), STOSS_OK);
  ASSERT_EQ(stoss_rigid_make(sphere, &rigid), STOSS_OK);
  for (const stoss_body* endless : {space.handle, plane.handle}) {
    EXPECT_EQ(stoss_rigid_make(endless, &none), STOSS_INVALID_INPUT);
    EXPECT_EQ(std::string(stoss_message()).rfind("rigid: got 'half-", 0), 0U) << stoss_message();
    EXPECT_EQ(none.handle, nullptr);
  }
  CContact contact;
  for (const stoss_body* body : {space.handle, plane.handle, rigid.handle}) {
    EXPECT_EQ(stoss_wall_contact_make(body, &contact), STOSS_INVALID_INPUT);
    EXPECT_NE(std::string(stoss_message()).find("cannot meet a"), std::string::npos) << stoss_message();
  }
  EXPECT_EQ(stoss_pair_contact_make(space, sphere, &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_pair_contact_make(rigid, rigid, &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(contact.handle, nullptr);
}

TEST(CStatus, RefusesNull) {
  CBody body;
  CContact contact;
  make_disk_contact(contact);
  CFunction function;
  const double speed = 0.1;
  double value = 0.0;
  stoss_result result{};
  EXPECT_EQ(stoss_disk_make(0.33, 1.0, 1.0, 1.0, 0.0, nullptr), STOSS_INVALID_INPUT);
  EXPECT_STREQ(stoss_message(), "body: got NULL, allowed a pointer to it");
  EXPECT_EQ(stoss_rigid_make(nullptr, &body), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_wall_contact_make(nullptr, &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_pair_contact_make(nullptr, nullptr, &contact), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_curve(nullptr, &speed, 1, 1e-3, 1e-6, nullptr, &result), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_curve(contact, nullptr, 1, 1e-3, 1e-6, nullptr, &result), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_curve(contact, &speed, 1, 1e-3, 1e-6, nullptr, nullptr), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_make(nullptr, 0.01, 0.1, 1e-2, 0, nullptr, &function), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_make(contact, 0.01, 0.1, 1e-2, 0, nullptr, nullptr), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_evaluate(nullptr, &speed, 1, &value, nullptr), STOSS_INVALID_INPUT);
  EXPECT_EQ(stoss_function_range(nullptr, &value, nullptr, nullptr), STOSS_INVALID_INPUT);
  stoss_body_free(nullptr);
  stoss_contact_free(nullptr);
  stoss_function_free(nullptr);
}

TEST(CStatus, SaysWhichValueHasNotConverged) {
  CContact contact;
  make_disk_contact(contact);
  const std::array<double, 2> speeds{0.1, 0.2};
  std::array<stoss_result, 2> results{};
  EXPECT_EQ(stoss_curve(contact, speeds.data(), 2, 1e-12, 0.0, nullptr, results.data()), STOSS_NOT_CONVERGED);
  EXPECT_EQ(std::string(stoss_message()).rfind("speed 0: ", 0), 0U) << stoss_message();
  for (const stoss_result& each : results) {
    EXPECT_EQ(each.converged, 0);
    EXPECT_GT(each.restitution.value, 0.8);
    EXPECT_GT(each.restitution.error, 0.0);
  }
}

template <typename Exception>
int throwing(void*) {
  throw Exception("from the poll");
}

TEST(CStatus, MakesAStatusOfEveryException) {
  CContact contact;
  make_disk_contact(contact);
  const double speed = 0.1;
  stoss_result result{};
  const auto status = [&](stoss_poll poll) {
    const stoss_control control{1, poll, nullptr};
    return stoss_curve(contact, &speed, 1, 1e-6, 0.0, &control, &result);
  };
  EXPECT_EQ(status([](void*) { return 1; }), STOSS_INTERRUPTED);
  EXPECT_STREQ(stoss_message(), "interrupted by the poll of the caller");
  EXPECT_EQ(status([](void*) -> int { throw std::bad_alloc(); }), STOSS_OUT_OF_MEMORY);
  EXPECT_STREQ(stoss_message(), "out of memory");
  EXPECT_EQ(status(throwing<std::length_error>), STOSS_OUT_OF_MEMORY);
  EXPECT_EQ(status(throwing<NotConverged>), STOSS_NOT_CONVERGED);
  EXPECT_EQ(status(throwing<std::runtime_error>), STOSS_FAILED);
  EXPECT_STREQ(stoss_message(), "from the poll");
  EXPECT_EQ(status([](void*) -> int { throw 1; }), STOSS_FAILED);
  EXPECT_EQ(status([](void*) -> int { throw std::runtime_error(std::string(5000, 'x')); }), STOSS_FAILED);
  EXPECT_EQ(std::strlen(stoss_message()), 1023U);
}

}  // namespace
}  // namespace stoss
