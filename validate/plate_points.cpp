#include "plate_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/sphere.hpp"
#include "support/csv.hpp"

namespace validate {
namespace {

using stoss::test::CsvRow;

stoss::BodyMaker ball_of(const PlateCase& its) {
  const stoss::BodyMaker ball = its.strip
                                    ? stoss::disk(stoss::Disk{.poisson = its.poisson, .loss_time = its.loss_time})
                                    : stoss::sphere(stoss::Sphere{.poisson = its.poisson, .loss_time = its.loss_time});
  return its.rigid ? stoss::rigid(ball) : ball;
}

stoss::BodyMaker plate_of(const PlateCase& its) {
  const stoss::Layer& top = its.layers.front();
  if (its.strip) {
    return stoss::strip(stoss::Strip{top.thickness, top.poisson, top.young, top.density, its.plate_loss_time});
  }
  return stoss::plate({.thickness = top.thickness,
                       .poisson = top.poisson,
                       .young = top.young,
                       .density = top.density,
                       .loss_time = its.plate_loss_time,
                       .below = {its.layers.begin() + 1, its.layers.end()}});
}

/// Numbers between colons.
std::vector<double> numbers_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> numbers;
  for (std::string part; std::getline(in, part, ':');) numbers.push_back(std::stod(part));
  return numbers;
}

/// @param order of h, ν, E and ρ
std::vector<stoss::Layer> layers_of(const std::string& text, const std::array<std::size_t, 4>& order) {
  std::istringstream in(text);
  std::vector<stoss::Layer> layers;
  for (std::string part; std::getline(in, part, ';');) {
    const std::vector<double> numbers = numbers_of(part);
    layers.push_back({numbers.at(order[0]), numbers.at(order[1]), numbers.at(order[2]), numbers.at(order[3])});
  }
  return layers;
}

/// ε, whose error stays finite where the ball does not leave.
stoss::Estimate restitution_of(const stoss::Estimate& lost) {
  const double squared = std::max(0.0, 1.0 - lost.value), restitution = std::sqrt(squared);
  return {restitution, lost.error / (std::sqrt(squared + lost.error) + restitution)};
}

std::vector<PlatePoint> read_file(const std::string& name) {
  std::vector<PlatePoint> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/" + name)) {
    PlatePoint point;
    point.its = {.strip = row.text("body") == "disk",
                 .rigid = row.number("rigid_body") == 1.0,
                 .poisson = row.number("poisson"),
                 .loss_time = row.number("loss_time"),
                 .layers = layers_of(row.text("layers"), {0, 1, 2, 3}),
                 .plate_loss_time = row.number("plate_loss_time"),
                 .speed = row.number("speed")};
    const auto estimate = [&row](const std::string& value, const std::string& uncertainty) {
      return stoss::Estimate{row.number(value), row.number(uncertainty)};
    };
    point.reference[lost_fraction] = estimate("lost_fraction", "uncertainty");
    point.reference[restitution_coefficient] = restitution_of(*point.reference[lost_fraction]);
    point.reference[contact_time] = estimate("contact_time", "contact_time_uncertainty");
    point.reference[impulse_time] = estimate("impulse_time", "impulse_time_uncertainty");
    point.reference[max_force] = estimate("max_force", "max_force_uncertainty");
    point.reference[max_compression] = estimate("max_compression", "max_compression_uncertainty");
    points.push_back(point);
  }
  return points;
}

}  // namespace

std::vector<PlatePoint> read_plates() { return read_file("reference_plates.csv"); }

std::vector<PlatePoint> read_unseen_plates() { return read_file("reference_plates_unseen.csv"); }

stoss::RefinableContact contact_of(const PlateCase& its) { return {ball_of(its), plate_of(its)}; }

std::string text_of(const std::vector<stoss::Layer>& layers) {
  std::ostringstream out;
  const char* between = "";
  for (const stoss::Layer& layer : layers) {
    out << between << layer.thickness << ':' << layer.poisson << ':' << layer.young << ':' << layer.density;
    between = ";";
  }
  return out.str();
}

std::vector<PlatePoint> read_plates_of_elements() {
  std::vector<PlatePoint> points;
  for (const CsvRow& row : stoss::test::read_csv("plate_restitution.csv")) {
    PlatePoint point;
    point.its = {.rigid = row.number("rigid") == 1.0,
                 .poisson = row.number("poisson"),
                 .loss_time = row.number("ball_loss_time"),
                 .layers = layers_of(row.text("layers"), {0, 2, 1, 3}),
                 .plate_loss_time = row.number("loss_time"),
                 .speed = row.number("speed")};
    point.reference[lost_fraction] = {row.number("lost_fraction"), row.number("uncertainty")};
    points.push_back(point);
  }
  return points;
}

}  // namespace validate
