// Strain of plates, in orders of magnitude:
//
//   layers    (0.47 + 1.5 (a/(a + h))²) p/E*   0.47 p/E* as near any contact; 2p/E* where the layer is much thinner
//   than
//                                             the contact and takes its pressure, at most 2p, as a whole. The pressure
//                                             spreads with the depth z: that of a contact of a half-width a + z
//   bending   F/Eh²                            of a plate (Timoshenko and Woinowsky-Krieger, Theory of Plates and
//   Shells,
//                                             section 19: stress under a load on a small circle)
//             1.3 F √(ct/h)/Eh                 of a strip, on which the load has been for t (Euler's beam, 6M/Eh²)
//   stretch   δ/2h                             of a plate that gives way by δ: it bends as linear theory has it up to
//                                             some 0.2 h, and stretches beyond
#include "bodies/plate/strain.hpp"

#include <algorithm>
#include <cmath>

namespace stoss::bodies::plate {

double strain_under(const Given& given, const Load& load) {
  constexpr double squeezed = 1.5, stretched = 0.5, bent = 1.3;
  const bool ball = given.contour == Contour::ball;
  const double unit = given.layers.front().young;
  double greatest = 0.0, depth = 0.0, stiffness = 0.0;
  for (const Layer& layer : given.layers) {
    const double softness = (ball ? 1.0 - layer.poisson * layer.poisson : 1.0) * unit / layer.young;
    Load here = load;
    here.half_width += depth;
    const double wide = here.half_width / (here.half_width + layer.thickness);
    greatest =
        std::max(greatest, (strain_of_contact + squeezed * wide * wide) * softness * pressure(given.contour, here));
    depth += layer.thickness;
    stiffness += layer.thickness * layer.young / unit;
  }
  if (std::isinf(depth)) return greatest;
  const double bending = load.force / (stiffness * depth);
  const double longer = ball ? 1.0 : bent * std::sqrt(load.duration * depth);
  return std::max({greatest, longer * bending, stretched * load.compression / depth});
}

}  // namespace stoss::bodies::plate
