// Errors on plates and of bodies by their modes are honest, and not padded: impacts to which no constant was fitted,
// and what far finer runs, or the sphere itself, gave (docs/developer/validation.md).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "support/csv.hpp"
#include "support/judged.hpp"
#include "support/modal_sphere.hpp"

namespace stoss {
namespace narrow_errors {
namespace {

using test::Judged;

Restitution best_of(const RefinableContact& contact, double speed) { return best_restitution(contact, speed, {}); }

/// h:ν:E:ρ of each, downwards.
std::vector<Layer> layers_of(const std::string& text) {
  std::vector<Layer> layers;
  std::istringstream in(text);
  char colon = ':';
  for (Layer its; in >> its.thickness >> colon >> its.poisson >> colon >> its.young >> colon >> its.density;) {
    layers.push_back(its);
    in >> colon;
  }
  return layers;
}

RefinableContact on_a_plate(const test::CsvRow& row) {
  const std::vector<Layer> layers = layers_of(row.text("layers"));
  const Layer& top = layers.front();
  const double poisson = row.number("poisson"), loss_time = row.number("loss_time");
  const double its_loss_time = row.number("plate_loss_time");
  const bool round = row.text("body") == "sphere";
  const BodyMaker ball = round ? sphere(Sphere{.poisson = poisson, .loss_time = loss_time})
                               : disk(Disk{.poisson = poisson, .loss_time = loss_time});
  const BodyMaker flat =
      round
          ? plate(Plate{
                top.thickness, top.poisson, top.young, top.density, its_loss_time, {layers.begin() + 1, layers.end()}})
          : strip(Strip{top.thickness, top.poisson, top.young, top.density, its_loss_time});
  return {row.number("rigid_body") == 1.0 ? rigid(ball) : ball, flat};
}

TEST(Errors, OfBallsOnPlatesAreNarrow_long) {
  Judged loss, force, of_rigid;
  for (const auto& row : test::read_csv("../../validate/data/reference_plates_unseen.csv")) {
    const Restitution found = best_of(on_a_plate(row), row.number("speed"));
    if (row.text("body") == "sphere") {
      force.add(found.max_force, row.number("max_force"), row.number("max_force_uncertainty"));
    }
    const double lost = row.number("lost_fraction"), uncertainty = row.number("uncertainty");
    if (lost == 1.0) continue;  // a ball that stays loses all
    loss.add(found.lost_fraction, lost, uncertainty);
    if (row.number("rigid_body") == 1.0) of_rigid.add(found.lost_fraction, lost, uncertainty);
  }
  loss.expect_honest(0.95, 10);
  of_rigid.expect_honest(0.95, 10);
  force.expect_honest(0.95, 10);
}

// The error of what takes nearly all of the energy is one of the rebound that is left.
TEST(Errors, OfBallsThatAPlateAllButKeepsAreNarrow) {
  constexpr double finer = 0.99986415, uncertainty = 5.1e-11;  // with cutoffs from 24 to 48
  const Restitution found =
      best_of({rigid(sphere(Sphere{.poisson = 0.0})), plate(Plate{0.593, 0.37, 1.2, 0.175})}, 0.0027);
  EXPECT_NEAR(found.lost_fraction.value, finer, found.lost_fraction.error + uncertainty);
  EXPECT_LE(found.lost_fraction.error, 2e-7);
}

// Waves that are in a ball before make peaks that coarse runs lack: its force keeps the wider error of disks.
// @param every of so many samples one
void expect_true_forces(std::uint64_t every) {
  std::uint64_t sample = 0;
  for (const auto& row : test::read_csv("../../validate/data/reference_vibrating.csv")) {
    const std::uint64_t its = sample++;
    if (row.text("body") != "sphere" || its % every != 0) continue;
    const BodyMaker ball = sphere(row.number("poisson"));
    const bool alone = !row.has("against_radius");
    const RefinableContact contact =
        alone ? RefinableContact(ball)
              : RefinableContact(ball, sphere(Sphere{.poisson = row.number("against_poisson"),
                                                     .radius = row.number("against_radius"),
                                                     .young = row.number("against_young")}));
    const Vibration vibration = draw(thermal(contact, row.number("temperature"), row.number("highest")), 0, its);
    const Estimate found =
        best_restitution(contact, row.number("speed"), {.tolerance = 1e-15, .absolute = 1e-3, .vibration = vibration})
            .max_force;
    EXPECT_NEAR(found.value, row.number("max_force"), 3.0 * found.error + row.number("max_force_uncertainty")) << its;
  }
}

TEST(Errors, OfTheForceOfVibratingBallsReachTheTrueOne) { expect_true_forces(5); }

TEST(Errors, OfTheForceOfAllVibratingBallsReachTheTrueOne_long) { expect_true_forces(1); }

RefinableContact against(const test::CsvRow& row, const BodyMaker& body) {
  const double size = row.number("size"), poisson = row.number("its_poisson");
  const double young = row.number("its_young"), density = row.number("its_density");
  const std::string& what = row.text("against");
  if (what == "sphere") return {body, sphere(Sphere{poisson, size, young, density})};
  if (what == "half_space") return {body, half_space(HalfSpace{poisson, young, density})};
  if (what == "plate") return {body, plate(Plate{size, poisson, young, density})};
  if (what == "its like") return {body, body};
  return RefinableContact(body);
}

// Most of them flatter than a sphere near the point, or with numbers that are off: neither is told.
TEST(Errors, OfBodiesByTheirModesAreNarrow) {
  Judged all, flat;
  for (const auto& row : test::read_csv("../../validate/data/reference_modal.csv")) {
    ModalBody body = test::modal_sphere(row.number("poisson"), row.number("complete_to"), row.number("bends") == 1.0);
    body.compliance += row.number("compliance_off");
    body.compliance_error = row.number("compliance_error");
    body.complete_to *= 1.0 + row.number("frequency_error");
    for (PointMode& mode : body.modes) {
      mode.omega_error = row.number("frequency_error") * mode.omega;
      mode.omega *= 1.0 + row.number("frequency_off");
      mode.displacement_error = row.number("displacement_error") * std::abs(mode.displacement);
      mode.displacement *= 1.0 + row.number("displacement_off");
    }
    const Estimate found = best_of(against(row, modal_body(body)), row.number("speed")).lost_fraction;
    all.add(found, row.number("lost_fraction"), row.number("uncertainty"));
    const bool on_flat = row.text("against") == "half_space" || row.text("against") == "plate";
    if (on_flat) flat.add(found, row.number("lost_fraction"), row.number("uncertainty"));
  }
  all.expect_honest(0.95, 10);
  flat.expect_honest(0.95, 10);
}

}  // namespace
}  // namespace narrow_errors
}  // namespace stoss
