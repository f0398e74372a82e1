#pragma once

#include <array>
#include <memory>
#include <optional>

#include "stoss/body/body.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"

namespace stoss {

/// Contact points at the left and at the right face of a body, as it sees them; none where a face meets nothing.
using FacePoints = std::array<std::optional<ContactPoints>, 2>;

/// The modes of a body by itself, which are those of a contact with the points of both its faces: first of the left
/// one, where a mode moves ±Q s_i (opposite_share), then of the right one. One face alone is as in a pair.
struct FaceModes {
  Contact contact;
  ContactGrid grid;  ///< its shapes alone
};

[[nodiscard]] FaceModes face_modes(const std::shared_ptr<const Body>& body, const FacePoints& points);

}  // namespace stoss
