#include "contact/mode_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/group_loss.hpp"
#include "numeric/damped_oscillator.hpp"
#include "numeric/kernels.hpp"

namespace stoss {

namespace {

constexpr std::size_t lanes = numeric::kernels::lanes;

Relaxation of_second(const Contact& contact) {
  return contact.second == nullptr ? Relaxation{} : relaxation(contact, contact.groups.size());
}

}  // namespace

ModeTables::ModeTables(const Contact& contact, const ContactGrid& grid, double time_step, Kicks kicks)
    : mass(contact.mass),
      step(time_step),
      count(mode_count(contact)),
      nodes(grid.recess.size()),
      lasting_groups(stoss::lasting_groups(contact)),
      shapes(grid.shape),
      first_groups_(contact.first_groups) {
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
  if (stoss::loses(contact)) lose(contact, kicks);
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

/// Finds the decays that all modes of a group have in common: where a term hardly changes the modulus, its rate is that
/// of the material by itself, nearly the same in all modes. A common one has their mean rate, by what each adds to the
/// motion, so that the rest is of second order in what is allowed.
void ModeTables::find_common(std::size_t group) {
  constexpr double allowed = 3e-3;
  std::size_t decays = 0;
  const auto mode_of = [&](std::size_t l) -> const LossyOscillator& { return lossy.mode[position(group, l)]; };
  for (std::size_t l = 0; l < size[group]; ++l) decays = std::max(decays, mode_of(l).rate.size());
  std::vector<int>& places = lossy.place_of.emplace_back();
  std::vector<Lossy::Common>& common = lossy.common.emplace_back();
  int place = 0;
  for (std::size_t j = 0; j < decays; ++j) {
    double sum = 0.0, weight = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
    for (std::size_t l = 0; l < size[group]; ++l) {
      const LossyOscillator& mode = mode_of(l);
      if (mode.rate.size() <= j) continue;
      const std::size_t k = position(group, l);
      const double counts = std::abs(mode.residue[j]) * (upper[k] * upper[k] + lower[k] * lower[k]);
      sum += counts * mode.rate[j], weight += counts;
      lowest = std::min(lowest, mode.rate[j]), highest = std::max(highest, mode.rate[j]);
    }
    const double mean = weight > 0.0 ? sum / weight : 0.0;
    common.push_back({mean, std::exp(-mean * step), {}});
    const bool alike = highest - mean <= allowed * mean && mean - lowest <= allowed * mean;
    places.push_back(alike ? -1 : place++);
  }
}

/// Each block has as many decays for every mode as that of its groups with the most terms; beside a body that relaxes
/// or has layers one with a loss time has one that nothing moves, so that it is counted alike in every block.
void ModeTables::place_decays(const Contact& contact) {
  std::size_t all = 0;
  const bool layers = of_layers_[0] || of_layers_[1];
  const bool relaxes = layers || !lossy.rates[0].rate.empty() || !lossy.rates[1].rate.empty();
  for (std::size_t block = 0; block < blocks(); ++block) {
    std::size_t decays = 0;
    for (std::size_t g = block * lanes; g < std::min((block + 1) * lanes, contact.groups.size()); ++g) {
      const GroupLoss loss(contact, g);
      for (const int place : lossy.place_of[g]) decays = std::max(decays, static_cast<std::size_t>(place + 1));
      const bool lossy_otherwise = loss.is_of_layers() || loss.loss_time() > 0.0;
      if (relaxes && lossy_otherwise) decays = std::max<std::size_t>(decays, 1);
    }
    lossy.decay_begin.push_back(all);
    lossy.decay_count.push_back(decays);
    all += (begin[block + 1] - begin[block]) * decays;
  }
  for (auto* each : {&lossy.residue, &lossy.kept, &lossy.decay_rate}) each->resize(all);
}

/// Gives a mode the rates that it has in common with others, and adds it to their residues.
void ModeTables::take_common(std::size_t group, std::size_t index) {
  const std::size_t k = position(group, index);
  LossyOscillator& mode = lossy.mode[k];
  for (std::size_t j = 0; j < mode.rate.size(); ++j) {
    if (decay(group, index, j)) continue;
    Lossy::Common& its = lossy.common[group][j];
    mode.velocity += mode.residue[j] * (its.rate - mode.rate[j]);  // a kick is still one of 1
    mode.rate[j] = its.rate;
    const double residue = omega[k] * mode.residue[j];
    its.residue.upper += residue * upper[k] * upper[k];
    its.residue.mixed += residue * upper[k] * lower[k];
    its.residue.lower += residue * lower[k] * lower[k];
  }
}

void ModeTables::lose(const Contact& contact, Kicks kicks) {
  const std::size_t all = begin.back();
  lossy.rates = {Rates(contact.first->relaxation), Rates(of_second(contact))};
  of_layers_ = {!contact.first->layers.empty(), contact.second != nullptr && !contact.second->layers.empty()};
  if (of_layers_[0] || of_layers_[1]) lossy.of_layers.resize(all);
  lossy.velocity_cosine = cosine;
  lossy.mode.resize(all);
  lossy.place.resize(all);
  lossy.jump.resize(all, 1.0);
  lossy.speed.resize(all);
  lossy.due.resize(all, 0.5);
  lossy.rate.resize(all);
  lossy.work_due.resize(size.size());
  for (std::size_t g = 0; g < size.size(); ++g) {
    const GroupLoss loss(contact, g);
    for (std::size_t l = 0; l < size[g]; ++l) {
      const std::size_t k = position(g, l);
      LossyOscillator& mode = lossy.mode[k];
      FreeMode dashpot = loss.dashpot(l, step);
      double slower = 1.0;
      if (kicks == Kicks::weaker) {
        const numeric::StableKicks stable = numeric::stable_kicks(dashpot.frequency, dashpot.gamma, step);
        if (dashpot.gamma > 0.0) slower = stable.gamma / dashpot.gamma;
        dashpot.gamma = stable.gamma;
        upper[k] *= std::sqrt(stable.strength);
        lower[k] *= std::sqrt(stable.strength);
      }
      if (loss.is_of_layers()) {
        lossy.of_layers[k] = loss.rates(l);
        lossy.of_layers[k].viscous *= slower;
      }
      if (const Rates* rates = rates_of(g, l)) {
        mode = relaxing_oscillator(omega[k], *rates);
      } else {
        mode = kelvin_voigt_oscillator(omega[k], loss.loss_time());
        mode.gamma = dashpot.gamma;
      }
    }
  }
  for (std::size_t g = 0; g < size.size(); ++g) find_common(g);
  place_decays(contact);
  for (std::size_t g = 0; g < size.size(); ++g) {
    for (std::size_t l = 0; l < size[g]; ++l) {
      const std::size_t k = position(g, l);
      LossyOscillator& mode = lossy.mode[k];
      take_common(g, l);
      const auto [kept, coupling, velocity] = numeric::damped_motion(mode.frequency, mode.gamma, step);
      cosine[k] = kept;
      sine[k] = coupling;
      lossy.velocity_cosine[k] = velocity;
      lossy.place[k] = omega[k] * mode.place;
      lossy.jump[k] = omega[k] / mode.frequency * mode.velocity;
      lossy.speed[k] = mode.frequency;
      lossy.due[k] = mode.share_due(step);
      lossy.rate[k] = 2.0 * mode.gamma * omega[k] * step;
      lossy.work_due[g].upper += omega[k] * lossy.due[k] * upper[k] * upper[k];
      lossy.work_due[g].mixed += omega[k] * lossy.due[k] * upper[k] * lower[k];
      lossy.work_due[g].lower += omega[k] * lossy.due[k] * lower[k] * lower[k];
      for (std::size_t j = 0; j < mode.rate.size(); ++j) {
        const auto at = decay(g, l, j);
        if (!at) continue;
        lossy.residue[*at] = omega[k] * mode.residue[j];
        lossy.kept[*at] = std::exp(-mode.rate[j] * step);
        lossy.decay_rate[*at] = mode.rate[j];
      }
    }
  }
}

std::optional<std::size_t> ModeTables::decay(std::size_t group, std::size_t index, std::size_t number) const {
  const std::size_t block = group / lanes;
  const int place = lossy.place_of[group][number];
  if (place < 0) return std::nullopt;
  const auto of_mode = index * lossy.decay_count[block] + static_cast<std::size_t>(place);
  return lossy.decay_begin[block] + of_mode * lanes + group % lanes;
}

const Rates* ModeTables::rates_of(std::size_t group, std::size_t index) const {
  const std::size_t body = group < first_groups_ ? 0 : 1;
  if (of_layers_[body]) return &lossy.of_layers[position(group, index)];
  return lossy.rates[body].rate.empty() ? nullptr : &lossy.rates[body];
}

bool ModeTables::relaxes(std::size_t block) const {
  const std::size_t end = std::min((block + 1) * lanes, lossy.place_of.size());
  for (std::size_t g = block * lanes; g < end; ++g) {
    if (!lossy.place_of[g].empty()) return true;
  }
  return lossy.decay_count[block] > 0;
}

std::size_t ModeTables::position(std::size_t group, std::size_t index) const {
  return begin[group / lanes] + index * lanes + group % lanes;
}

}  // namespace stoss
