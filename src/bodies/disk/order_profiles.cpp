#include "bodies/disk/order_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/disk/radial_field.hpp"

namespace stoss::bodies::disk {

Harmonics harmonics(const Eigen::ArrayXd& angle, int first) {
  const Eigen::RowVectorXd cosine = angle.cos().transpose(), sine = angle.sin().transpose();
  Harmonics table{Harmonics::Matrix(order_block, angle.size()), Harmonics::Matrix(order_block, angle.size())};
  table.cosine.row(0) = (first * angle).cos().transpose();
  table.sine.row(0) = (first * angle).sin().transpose();
  for (int k = 1; k < order_block; ++k) {
    // By rotation from one order to the next.
    const auto c = table.cosine.row(k - 1), s = table.sine.row(k - 1);
    table.cosine.row(k) = c.cwiseProduct(cosine) - s.cwiseProduct(sine);
    table.sine.row(k) = s.cwiseProduct(cosine) + c.cwiseProduct(sine);
  }
  return table;
}

namespace {

using Eigen::Index;

/// The powers of one radius for the orders n = first … first + order_block − 1.
class BlockPowers {
 public:
  BlockPowers(double radius, int first) : ring_((1.0 - radius) * (1.0 + radius)) {
    double power = std::pow(radius, std::max(0, first - 2));
    for (auto k = static_cast<std::size_t>(std::max(0, 2 - first)); k < power_.size(); ++k) {
      power_[k] = power;
      power *= radius;
    }
  }

  [[nodiscard]] RadialPowers operator[](std::size_t k) const {
    return {power_[k] * ring_, power_[k + 1], power_[k + 2], power_[k + 3]};
  }

 private:
  double ring_;                                  // r^{n−2} − r^n = r^{n−2}(1 − r²)
  std::array<double, order_block + 3> power_{};  // from r^{first−2}; 0 for negative powers
};

}  // namespace

OrderProfiles::OrderProfiles(double poisson, const Body& body, const ContactPoints& contact, std::vector<double> radius,
                             const Poll& poll)
    : KeptProfiles(poisson, body, contact, std::move(radius), poll) {}

OrderProfiles::Loads OrderProfiles::loads(const Eigen::ArrayXd& node_force, int first) const {
  const Harmonics at = harmonics(point_, first);
  Loads loads{-at.cosine * (node_force * point_.cos()).matrix(), at.sine * (node_force * point_.sin()).matrix()};
  for (int k = 0; k < order_block; ++k) {
    const int order = first + k;
    loads.normal[k] *= order == 0 ? 0.5 : weight(order);
    loads.shear[k] *= weight(order);
  }
  return loads;
}

void OrderProfiles::add_static(const Loads& loads, int first, const Poll& poll, Profile& profile) const {
  std::array<StaticField, order_block> field;
  for (int k = 0; k < order_block; ++k) {
    field[static_cast<std::size_t>(k)] = static_field(poisson_, first + k, loads.normal[k], loads.shear[k]);
  }
  for (std::size_t r = 0; r < radius_.size(); ++r) {
    if (poll) poll();
    if (orders()[r] <= first) continue;
    const BlockPowers power(radius_[r], first);
    for (std::size_t k = 0; k < field.size(); ++k) {
      const auto value = ProfileShape::values(field[k].at(power[k]));
      for (std::size_t i = 0; i < components; ++i) {
        profile[i](static_cast<Index>(r), static_cast<Index>(k)) += value[i];
      }
    }
  }
}

void OrderProfiles::evaluate(const Eigen::VectorXd& coordinate, const Eigen::ArrayXd& node_force, int first,
                             const Poll& poll, Profile& profile) const {
  for (Matrix& component : profile) component.setZero(static_cast<Index>(radius_.size()), order_block);
  const Loads loads = this->loads(node_force, first);
  add_static(loads, first, poll, profile);
  const auto load = [&](int order) {  // w_n g_C and w_n g_S
    const int k = order - first;
    return std::array{order == 0 ? 2.0 * loads.normal[k] : loads.normal[k], loads.shear[k]};
  };
  add_kept(coordinate, load, first, order_block, profile);
}

}  // namespace stoss::bodies::disk
