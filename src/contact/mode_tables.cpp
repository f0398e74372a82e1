#include "contact/mode_tables.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/damped_oscillator.hpp"
#include "numeric/kernels.hpp"

namespace stoss {

namespace {

constexpr std::size_t lanes = numeric::kernels::lanes;

}  // namespace

ModeTables::ModeTables(const Contact& contact, const ContactGrid& grid, double time_step, Kicks kicks)
    : mass(contact.mass),
      step(time_step),
      count(mode_count(contact)),
      nodes(grid.recess.size()),
      lasting_groups(stoss::lasting_groups(contact)),
      shapes(grid.shape) {
  place_groups(contact);
  for (auto* array : {&omega, &cosine}) array->resize(begin.back(), 1.0);
  for (auto* array : {&sine, &upper, &lower}) array->resize(begin.back(), 0.0);
  for (std::size_t g = 0; g < size.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    amplitude_of.push_back(std::sqrt(mass / modal_mass(contact, g)));
    for (std::size_t l = 0; l < size[g]; ++l) {
      const std::size_t k = position(g, l);
      const double frequency = group.omega[l];
      omega[k] = frequency;
      cosine[k] = std::cos(frequency * time_step);
      sine[k] = std::sin(frequency * time_step);
      upper[k] = group.upper[l] / std::sqrt(frequency);
      lower[k] = group.lower[l] / std::sqrt(frequency);
    }
  }
  if (longest_loss_time(contact) > 0.0) damp(contact, kicks);
  place_rows(contact);
}

void ModeTables::place_groups(const Contact& contact) {
  const std::size_t groups = contact.groups.size();
  begin.push_back(0);
  for (std::size_t first = 0; first < groups; first += lanes) {
    std::size_t longest = 0;
    for (std::size_t g = first; g < std::min(first + lanes, groups); ++g) {
      size.push_back(contact.groups[g].omega.size());
      longest = std::max(longest, size.back());
    }
    begin.push_back(begin.back() + longest * lanes);
  }
}

void ModeTables::place_rows(const Contact& contact) {
  const auto place = [this](std::size_t at, std::size_t row) {
    if (!runs.empty() && runs.back().at + runs.back().count == at && runs.back().row + runs.back().count == row) {
      ++runs.back().count;
    } else {
      runs.push_back({at, row, 1});
    }
  };
  for (std::size_t g = 0; g < size.size(); ++g) place(g, contact.groups[g].upper_row);
  for (std::size_t g = 0; g < size.size(); ++g) place(blocks() * lanes + g, contact.groups[g].lower_row);
  for (const ModeGroup& group : contact.groups) shapes_of.push_back({group.upper_row, group.lower_row});
  const std::size_t given = shapes.size() / nodes;
  rows = (given + lanes - 1) / lanes * lanes;
  shapes_by_node.resize(rows * nodes);
  for (std::size_t row = 0; row < given; ++row) {
    for (std::size_t i = 0; i < nodes; ++i) shapes_by_node[i * rows + row] = shapes[row * nodes + i];
  }
}

void ModeTables::damp(const Contact& contact, Kicks kicks) {
  velocity_cosine = cosine;
  rate.resize(cosine.size());
  due.resize(cosine.size());
  for (std::size_t g = 0; g < size.size(); ++g) {
    const double loss = loss_time(contact, g);
    for (std::size_t l = 0; l < size[g]; ++l) {
      const std::size_t k = position(g, l);
      double gamma = 0.5 * loss * omega[k] * omega[k];
      if (kicks == Kicks::weaker) {
        const numeric::StableKicks stable = numeric::stable_kicks(omega[k], gamma, step);
        gamma = stable.gamma;
        upper[k] *= std::sqrt(stable.strength);
        lower[k] *= std::sqrt(stable.strength);
      }
      const auto [kept, coupling, velocity] = numeric::damped_motion(omega[k], gamma, step);
      due[k] = numeric::share_due(omega[k], gamma, step);
      rate[k] = 2.0 * gamma * omega[k] * step;
      cosine[k] = kept;
      sine[k] = coupling;
      velocity_cosine[k] = velocity;
    }
  }
}

std::size_t ModeTables::position(std::size_t group, std::size_t index) const {
  return begin[group / lanes] + index * lanes + group % lanes;
}

}  // namespace stoss
