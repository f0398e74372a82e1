#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "stoss/encounter/encounter.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/poll.hpp"

/// What is seen inside the bodies when an impact is repeated.
namespace stoss {

/// A field by its name: instants, one after another, and for each the points.
using NamedField = std::pair<std::string_view, std::vector<double>>;

/// Inside a disk or a sphere at several instants, in units of the first body: displacements along r and φ or θ,
/// stresses, von Mises stress and principal difference, on radii × angles.
struct InnerFields {
  std::vector<NamedField> fields;
  std::vector<double> center;  ///< of the body, R of the first
  double size = 1.0;           ///< R of the body
};

/// @param number 0: inside the first body, 1: inside the second
/// @param radius 0 … 1 of the body; @param angle from the contact, radians
/// @throws InvalidInput unless it is an elastic disk or sphere, and for points outside it
[[nodiscard]] InnerFields inner_fields(const Encounter& encounter, int number, const Contact& contact,
                                       const Impact& impact, const std::vector<Frame>& frames,
                                       const std::vector<double>& radius, const std::vector<double>& angle,
                                       const Poll& poll = {});

/// Energy of a mode at some time, as a share of the initial energy.
struct ModeShare {
  int body = 0;  ///< 0: of the first, 1: of the second
  int order = 0;
  int index = 0;
  double omega = 0.0;
  double energy = 0.0;
};

/// Those of all kept modes at some times: times × modes. @param times ascending, R/c
[[nodiscard]] std::vector<ModeShare> mode_shares(const Contact& contact, const Impact& impact,
                                                 const std::vector<double>& times, const Poll& poll = {});

}  // namespace stoss
