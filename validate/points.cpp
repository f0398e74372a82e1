#include "points.hpp"

#include <cmath>
#include <cstdint>
#include <string>

#include "stoss/encounter/relaxing.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "support/csv.hpp"
#include "support/faces.hpp"

namespace validate {
namespace {

using stoss::Estimate;
using stoss::test::CsvRow;

Estimate estimate(const CsvRow& row, const std::string& value, const std::string& uncertainty) {
  return {row.number(value), row.number(uncertainty)};
}

Point read_point(const CsvRow& row) {
  Point point{row.number("poisson"), {}, row.number("speed"), {}, {}};
  const Estimate lost = estimate(row, "lost_fraction", "uncertainty");
  const double restitution = std::sqrt(1.0 - lost.value);
  point.reference[lost_fraction] = lost;
  point.reference[restitution_coefficient] = {restitution, 0.5 * lost.error / restitution};
  return point;
}

/// With the quantities that our own references have.
Point read_full_point(const CsvRow& row) {
  Point point = read_point(row);
  point.reference[contact_time] = estimate(row, "contact_time", "contact_time_uncertainty");
  point.reference[impulse_time] = estimate(row, "impulse_time", "impulse_time_uncertainty");
  point.reference[max_force] = estimate(row, "max_force", "max_force_uncertainty");
  point.reference[max_compression] = estimate(row, "max_compression", "max_compression_uncertainty");
  return point;
}

std::vector<Point> read_full_points(const std::string& path) {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv(path)) points.push_back(read_full_point(row));
  return points;
}

}  // namespace

stoss::Vibration vibration_of(const Point& point, const stoss::RefinableContact& contact) {
  if (point.temperature == 0.0) return {};
  constexpr std::uint64_t seed = 0;
  return stoss::draw(stoss::thermal(contact, point.temperature, point.highest), seed,
                     static_cast<std::uint64_t>(point.sample));
}

std::vector<Point> read_unseen_points() { return read_full_points("../../validate/data/reference_unseen.csv"); }

std::vector<Point> read_spheres() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_spheres.csv")) {
    points.push_back(read_full_point(row));
    points.back().sphere = true;
  }
  return points;
}

std::vector<Point> read_hollow() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_hollow.csv")) {
    points.push_back(read_full_point(row));
    points.back().sphere = true;
    points.back().inner = row.number("inner");
  }
  return points;
}

std::vector<Point> read_half_spaces() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_half_spaces.csv")) {
    Point point = read_full_point(row);
    point.sphere = row.text("body") == "sphere";
    point.half_space = true;
    point.rigid = row.number("rigid_body") == 1.0;
    point.against = stoss::Disk{.poisson = row.number("against_poisson"),
                                .young = row.number("against_young"),
                                .density = row.number("against_density")};
    points.push_back(point);
  }
  return points;
}

std::vector<Point> read_lossy() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_lossy.csv")) {
    Point point = read_full_point(row);
    point.sphere = row.text("body") == "sphere";
    point.loss_time = row.number("loss_time");
    if (row.has("against_radius")) {
      point.against = stoss::Disk{.poisson = row.number("against_poisson"),
                                  .radius = row.number("against_radius"),
                                  .loss_time = row.number("against_loss_time")};
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Point> read_relaxing() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_relaxing.csv")) {
    Point point = read_full_point(row);
    point.sphere = row.text("body") == "sphere";
    point.half_space = row.number("half_space") == 1.0;
    point.relaxation = stoss::parse_relaxation("terms", row.text("terms"));
    if (row.has("against_terms")) {
      point.against_relaxation = stoss::parse_relaxation("against_terms", row.text("against_terms"));
    }
    if (row.has("against_radius")) {
      point.against = stoss::Disk{.poisson = row.number("against_poisson"), .radius = row.number("against_radius")};
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Point> read_faces() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_faces.csv")) {
    points.push_back(read_full_point(row));
    points.back().encounter = stoss::test::encounter_of_faces(row);
  }
  return points;
}

std::vector<Point> read_vibrating() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_vibrating.csv")) {
    Point point = read_full_point(row);
    point.sphere = row.text("body") == "sphere";
    point.temperature = row.number("temperature");
    point.highest = row.number("highest");
    point.sample = static_cast<long>(points.size());
    if (row.has("against_radius")) {
      point.against = stoss::Disk{.poisson = row.number("against_poisson"),
                                  .radius = row.number("against_radius"),
                                  .young = row.number("against_young")};
    }
    points.push_back(point);
  }
  return points;
}

std::vector<Point> read_pairs() {
  std::vector<Point> points;
  for (const CsvRow& row : stoss::test::read_csv("../../validate/data/reference_pairs.csv")) {
    points.push_back(read_full_point(row));
    points.back().against = stoss::Disk{row.number("against_poisson"), row.number("against_radius"),
                                        row.number("against_young"), row.number("against_density")};
  }
  return points;
}

std::vector<Point> read_points() {
  std::vector<Point> points = read_full_points("../../validate/data/reference.csv");
  for (const CsvRow& row : stoss::test::read_csv("restitution_hard_wall.csv")) {
    Point point = read_point(row);
    if (row.has("finite_elements_restitution")) {
      point.finite_elements = estimate(row, "finite_elements_restitution", "finite_elements_uncertainty");
    }
    points.push_back(point);
  }
  return points;
}

}  // namespace validate
