#include "bodies/disk/harmonics.hpp"

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

}  // namespace stoss::bodies::disk
