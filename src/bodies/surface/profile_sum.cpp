#include "bodies/surface/profile_sum.hpp"

#include <string>

#include "bodies/field_arguments.hpp"
#include "check.hpp"

namespace stoss::bodies {

void require_points(const half_space::PlaneGrid& points, const ContactPoints& contact, double deepest) {
  const auto depths = static_cast<long>(points.depth.size()), distances = static_cast<long>(points.distance.size());
  require("depth count", depths, 1, 1'000'000, "depths of the points");
  require("distance count", distances, 1, 1'000'000, "distances of the points from the axis");
  require("point count", depths * distances, 1, 100'000'000, "depths times distances");
  constexpr double farthest = 1e6;
  constexpr Range inside{0.0, farthest, true, true, "0 to 1e6"};
  const std::string allowed = deepest < farthest ? "0 to " + shown(deepest) : "0 to 1e6";
  constexpr double rounding = 1e-6;  // of places in single precision
  const Range there{0.0, std::min(deepest * (1.0 + rounding), farthest), true, true, allowed};
  for (const double depth : points.depth) require("depth", depth, there, "below the surface");
  for (const double distance : points.distance) require("distance", distance, inside, "from the axis");
  require_nodes(contact, {0.0, farthest, false, true, "above 0 to 1e6"}, "of the circle of the points");
}

ProfileSum::ProfileSum(const MediumSurface& medium, const half_space::PlaneGrid& points, const Poll& poll)
    : medium_(medium),
      points_(points),
      poll_(poll),
      lateral_(Matrix::Zero(depths(), distances())),
      normal_(Matrix::Zero(depths(), distances())),
      lateral_profile_(Matrix::Zero(depths(), block)),
      normal_profile_(Matrix::Zero(depths(), block)),
      lateral_shape_(block, distances()),
      normal_shape_(block, distances()) {}

void ProfileSum::start(double wave_number) {
  if (row_ + 1 == block) flush();
  ++row_;
  for (Index i = 0; i < distances(); ++i) {
    const double phase = wave_number * points_.distance[static_cast<std::size_t>(i)];
    normal_shape_(row_, i) = medium_.shape(phase);
    lateral_shape_(row_, i) = medium_.slope(phase);
  }
}

half_space::Field ProfileSum::field() {
  flush();
  return {{lateral_.data(), lateral_.data() + lateral_.size()}, {normal_.data(), normal_.data() + normal_.size()}};
}

void ProfileSum::flush() {
  if (poll_) poll_();
  const Index rows = row_ + 1;
  lateral_.topRows(reached_).noalias() += lateral_profile_.topLeftCorner(reached_, rows) * lateral_shape_.topRows(rows);
  normal_.topRows(reached_).noalias() += normal_profile_.topLeftCorner(reached_, rows) * normal_shape_.topRows(rows);
  lateral_profile_.topRows(reached_).setZero();
  normal_profile_.topRows(reached_).setZero();
  reached_ = 0;
  row_ = -1;
}

}  // namespace stoss::bodies
