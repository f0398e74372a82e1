#include "contact/sided/sided_compliance.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

SidedCompliance sided_compliance(const std::vector<double>& normal_even, const std::vector<double>& along_even,
                                 std::size_t points) {
  const auto n = static_cast<Index>(points);
  // Symmetric: rows are columns.
  const Eigen::Map<const MatrixXd> s(normal_even.data(), 2 * n, 2 * n), a(along_even.data(), 2 * n, 2 * n);
  const auto joined = [n](const MatrixXd& even, const MatrixXd& odd) {
    MatrixXd both(2 * n, 2 * n);
    both << even + odd, even - odd, even - odd, even + odd;
    return both;
  };
  SidedCompliance result;
  result.xx = joined(s.topLeftCorner(n, n), a.bottomRightCorner(n, n));
  result.yy = joined(a.topLeftCorner(n, n), s.bottomRightCorner(n, n));
  const MatrixXd of_odd = s.topRightCorner(n, n), of_even = a.bottomLeftCorner(n, n);  // friction; displacement x
  result.xy.resize(2 * n, 2 * n);
  result.xy << of_even + of_odd, of_even - of_odd, of_odd - of_even, -of_even - of_odd;
  return result;
}

void to_block(const VectorXd& first, const VectorXd& second, double share, std::vector<double>& block) {
  const Index n = first.size() / 2;
  VectorXd::Map(block.data(), n) = share * (first.head(n) + first.tail(n));
  VectorXd::Map(block.data() + n, n) = share * (second.head(n) - second.tail(n));
}

void add_block(const std::vector<double>& block, VectorXd& first, VectorXd& second) {
  const Index n = first.size() / 2;
  const Eigen::Map<const VectorXd> even(block.data(), n), odd(block.data() + n, n);
  first.head(n) += even;
  first.tail(n) += even;
  second.head(n) += odd;
  second.tail(n) -= odd;
}

}  // namespace stoss
