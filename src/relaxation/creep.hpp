#pragma once

#include <cstddef>
#include <vector>

#include "relaxation/zeros.hpp"

namespace stoss {

/// Strain under a stress over that of the elastic material, 1/M(s): what follows it at once, and what creeps after it,
///
///   u = glass d + Σ U_j,   U̇_j = fluidity_j d − rate_j U_j,
///
/// with d the elastic strain. Kelvin and Voigt's material has glass = 0 and one term of 1/η.
struct Creep {
  struct Term {
    double fluidity, rate;
  };
  double glass = 1.0;
  std::vector<Term> terms{};
};

[[nodiscard]] Creep kelvin_voigt_creep(double loss_time);
[[nodiscard]] Creep creep(const Rates& rates);

/// What creeps in steps of one length, in each of some values, by the backward differentiation formula of second order
/// (BDF2): U_j = (fluidity Δt d + 2U_j′ − ½U_j″)/(3/2 + rate Δt), with ′ and ″ one and two steps before.
class CreepMemory {
 public:
  CreepMemory(const Creep& creep, double step, std::size_t size);

  /// u = share d + what is remembered
  [[nodiscard]] double share() const { return share_; }

  /// What is remembered at the end of the step that begins.
  const std::vector<double>& predict();

  /// Ends the step with a strain of which predict() is a part.
  void follow(const std::vector<double>& strain);

  /// Ends the step with the elastic strain, of which predict() need not be known.
  void take(const std::vector<double>& elastic);

  /// Goes on for some time with no elastic strain.
  void fade(double time);

  /// The elastic strain d of the last step.
  [[nodiscard]] const std::vector<double>& elastic() const { return elastic_; }

  /// u: what follows d at once, and what has crept.
  [[nodiscard]] std::vector<double> crept() const;

  /// Σ_i ½ (glass d_i d*_i + Σ_j U_j U*_j rate/fluidity), with the same of a second memory of equal creep: the energy
  /// of the springs where the one is of strains, the other of stresses.
  [[nodiscard]] double energy(const CreepMemory& stress) const;

 private:
  struct Term {
    double driven, kept;  // fluidity Δt and 1 over 3/2 + rate Δt
    double stiffness;     // rate/fluidity
    double rate;
    std::vector<double> last, before;
  };
  double glass_, share_;
  std::vector<Term> terms_;
  std::vector<double> elastic_, remembered_;
};

}  // namespace stoss
