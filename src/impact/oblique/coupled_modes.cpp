#include "impact/oblique/coupled_modes.hpp"

#include <numeric>

#include "contact/response.hpp"

namespace stoss {

using Eigen::Index;
using Eigen::Map;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Points on both sides, right and left, as a block: the even part of one direction, the odd one of the other. A ring
/// is a block by itself.
/// @param share of the sum of both sides: ½ for displacements, 1 for forces; the work is the same
void to_block(const VectorXd& even, const VectorXd& odd, double share, std::vector<double>& block) {
  const auto n = static_cast<Index>(block.size() / 2);
  Map<VectorXd> first(block.data(), n), second(block.data() + n, n);
  first = even.head(n), second = odd.head(n);
  if (even.size() == n) return;
  first = share * (first + even.tail(n)), second = share * (second - odd.tail(n));
}

/// Adds the displacements of a block to those of all points.
void add_block(const std::vector<double>& block, VectorXd& even, VectorXd& odd) {
  const auto n = static_cast<Index>(block.size() / 2);
  const Map<const VectorXd> first(block.data(), n), second(block.data() + n, n);
  even.head(n) += first, odd.head(n) += second;
  if (even.size() == n) return;
  even.tail(n) += first, odd.tail(n) -= second;
}

/// Calls with each block and both directions, that in which its forces are even first.
template <typename Blocks, typename Vector, typename Call>
void for_each_block(Blocks& blocks, Vector& x, Vector& y, const Call& call) {
  call(blocks.front(), x, y);
  if (blocks.size() == 2) call(blocks.back(), y, x);
}

}  // namespace

CoupledModes::Block::Block(const Contact& along, const ContactGrid& grid, const FixedResolution& resolution,
                           const Poll& poll)
    : contact(along),
      modes(along, grid, resolution.step, follows_at_once(along, resolution.tail) ? Kicks::weaker : Kicks::whole),
      residuals(along, grid, ResidualMotion::Inertia::all, resolution.step, poll),
      force(grid.recess.size()),
      displacement(grid.recess.size()) {}

CoupledModes::CoupledModes(const std::vector<Contact>& along, const ContactPoints& points,
                           const FixedResolution& resolution, const Poll& poll)
    : points_(points.count) {
  blocks_.reserve(along.size());
  for (const Contact& each : along) blocks_.emplace_back(each, contact_grid(each, points), resolution, poll);
}

CoupledCompliance CoupledModes::compliance(const Poll& poll) const {
  const std::vector<double> first = blocks_.front().residuals.compliance(poll);
  if (blocks_.size() == 2) return compliance_of_sides(first, blocks_.back().residuals.compliance(poll), points_);
  const auto n = static_cast<Index>(points_);
  const Map<const MatrixXd> both(first.data(), 2 * n, 2 * n);  // symmetric: rows are columns
  return {both.topLeftCorner(n, n), both.topRightCorner(n, n), both.bottomRightCorner(n, n)};
}

void CoupledModes::begin() {
  for (Block& block : blocks_) block.modes.begin();
}

void CoupledModes::advance() {
  for (Block& block : blocks_) block.modes.advance();
}

void CoupledModes::accumulate_energy() {
  for (Block& block : blocks_) block.modes.accumulate_energy();
}

void CoupledModes::add_places(VectorXd& x, VectorXd& y) {
  for_each_block(blocks_, x, y, [](Block& block, VectorXd& even, VectorXd& odd) {
    std::vector<double> moved(block.force.size());
    block.modes.add_displacement(moved);
    add_block(moved, even, odd);
  });
}

void CoupledModes::add_free_displacement(VectorXd& x, VectorXd& y) {
  for_each_block(blocks_, x, y,
                 [](Block& block, VectorXd& even, VectorXd& odd) { add_block(block.residuals.predict(), even, odd); });
}

void CoupledModes::load(const VectorXd& force, const VectorXd& friction, const VectorXd& moved_x,
                        const VectorXd& moved_y) {
  for_each_block(blocks_, force, friction, [](Block& block, const VectorXd& even, const VectorXd& odd) {
    to_block(even, odd, 1.0, block.force);
  });
  for_each_block(blocks_, moved_x, moved_y, [](Block& block, const VectorXd& even, const VectorXd& odd) {
    to_block(even, odd, 0.5, block.displacement);
  });
  for (Block& block : blocks_) {
    block.residuals.move(block.displacement, block.force, block.force.size());
    block.modes.load(block.force, block.force.size());
  }
}

double CoupledModes::reach() const {
  double reach = blocks_.front().modes.reach(0, points_);
  if (blocks_.size() == 2) reach += blocks_.back().modes.reach(points_, 2 * points_);
  return reach;
}

double CoupledModes::energy() const { return vibration(0) + vibration(1); }

double CoupledModes::vibration(int body) const {
  double sum = 0.0;
  for (const Block& block : blocks_) {
    const std::vector<double> energies = block.modes.energies();
    std::size_t k = 0;
    for (std::size_t g = 0; g < block.end(body); ++g) {
      const std::size_t modes = block.contact.groups[g].omega.size();
      const auto first = energies.begin() + static_cast<std::ptrdiff_t>(k);
      if (g >= block.begin(body)) sum = std::accumulate(first, first + static_cast<std::ptrdiff_t>(modes), sum);
      k += modes;
    }
  }
  return sum;
}

double CoupledModes::dissipated(int body) const {
  double sum = 0.0;
  for (const Block& block : blocks_) {
    sum += block.modes.dissipated(block.begin(body), block.end(body));
    sum += block.residuals.dissipated()[static_cast<std::size_t>(body)];
  }
  return sum;
}

double CoupledModes::dissipated_above_cutoff() const {
  double sum = 0.0;
  for (const Block& block : blocks_) {
    const auto [first, second] = block.residuals.dissipated();
    sum += first + second;
  }
  return sum;
}

double CoupledModes::stored() const {
  double sum = 0.0;
  for (const Block& block : blocks_) {
    const auto [first, second] = block.residuals.stored();
    sum += first + second;
  }
  return sum;
}

std::vector<ModeEnergy> CoupledModes::ledger(const std::vector<double>& before, double samples, double initial) const {
  std::vector<ModeEnergy> ledger;
  for (const Block& block : blocks_) {
    const bool moved = &block == &blocks_.front() && !before.empty();
    const std::vector<double> after = block.modes.energies(), during = block.modes.accumulated_energy();
    for (std::size_t g = 0, k = 0; g < block.contact.groups.size(); ++g) {
      const ModeGroup& group = block.contact.groups[g];
      for (std::size_t l = 0; l < group.omega.size(); ++l, ++k) {
        ledger.push_back({g < block.contact.first_groups ? 0 : 1, group.order, static_cast<int>(l), group.omega[l],
                          moved ? before[k] / initial : 0.0, after[k] / initial, during[k] / (samples * initial)});
      }
    }
  }
  return ledger;
}

}  // namespace stoss
