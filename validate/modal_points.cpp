#include "modal_points.hpp"

#include <cmath>

#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/modal_body.hpp"
#include "stoss/bodies/plate.hpp"
#include "stoss/bodies/sphere.hpp"
#include "support/csv.hpp"
#include "support/modal_sphere.hpp"

namespace validate {
namespace {

/// A cap of the sphere is ground away by so little that its modes do not feel it.
stoss::BodyMaker ground(const stoss::BodyMaker& sphere, double flatter) {
  if (flatter == 0.0) return sphere;
  return [sphere, flatter](double cutoff, const stoss::Poll& poll) {
    stoss::Body body = sphere(cutoff, poll);
    body.surface = [round = body.surface, flatter](const stoss::ContactPoints& points) {
      stoss::Surface surface = round(points);
      for (std::size_t i = 0; i < points.count; ++i) {
        surface.recess[i] += flatter * std::pow(points.radius * std::sin(points.angle(i)), 4);
      }
      return surface;
    };
    return body;
  };
}

stoss::BodyMaker as_given(const ModalCase& its) {
  stoss::ModalBody body = stoss::test::modal_sphere(its.poisson, its.complete_to, its.bends);
  body.compliance += its.compliance_off;
  body.compliance_error = its.compliance_error;
  body.complete_to *= 1.0 + its.frequency_error;
  for (stoss::PointMode& mode : body.modes) {
    mode.omega_error = its.frequency_error * mode.omega;
    mode.omega *= 1.0 + its.frequency_off;
    mode.displacement_error = its.displacement_error * std::abs(mode.displacement);
    mode.displacement *= 1.0 + its.displacement_off;
  }
  return stoss::modal_body(body);
}

stoss::RefinableContact meeting(const ModalCase& its, const stoss::BodyMaker& body) {
  if (its.against == "sphere") {
    return {body, stoss::sphere(stoss::Sphere{its.its_poisson, its.size, its.its_young, its.its_density})};
  }
  if (its.against == "half_space") {
    return {body, stoss::half_space(stoss::HalfSpace{its.its_poisson, its.its_young, its.its_density})};
  }
  if (its.against == "plate") {
    return {body, stoss::plate(stoss::Plate{its.size, its.its_poisson, its.its_young, its.its_density})};
  }
  if (its.against == "its like") return {body, body};
  return stoss::RefinableContact(body);
}

}  // namespace

stoss::RefinableContact given(const ModalCase& its) { return meeting(its, as_given(its)); }

stoss::RefinableContact exact(const ModalCase& its) {
  return meeting(its, ground(stoss::sphere(its.poisson), its.flatter));
}

std::vector<ModalPoint> read_modal() {
  std::vector<ModalPoint> points;
  for (const stoss::test::CsvRow& row : stoss::test::read_csv("../../validate/data/reference_modal.csv")) {
    ModalPoint point;
    point.its = {.poisson = row.number("poisson"),
                 .complete_to = row.number("complete_to"),
                 .bends = row.number("bends") == 1.0,
                 .flatter = row.number("flatter"),
                 .compliance_error = row.number("compliance_error"),
                 .compliance_off = row.number("compliance_off"),
                 .frequency_error = row.number("frequency_error"),
                 .frequency_off = row.number("frequency_off"),
                 .displacement_error = row.number("displacement_error"),
                 .displacement_off = row.number("displacement_off"),
                 .against = row.text("against"),
                 .size = row.number("size"),
                 .its_poisson = row.number("its_poisson"),
                 .its_young = row.number("its_young"),
                 .its_density = row.number("its_density"),
                 .speed = row.number("speed")};
    const auto estimate = [&row](const std::string& value, const std::string& uncertainty) {
      return stoss::Estimate{row.number(value), row.number(uncertainty)};
    };
    point.reference[lost_fraction] = estimate("lost_fraction", "uncertainty");
    point.reference[contact_time] = estimate("contact_time", "contact_time_uncertainty");
    point.reference[impulse_time] = estimate("impulse_time", "impulse_time_uncertainty");
    point.reference[max_force] = estimate("max_force", "max_force_uncertainty");
    point.reference[max_compression] = estimate("max_compression", "max_compression_uncertainty");
    points.push_back(point);
  }
  return points;
}

}  // namespace validate
