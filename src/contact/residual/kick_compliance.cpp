#include "contact/residual/kick_compliance.hpp"

#include "numeric/damped_oscillator.hpp"
#include "numeric/dense.hpp"
#include "numeric/stable_kicks.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

namespace dense = numeric::dense;

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

/// Of the static compliance of a mode.
double share_of_kick(double omega, double loss_time, bool lossy, double step) {
  if (!lossy) return numeric::share_beside_kicks(omega, 0.0, step);
  return numeric::stable_kicks(omega, 0.5 * loss_time * omega * omega, step).at_once;
}

}  // namespace

void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         Eigen::Ref<Eigen::MatrixXd> compliance) {
  if (contact.groups.empty()) return;
  const bool lossy = longest_loss_time(contact) > 0.0;
  const auto n = compliance.rows();
  const Eigen::Map<const RowMajor> shape(grid.shape.data(), static_cast<Index>(grid.shape.size()) / n, n);
  RowMajor response = RowMajor::Zero(shape.rows(), n);  // of each shape to forces on the nodes
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    const double loss = loss_time(contact, g);
    double upper = 0.0, mixed = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double omega = group.omega[l];
      const double missing = share_of_kick(omega, loss, lossy, step) / (omega * omega * contact.mass);
      upper += missing * group.upper[l] * group.upper[l];
      mixed += missing * group.upper[l] * group.lower[l];
      lower += missing * group.lower[l] * group.lower[l];
    }
    const auto u = static_cast<Index>(group.upper_row), l = static_cast<Index>(group.lower_row);
    response.row(u) += upper * shape.row(u) + mixed * shape.row(l);
    response.row(l) += mixed * shape.row(u) + lower * shape.row(l);
  }
  dense::by_columns(n, poll, [&](Index first, Index count) {
    compliance.middleCols(first, count).noalias() += shape.transpose() * response.middleCols(first, count);
  });
}

}  // namespace stoss
