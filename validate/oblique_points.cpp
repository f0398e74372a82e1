#include "oblique_points.hpp"

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/sphere.hpp"
#include "support/csv.hpp"

namespace validate {
namespace {

stoss::BodyMaker maker_of(const ObliqueCase& its, const stoss::Disk& disk) {
  if (its.body == "disk") return stoss::disk(disk);
  return stoss::sphere(stoss::Sphere{disk.poisson, disk.radius, disk.young, disk.density, disk.loss_time});
}

}  // namespace

stoss::RefinableContact contact_of(const ObliqueCase& its) {
  const stoss::BodyMaker first = maker_of(its, {.poisson = its.poisson, .loss_time = its.loss_time});
  if (its.against == "wall") return stoss::RefinableContact(first);
  const auto& [poisson, radius, young, density, loss_time] = its.second;
  if (its.against == "body") return {first, maker_of(its, its.second)};
  if (its.body == "disk") return {first, stoss::half_plane(stoss::HalfPlane{poisson, young, density})};
  return {first, stoss::half_space(stoss::HalfSpace{poisson, young, density})};
}

std::vector<ObliquePoint> read_oblique() {
  std::vector<ObliquePoint> points;
  for (const stoss::test::CsvRow& row : stoss::test::read_csv("../../validate/data/reference_oblique.csv")) {
    ObliquePoint point;
    ObliqueCase& its = point.its;
    its.body = row.text("body");
    its.against = row.text("against");
    its.poisson = row.number("poisson");
    its.loss_time = row.number("loss_time");
    its.second = {row.number("against_poisson"), row.number("against_radius"), row.number("against_young")};
    its.speed = row.number("speed");
    its.before = {row.number("tangential"), row.number("spin"), 0.0, row.number("friction")};
    point.restitution = {row.number("restitution"), row.number("restitution_uncertainty")};
    point.sliding_after = {row.number("sliding_after"), row.number("sliding_after_uncertainty")};
    points.push_back(point);
  }
  return points;
}

}  // namespace validate
