#pragma once

#include "stoss/body.hpp"
#include "stoss/impact.hpp"

namespace stoss {

/// A body at the two resolutions from which restitution takes its value and its error.
struct RefinedBody {
  Body coarse;
  Body fine;
};

/// Makes a body with all modes up to ω = 25 and up to ω = 50.
/// @throws what the maker throws
[[nodiscard]] RefinedBody refine(const BodyMaker& maker);

/// The coefficient of restitution against a hard wall, with estimated errors. Numbers as in Impact.
struct Restitution {
  double value = 0.0;                ///< ε
  double error = 0.0;                ///< of ε, from that of 1 − ε²
  double lost_fraction = 0.0;        ///< 1 − ε²
  double lost_fraction_error = 0.0;  ///< see restitution
  Impact finest;                     ///< the impact with the finer body, and its inputs
  long steps = 0;                    ///< of both impacts
};

/// ε of a body that meets a hard wall, from two impacts with the radiating tail: the finer one gives the value; the
/// larger of their difference in 1 − ε² and the finer one's energy error gives the error.
/// @param speed of the centre of mass towards the wall, 1e-8 … 1, in c
/// @throws InvalidInput, NotConverged as impact
[[nodiscard]] Restitution restitution(const RefinedBody& body, double speed);

/// The same for one speed only.
[[nodiscard]] Restitution restitution(const BodyMaker& maker, double speed);

}  // namespace stoss
