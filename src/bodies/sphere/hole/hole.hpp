#pragma once

#include <memory>
#include <vector>

#include "bodies/residual.hpp"
#include "bodies/sphere/along/toroidal.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/poll.hpp"

namespace stoss::bodies::sphere {

inline constexpr double max_hollow_cutoff = 400.0, max_inner = 0.99;

/// Throws InvalidInput for b outside 0 … 0.99.
void require_inner(double inner);

/// A concentric hole in a sphere, of the radius b: its modes with it, and what its static response has more. Without a
/// hole all is that of the solid sphere; with one too, but for the degrees whose fields reach so deep
/// (docs/theory/spheres.md).
class Hole {
 public:
  /// None.
  Hole() = default;

  /// @param inner b, 0 … 0.99
  Hole(double poisson, double inner);

  [[nodiscard]] double inner() const { return inner_; }

  /// Modes with 0 < ω ≤ cutoff as `modes` and `toroidal_modes` of a solid sphere list and normalise them.
  [[nodiscard]] std::vector<Mode> modes(double poisson, double cutoff, const Poll& poll) const;
  [[nodiscard]] std::vector<ToroidalMode> toroidal_modes(double poisson, double cutoff, const Poll& poll) const;

  /// Σ_l (U, V)(U, V)ᵀ/ω² and /ω⁴ over all modes, by degree, less those of the solid sphere; computed when first asked.
  [[nodiscard]] const OrderExcess& excess(const Poll& poll) const;

  /// The same of toroidal modes, Σ_l W²/ω² and /ω⁴.
  struct Toroidal {
    std::vector<double> compliance{}, second_moment{};
  };
  [[nodiscard]] const Toroidal& toroidal_excess(const Poll& poll) const;

 private:
  struct Answers;
  double inner_ = 0.0;
  std::shared_ptr<Answers> answers_;
};

}  // namespace stoss::bodies::sphere
