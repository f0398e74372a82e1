// Are the errors of oblique_restitution() honest? A sample of what the validation program judges (docs/validation.md).
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

/// How often values lie within their errors, and how much larger these are.
class Judge {
 public:
  void add(const Estimate& value, double reference, double uncertainty) {
    const double difference = std::abs(value.value - reference);
    EXPECT_LE(difference, 3.0 * value.error + uncertainty);
    ++points_;
    if (difference <= value.error + uncertainty) ++within_;
    if (uncertainty <= 0.1 * value.error) padding_.push_back(value.error / difference);
  }
  void expect_honest(double most_padding) {
    EXPECT_GE(within_, 0.9 * points_);
    ASSERT_GE(padding_.size(), 5U);
    const auto middle = padding_.begin() + static_cast<std::ptrdiff_t>(padding_.size() / 2);
    std::nth_element(padding_.begin(), middle, padding_.end());
    EXPECT_LE(*middle, most_padding);
  }

 private:
  int points_ = 0, within_ = 0;
  std::vector<double> padding_;
};

TEST(ObliqueValidationSample, HasHonestErrors) {
  constexpr double tolerance = 1e-2;
  constexpr std::size_t every = 4;  // meets all seven kinds of contact
  const std::vector<test::CsvRow> rows = test::read_csv("../../validate/data/reference_oblique.csv");
  ASSERT_GE(rows.size(), 64U);
  Judge along, normal;
  for (std::size_t k = 0; k < rows.size(); k += every) {
    const test::CsvRow& row = rows[k];
    SCOPED_TRACE(::testing::Message() << "row " << k);
    const double speed = row.number("speed");
    const Obliquity before{row.number("tangential"), row.number("spin"), 0.0, row.number("friction")};
    const ObliqueRestitution result = oblique_restitution(contact_of(row), speed, before, {.tolerance = tolerance});
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.sliding_after.error, tolerance * std::max(std::abs(result.sliding), before.friction * speed));
    along.add(result.sliding_after, row.number("sliding_after"), row.number("sliding_after_uncertainty"));
    normal.add(result.restitution, row.number("restitution"), row.number("restitution_uncertainty"));
  }
  along.expect_honest(10.0);
  normal.expect_honest(10.0);
}

}  // namespace
}  // namespace oblique_validation
}  // namespace stoss
