#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "stoss/contact/contact.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/impact/state.hpp"
#include "stoss/poll.hpp"

namespace stoss {

/// Strain above which results are flagged: linear elasticity leaves out what is of the order of the strain, here a
/// tenth. It is some 0.1 c of what meets a rigid wall, and a contact of half the radius, a = R/2.
inline constexpr double small_strain_limit = 0.1;

/// How an impact is computed, and from where.
struct ImpactOptions {
  Resolution resolution{};
  std::optional<State>
      start{};  ///< of velocity `speed`, as `approach` makes it; otherwise unexcited, just out of contact
  Poll poll{};
};

/// One instant of an impact. Energies are shares of the initial energy.
struct Snapshot {
  double time = 0.0;                   ///< R/c, from the start
  double center = 0.0;                 ///< x₀, R
  double velocity = 0.0;               ///< of the centre, towards the wall, c
  double force = 0.0;                  ///< F, πRE = mc²/R
  double translation = 0.0;            ///< ½mv²
  double vibration = 0.0;              ///< of the kept modes
  double stored = 0.0;                 ///< in the wall's potential, the quasistatic tail or a lossy one
  double dissipated = 0.0;             ///< lost to the material so far
  double yielded = 0.0;                ///< taken by plastic flow so far
  double unresolved = 0.0;             ///< taken by the modes above the cutoff
  double contact_half_width = 0.0;     ///< R
  std::span<const double> coordinate;  ///< Q, on request; valid during the call
  std::span<const double> momentum;    ///< P, on request; valid during the call
  std::span<const double> node_force;  ///< share of each contact node in F, on request; valid during the call

  /// Node forces that would displace the modes that are not kept of the first and of the second body at once as they
  /// are: node_force, unless a material creeps. On request; valid during the call.
  std::array<std::span<const double>, 2> crept_force{};
};

/// Receives the instants of an impact in order of time. What it throws ends the impact and reaches
/// the caller.
using ImpactObserver = std::function<void(const Snapshot&)>;

/// What is seen of an impact.
struct Observation {
  ImpactObserver observer{};
  int every = 1;       ///< the observer sees the first instant, every so many steps, and the last
  bool modes = false;  ///< fill Snapshot::coordinate, momentum and the forces
  std::function<bool(double time)> wanted{};  ///< whether it sees an instant after the first, R/c; empty: all of these
};

/// Energy of one kept mode, as shares of the initial energy.
struct ModeEnergy {
  int body = 0;          ///< 0: of the first, 1: of the second
  int order = 0;         ///< n
  int index = 0;         ///< l
  double omega = 0.0;    ///< c/R
  double before = 0.0;   ///< before the impact
  double after = 0.0;    ///< after the impact
  double average = 0.0;  ///< mean over every fourth step in contact
};

/// Where the energy is after the impact, as shares of the initial energy; the sum is 1 but for energy_error. Of a body
/// that stays on a plate or strip: at rest on it, when the waves have taken what it had.
struct EnergyLedger {
  double translation = 0.0;
  double vibration = 0.0;   ///< of the kept modes; in a lossy body it will become heat
  double dissipated = 0.0;  ///< lost to the material, with what one that relaxes still holds at the end
  double yielded = 0.0;     ///< taken by plastic flow
  double unresolved = 0.0;  ///< of the modes above the cutoff (radiating tail)
  double stored = 0.0;  ///< left in the exponential wall's potential, < 1e-10, and in the tail of a Kelvin–Voigt body
  double lost_to_first = 0.0;     ///< what the first body vibrates with, takes and holds, and of `unresolved`
  double lost_to_second = 0.0;    ///< the same of the second; 0 at a wall
  std::vector<ModeEnergy> modes;  ///< in the order of Contact::groups
};

/// One impact at a fixed resolution, with the inputs that made it.
struct Impact {
  std::string contact;  ///< name of what met
  Wall wall;
  double speed = 0.0;   ///< c
  double cutoff = 0.0;  ///< c/R
  FixedResolution resolution;
  double restitution = 0.0;    ///< ε = −v_f / v_i
  double lost_fraction = 0.0;  ///< 1 − ε²
  EnergyLedger energy;
  double remaining = 0.0;     ///< of a body that stays on a plate or strip, whose ε is given as 0: the largest share
                              ///< of its energy that it may leave with; else 0
  double contact_time = 0.0;  ///< from the first force to the last, R/c: bodies that touch and do not push are not
                              ///< in contact, nor flat ends below 2 % of the greatest force
  double impulse_time = 0.0;  ///< from 1 % to 99 % of the impulse, R/c: no matter when a last grazing contact ends
  int contacts = 0;           ///< separate periods of contact
  double max_force = 0.0;     ///< largest mean over about one step, πRE = mc²/R; of rods, whose force jumps, over
                              ///< the period of the highest modes. Of a ball at a wall 4 % above Hertz' at 0.001 c,
                              ///< 6 % at 0.004 c: a whole ball is stiffer than a point contact (theory/points.md)
  double max_compression = 0.0;  ///< R, beyond the wall; beyond the plane V₀e^{αx} = 1 of an exponential one
  double max_half_width = 0.0;   ///< of the contact, R
  double dent = 0.0;             ///< depth of the dent that plastic flow leaves, R
  double momentum_error = 0.0;   ///< |impulse − change of momentum| / (m v)
  double energy_error = 0.0;     ///< 1 − sum of the ledger
  long steps = 0;
  double strain = 0.0;  ///< greatest of the bodies, estimated: v/c of each one's part in the approach, √(2E/m)/c of the
                        ///< vibration before, F/EA of a rod, 0.2 a/R near a contact of Hertz' pressure (a sphere at a
                        ///< wall; 0.47 p/E* in general), the same in each layer of a plate, its bending, and half of
                        ///< the compression over its thickness (docs/theory/impact.md#strain)
  bool beyond_small_strain = false;  ///< strain > small_strain_limit: linear elasticity is no longer accurate
  std::optional<State> start;        ///< where it was given
  State final_state;  ///< with modes as they swing on, without what a material that relaxes holds in them; where a part
                      ///< of a body is there (BodyPart), that of the part
};

/// Computes one impact, by kick–rotate–kick with the force of the contact. It starts just out of contact and ends when
/// no later contact is possible: the bodies part, and no combination of their modes' phases can bring them together
/// again (docs/theory/impact.md). Contacts that follow one another while they vibrate are one impact. A ball that still
/// lies on a plate when the time for which the plate was made is over stays there, if it has hardly any energy left, or
/// if Zener's law says so and it moves by it.
/// @param speed of approach, of the centre of mass to the wall or of two centres to each other, 1e-8 … 1, in c. Two
///              equal bodies are one at a wall at half of it.
/// @throws InvalidInput for arguments out of range; NotConverged if the contact cannot be solved or does not end
[[nodiscard]] Impact impact(const Contact& contact, double speed, const ImpactOptions& options = {},
                            const Observation& observation = {});
[[nodiscard]] Impact impact(const Body& body, const Wall& wall, double speed, const ImpactOptions& options = {},
                            const Observation& observation = {});

/// Greatest strain that Hertz' theory expects of an impact, as Impact::strain.
[[nodiscard]] double expected_strain(const Contact& contact, double speed);

}  // namespace stoss
