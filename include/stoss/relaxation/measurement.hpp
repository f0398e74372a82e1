#pragma once

#include <vector>

#include "stoss/relaxation.hpp"

/// Relaxation of a material from what dynamic mechanical analysis (DMA) measures of it.
namespace stoss {

/// Moduli of a material at frequencies: E* = E′ + iE″, all for one unit of time and one of stress.
struct Moduli {
  std::vector<double> frequency;  ///< ω, rising
  std::vector<double> storage;    ///< E′
  std::vector<double> loss;       ///< E″
};

/// A relaxation that comes near measured moduli.
struct FittedRelaxation {
  Relaxation relaxation;
  double instantaneous = 0.0;   ///< E(0)
  double storage_misfit = 0.0;  ///< root mean square of its E′ over the measured one, less 1
  double loss_misfit = 0.0;     ///< of E″
};

/// Terms with times equally spaced on a logarithmic scale over the measured frequencies, three a decade and at most
/// most_relaxation_terms, whose shares fit E′ and E″, each relative to itself, by least squares with shares above 0.
/// Beyond the frequencies measured the material is taken as elastic.
/// @throws InvalidInput for fewer than three frequencies, and unless they rise and moduli are positive
[[nodiscard]] FittedRelaxation relaxation_of_measurement(const Moduli& measured);

/// The same material at another temperature: all times shift by a_T (Williams, Landel and Ferry 1955),
///
///   lg a_T = −c1 (T − T_r)/(c2 + T − T_r)
///
/// @param reference T_r, at which the relaxation is known @param c2 in the unit of the temperatures
/// @throws InvalidInput at T_r − c2 and below, where the law ends
[[nodiscard]] Relaxation shifted(const Relaxation& relaxation, double c1, double c2, double reference,
                                 double temperature);

}  // namespace stoss
