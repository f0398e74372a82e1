#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "relaxation/oscillator.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// How a lossy contact kicks its modes.
enum class Kicks {
  whole,
  weaker  ///< by as much as the modes follow the force at once in addition (numeric::StableKicks)
};

/// What the kept modes of all impacts on one grid with one step Δt share, in the order in which they are advanced
/// (numeric::kernels::Oscillators): places without a mode hold an oscillator that nothing moves.
struct ModeTables {
  ModeTables(const Contact& contact, const ContactGrid& grid, double time_step, Kicks kicks);

  /// Place of a mode in the arrays over modes.
  [[nodiscard]] std::size_t position(std::size_t group, std::size_t index) const;

  [[nodiscard]] std::size_t blocks() const { return begin.size() - 1; }

  double mass;
  double step;
  std::size_t count;
  std::size_t nodes;
  std::size_t lasting_groups;        // of bounded bodies
  std::vector<std::size_t> size;     // modes of each group
  std::vector<std::size_t> begin;    // of each block of groups in the arrays over modes, and the end
  std::vector<double> omega;         // 1 where there is no mode
  std::vector<double> cosine, sine;  // what a free step makes of a
  std::vector<double> upper, lower;  // weights over √ω
  /// Of a contact that loses energy, else empty: each mode by itself, and what kernels::advance_damped takes and, of
  /// the blocks with a body that relaxes, kernels::advance_relaxing.
  struct Lossy {
    std::vector<LossyOscillator> mode;
    std::array<Rates, 2> rates{};  // of both bodies, without terms where it does not relax or has layers
    std::vector<Rates> of_layers;  // of each mode of a contact with a body of layers
    std::vector<double> velocity_cosine, due, rate;
    std::vector<double> place, jump, speed;
    std::vector<double> residue, kept, decay_rate;
    std::vector<std::size_t> decay_begin, decay_count;  // of each block
    struct Due {
      double upper = 0.0, mixed = 0.0, lower = 0.0;
    };
    std::vector<Due> work_due;  // of each group, per product of kicks: by the due share of kicks in their work
    /// A decay that all modes of a group have in common, but for what a kick adds to it: by residues over kicks.
    struct Common {
      double rate, kept;
      Due residue;  // Σ over the modes, of products of weights
    };
    std::vector<std::vector<int>> place_of;   // of each group: of each decay of a mode, −1 where it is a common one
    std::vector<std::vector<Common>> common;  // of each group: of each decay, of which those of −1 matter
  } lossy;
  [[nodiscard]] bool loses() const { return !lossy.mode.empty(); }

  /// Whether a block has decays.
  [[nodiscard]] bool relaxes(std::size_t block) const;

  /// Place of a decay in their arrays; nothing of one that the group has in common.
  [[nodiscard]] std::optional<std::size_t> decay(std::size_t group, std::size_t index, std::size_t number) const;

  /// The rates of a mode in a body that relaxes; else null.
  [[nodiscard]] const Rates* rates_of(std::size_t group, std::size_t index) const;

  std::vector<double> amplitude_of;  // of each group: Q of its body over that of the contact, √(mass/modal mass)
  struct Rows {
    std::size_t upper, lower;
  };
  std::vector<Rows> shapes_of;  // each group
  struct Run {
    std::size_t at, row, count;
  };
  std::vector<Run> runs;               // sums over groups (kernels::advance) that are neighbours in the rows too
  std::size_t rows;                    // padded to whole vectors
  std::vector<double> shapes;          // rows × nodes, without the padding
  std::vector<double> shapes_by_node;  // nodes × rows

 private:
  void place_groups(const Contact& contact);
  void place_rows(const Contact& contact);
  void lose(const Contact& contact, Kicks kicks);
  void place_decays(const Contact& contact);
  void find_common(std::size_t group);
  void take_common(std::size_t group, std::size_t index);

  std::size_t first_groups_;
  std::array<bool, 2> of_layers_{};  // each body
};

}  // namespace stoss
