// Balls on plates: values computed independently, and what an energy ledger holds.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/restitution.hpp"
#include "support/csv.hpp"
#include "support/plate_rows.hpp"

namespace stoss {
namespace plate_restitution {
namespace {

constexpr double mass = 4.188790204786391;

RefinableContact contact_of(const test::CsvRow& row) {
  const BodyMaker ball = sphere(Sphere{.poisson = row.number("poisson"), .loss_time = row.number("ball_loss_time")});
  return {row.number("rigid") == 1.0 ? rigid(ball) : ball, plate(test::plate_of(row))};
}

std::string name_of(const test::CsvRow& row) {
  return (row.number("rigid") == 1.0 ? "rigid, " : "") + row.text("layers") + ", v = " + row.text("speed") +
         ", eta = " + row.text("loss_time");
}

/// Where the plate throws the ball back, or not, more than once, is not settled yet.
bool bounces_again(const test::CsvRow& row) { return row.text("contacts") != "1" && row.text("contacts") != "1/1"; }

TEST(RestitutionOnAPlate, AgreesWithFiniteElementsWithinBothErrors) {
  for (const auto& row : test::read_csv("plate_restitution.csv")) {
    if (bounces_again(row)) continue;
    SCOPED_TRACE(name_of(row));
    const Restitution found = restitution(contact_of(row), row.number("speed"), {.tolerance = 1e-4});
    std::printf("%-60s lost %.7f(%.1e) fe %.7f(%.1e) diff/err %.2f | tc %.2f ti %.2f (%.1e vs %.1e) F %.2f (%.1e, %.1e) ball %.1e | conv %d runs %zu\n", name_of(row).c_str(), found.lost_fraction.value, found.lost_fraction.error, row.number("lost_fraction"), row.number("uncertainty"),
     (found.lost_fraction.value-row.number("lost_fraction"))/(found.lost_fraction.error+row.number("uncertainty")),
     (found.contact_time.value-row.number("contact_time"))/(found.contact_time.error+row.number("contact_time_uncertainty")),
     (found.impulse_time.value-row.number("impulse_time"))/(found.impulse_time.error+row.number("impulse_time_uncertainty")),found.impulse_time.error,row.number("impulse_time_uncertainty"),
     (found.max_force.value*mass-row.number("max_force"))/(found.max_force.error*mass+row.number("max_force_uncertainty")),found.max_force.error*mass,row.number("max_force_uncertainty"),found.lost_to_first-row.number("share_ball"),found.converged,found.runs.size());
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.lost_fraction.value, row.number("lost_fraction"),
                found.lost_fraction.error + row.number("uncertainty"));
    EXPECT_NEAR(found.contact_time.value, row.number("contact_time"),
                found.contact_time.error + row.number("contact_time_uncertainty"));
    EXPECT_NEAR(found.impulse_time.value, row.number("impulse_time"),
                found.impulse_time.error + row.number("impulse_time_uncertainty"));
    EXPECT_NEAR(found.max_force.value * mass, row.number("max_force"),
                found.max_force.error * mass + row.number("max_force_uncertainty"));
  }
}

}  // namespace
}  // namespace plate_restitution
}  // namespace stoss
