#include "impact/oblique/parity_block.hpp"

#include <algorithm>

#include "contact/response.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

ParityBlock::ParityBlock(const Contact& along, const ContactPoints& points, const FixedResolution& resolution,
                         const Poll& poll)
    : ParityBlock(along, contact_grid(along, points), resolution, poll) {}

ParityBlock::ParityBlock(const Contact& along, const ContactGrid& grid, const FixedResolution& resolution,
                         const Poll& poll)
    : contact(along),
      modes(along, grid, resolution.step, follows_at_once(along, resolution.tail) ? Kicks::weaker : Kicks::whole),
      residuals(along, grid, ResidualMotion::Inertia::all, resolution.step, poll),
      force(grid.recess.size()),
      displacement(grid.recess.size()),
      moved_(grid.recess.size()) {}

const std::vector<double>& ParityBlock::place() {
  std::fill(moved_.begin(), moved_.end(), 0.0);
  modes.add_displacement(moved_);
  return moved_;
}

double ParityBlock::vibration(int body) const {
  const std::vector<double> energies = modes.energies();
  double sum = 0.0;
  std::size_t k = 0;
  for (std::size_t g = 0; g < end(body); ++g) {
    for (std::size_t l = 0; l < contact.groups[g].omega.size(); ++l, ++k) {
      if (g >= begin(body)) sum += energies[k];
    }
  }
  return sum;
}

double ParityBlock::dissipated(int body) const {
  return modes.dissipated(begin(body), end(body)) + residuals.dissipated()[static_cast<std::size_t>(body)];
}

}  // namespace stoss
