// A mode moves the right face towards what meets it by Q s_i, and the left one by ±Q s_i.
#include "row/face_modes.hpp"

#include <vector>

namespace stoss {
namespace {

/// The modes of a body as those of a contact by itself. Those of a rod go by turns with either sign to its other end,
/// and make a group of each.
Contact alone(const std::shared_ptr<const Body>& body, bool both_faces) {
  Contact its;
  its.first = body;
  its.mass = body->mass;
  its.whole_mass = whole_mass(*body);
  its.extent = body->extent;
  its.cutoff = body->cutoff;
  its.stable_step = body->stable_step;
  if (!both_faces || body->contour != Contour::flat) {
    its.groups = body->groups;
  } else {
    for (const ModeGroup& whole : body->groups) {
      for (const double sign : {1.0, -1.0}) {
        ModeGroup& part = its.groups.emplace_back();
        part.order = whole.order;
        part.upper_row = part.lower_row = sign > 0.0 ? 0 : 1;
        for (std::size_t l = 0; l < whole.omega.size(); ++l) {
          if (opposite_share(*body, whole, l) != sign) continue;
          part.omega.push_back(whole.omega[l]);
          part.upper.push_back(whole.upper[l]);
          part.lower.push_back(whole.lower[l]);
          part.index.push_back(static_cast<int>(l));
        }
      }
    }
  }
  its.first_groups = its.groups.size();
  return its;
}

/// What moving a row of Surface::shape at this face moves at the other.
std::vector<double> signs(const Contact& contact, std::size_t rows) {
  std::vector<double> sign(rows, 1.0);
  for (const ModeGroup& group : contact.groups) {
    const bool flat = contact.first->contour == Contour::flat;
    const double its = flat ? (group.upper_row == 0 ? 1.0 : -1.0) : opposite_share(*contact.first, group, 0);
    sign[group.upper_row] = sign[group.lower_row] = its;
  }
  return sign;
}

}  // namespace

FaceModes face_modes(const std::shared_ptr<const Body>& body, const FacePoints& points) {
  const bool both = points[0] && points[1];
  FaceModes made{alone(body, both), {}};
  std::array<Surface, 2> surface;
  std::array<std::size_t, 2> count{};
  for (std::size_t f = 0; f < 2; ++f) {
    if (points[f]) surface[f] = body->surface(*points[f]), count[f] = points[f]->count;
  }
  made.grid.recess.resize(count[0] + count[1]);
  const std::size_t last = points[1] ? 1 : 0, given = surface[last].shape.size() / count[last];
  const bool split = made.contact.groups.size() != body->groups.size();
  const std::size_t rows = split ? 2 * given : given;
  const std::vector<double> sign = signs(made.contact, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t f = 0; f < 2; ++f) {
      const double share = both && f == 0 ? sign[row] : 1.0;
      for (std::size_t i = 0; i < count[f]; ++i) {
        made.grid.shape.push_back(share * surface[f].shape[(row % given) * count[f] + i]);
      }
    }
  }
  return made;
}

}  // namespace stoss
