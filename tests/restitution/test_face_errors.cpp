// Errors between rough and coated faces are honest, and not padded: impacts of validate/data/reference_faces.csv, and
// what far finer runs gave (docs/developer/validation.md).
#include <gtest/gtest.h>

#include <string>

#include "stoss/restitution/curve.hpp"
#include "support/csv.hpp"
#include "support/faces.hpp"
#include "support/judged.hpp"

namespace stoss {
namespace {

class FaceErrors : public ::testing::TestWithParam<double> {};

TEST_P(FaceErrors, AreHonest_long) {
  test::Judged loss, time, force, compression;
  int number = 0;
  for (const auto& row : test::read_csv("../../validate/data/reference_faces.csv")) {
    SCOPED_TRACE(::testing::Message() << "point " << number++);
    const RefinableContact contact = refinable(test::encounter_of_faces(row));
    const Restitution found =
        best_restitution(contact, row.number("speed"), {.tolerance = GetParam(), .absolute = 1e-9});
    const auto add = [&row](test::Judged& judged, const Estimate& estimate, const std::string& name) {
      const std::string uncertainty = name == "lost_fraction" ? "uncertainty" : name + "_uncertainty";
      judged.add(estimate, row.number(name), row.number(uncertainty), 3.0);
    };
    add(loss, found.lost_fraction, "lost_fraction");
    add(time, found.contact_time, "contact_time");
    add(force, found.max_force, "max_force");
    add(compression, found.max_compression, "max_compression");
  }
  loss.expect_honest(0.95, 30);
  compression.expect_honest(0.95, 30);
  EXPECT_GE(time.within, 0.95 * time.points);
  EXPECT_GE(force.within, 0.95 * force.points);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, FaceErrors, ::testing::Values(1e-2, 1e-3));

}  // namespace
}  // namespace stoss
