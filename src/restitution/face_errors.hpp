#pragma once

#include "restitution/error_bar.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/restitution/restitution.hpp"

/// What the nodes of one run leave open between rough or coated faces (docs/developer/numerics.md, section 16). All are
/// empty between others.
namespace stoss {

/// Whether the first grid of a contact leaves a sharp edge: always between smooth faces.
[[nodiscard]] bool leaves_edge(const Contact& contact, double speed);

/// Share of the smooth edge's law that is left on the grid of a run; 1 between smooth faces.
[[nodiscard]] double edge_left(const Contact& contact, double speed, const Run& run);

/// Error of 1 − ε².
[[nodiscard]] Term lost_error_of_faces(const Contact& contact, double speed, const Run& run);

/// Error of the maximum compression, R: what its correction for the spacing of nodes (touch_compression) leaves.
[[nodiscard]] Term compression_error_of_faces(const Contact& contact, const Run& run);

/// Error of the maximum force or of the time of the impulse.
[[nodiscard]] Term pulse_error_of_faces(const Contact& contact, const Run& run, double quantity);

}  // namespace stoss
