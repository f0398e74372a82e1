// Errors between rough and coated faces are honest: impacts of validate/data/reference_faces.csv, and what far finer
// runs gave (docs/developer/validation.md).
#include <gtest/gtest.h>

#include "stoss/restitution/curve.hpp"
#include "support/csv.hpp"
#include "support/faces.hpp"
#include "support/judged.hpp"

namespace stoss {
namespace {

class FaceErrors : public ::testing::TestWithParam<double> {};

TEST_P(FaceErrors, AreHonest) {
  constexpr int every = 3;
  test::Judged loss, time;
  int number = 0;
  for (const auto& row : test::read_csv("../../validate/data/reference_faces.csv")) {
    if (number++ % every != 0) continue;
    SCOPED_TRACE(::testing::Message() << "point " << number - 1);
    const RefinableContact contact = refinable(test::encounter_of_faces(row));
    const Restitution found =
        best_restitution(contact, row.number("speed"), {.tolerance = GetParam(), .absolute = 1e-9});
    loss.add(found.lost_fraction, row.number("lost_fraction"), row.number("uncertainty"), 3.0);
    time.add(found.contact_time, row.number("contact_time"), row.number("contact_time_uncertainty"), 3.0);
  }
  EXPECT_GE(loss.within, 0.9 * loss.points);
  EXPECT_GE(time.within, 0.9 * time.points);
}

INSTANTIATE_TEST_SUITE_P(Tolerances, FaceErrors, ::testing::Values(1e-3));

}  // namespace
}  // namespace stoss
