// Are the errors of oblique_restitution() honest? A sample of what the validation program judges
// (docs/developer/validation.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/oblique.hpp"
#include "support/csv.hpp"
#include "support/judged.hpp"

namespace stoss {
namespace oblique_validation {
namespace {

RefinableContact contact_of(const test::CsvRow& row) {
  const bool disks = row.text("body") == "disk";
  const auto maker = [&](const Disk& its) {
    return disks ? disk(its) : sphere(Sphere{its.poisson, its.radius, its.young, its.density, its.loss_time});
  };
  const BodyMaker first = maker({.poisson = row.number("poisson"), .loss_time = row.number("loss_time")});
  if (row.text("against") == "wall") return RefinableContact(first);
  const double poisson = row.number("against_poisson"), young = row.number("against_young");
  if (row.text("against") == "body") return {first, maker({poisson, row.number("against_radius"), young})};
  return {first, disks ? half_plane(HalfPlane{poisson, young}) : half_space(HalfSpace{poisson, young})};
}

TEST(ObliqueValidationSample, HasHonestErrors) {
  constexpr double tolerance = 1e-2;
  constexpr std::size_t every = 4;  // meets all seven kinds of contact
  const std::vector<test::CsvRow> rows = test::read_csv("../../validate/data/reference_oblique.csv");
  ASSERT_GE(rows.size(), 64U);
  test::Judged along, normal;
  for (std::size_t k = 0; k < rows.size(); k += every) {
    const test::CsvRow& row = rows[k];
    SCOPED_TRACE(::testing::Message() << "row " << k);
    const double speed = row.number("speed");
    const Obliquity before{row.number("tangential"), row.number("spin"), 0.0, row.number("friction")};
    const ObliqueRestitution result = oblique_restitution(contact_of(row), speed, before, {.tolerance = tolerance});
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.sliding_after.error, tolerance * std::max(std::abs(result.sliding), before.friction * speed));
    along.add(result.sliding_after, row.number("sliding_after"), row.number("sliding_after_uncertainty"), 3.0);
    normal.add(result.restitution, row.number("restitution"), row.number("restitution_uncertainty"), 3.0);
  }
  along.expect_honest(0.9, 5);
  normal.expect_honest(0.9, 5);
}

}  // namespace
}  // namespace oblique_validation
}  // namespace stoss
