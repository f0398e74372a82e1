#pragma once

#include <functional>

namespace adhesion_study {

/// What a law between two faces says at a gap: pressure (above 0: a push), its slope, and the energy of a unit of area,
/// which is 0 far away.
struct Response {
  double pressure, slope, energy;
};

using Law = std::function<Response(double gap)>;

/// p = P (e^{−g/ru} − e^{−g/u}) with the work of adhesion w = Pu(1 − r): a pull of the range u and a push of the range
/// ru. The faces do not act on each other at g = 0. Its greatest pull is (w/u) r^{r/(1−r)}, its steepest softening
/// (w/u²) r^{2r/(1−r)}; with r = ½ they are w/2u and w/4u².
[[nodiscard]] Law exponential_law(double work, double range, double ratio = 0.5);

/// p = (8w/3z₀) ((z₀/z)⁹ − (z₀/z)³), z = g + z₀: faces of Lennard-Jones' molecules.
[[nodiscard]] Law lennard_jones(double work, double distance);

/// A push alone, p = P e^{−g/u}: elastic asperities.
[[nodiscard]] Law asperities(double pressure, double range);

/// z₀ of the Lennard-Jones law whose greatest pull is this, of the same work: 16w/(9√3 σ).
[[nodiscard]] double distance_of_pull(double work, double pull);

/// Range u of the exponential law which has the greatest pull of Lennard-Jones' law of the Tabor number
/// μ = (Rw²/E*²z₀³)^{1/3}, R = 1. Maugis' number is then 1.157 μ for all ratios.
[[nodiscard]] double range_of(double tabor, double work, double modulus, double ratio = 0.5);

}  // namespace adhesion_study
