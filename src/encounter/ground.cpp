#include "encounter/ground.hpp"

#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "stoss/bodies/plate/field.hpp"
#include "stoss/errors.hpp"

namespace stoss::ground {
namespace {

namespace half_space = bodies::half_space;

template <typename Kind>
constexpr bool has_layers = std::is_same_v<Kind, Plate> || std::is_same_v<Kind, Strip>;

template <typename Kind>
constexpr bool is_block = std::is_same_v<Kind, HalfSpace> || std::is_same_v<Kind, HalfPlane>;

template <typename Kind>
constexpr Contour contour =
    std::is_same_v<Kind, HalfSpace> || std::is_same_v<Kind, Plate> ? Contour::ball : Contour::cylinder;

/// Calls visit with the solid, which is a ground.
template <typename Visit>
auto visit_ground(const Solid& solid, const Visit& visit) {
  using Result = decltype(visit(HalfSpace{}));
  return std::visit(
      [&](const auto& its) -> Result {
        using Kind = std::decay_t<decltype(its)>;
        if constexpr (is_block<Kind> || has_layers<Kind>) {
          return visit(its);
        } else {
          throw InvalidInput::out_of_range("against", "a body that has an end",
                                           "a half-space, a half-plane, a plate or a strip");
        }
      },
      solid);
}

template <typename Kind>
std::vector<half_space::ElasticLayer> layers_of(const Kind& its) {
  constexpr double end = std::numeric_limits<double>::infinity();
  if constexpr (is_block<Kind>) {
    return {{end, its.poisson, 1.0}};
  } else {
    double depth = its.thickness;
    std::vector<half_space::ElasticLayer> all{{depth, its.poisson, 1.0}};
    if constexpr (std::is_same_v<Kind, Plate>) {
      for (const Layer& layer : its.below) {
        depth += layer.thickness;
        all.push_back({depth, layer.poisson, layer.young / its.young});
      }
    }
    return all;
  }
}

}  // namespace

bool is_unbounded(const Solid& solid) {
  return std::visit(
      [](const auto& its) {
        using Kind = std::decay_t<decltype(its)>;
        return is_block<Kind> || has_layers<Kind>;
      },
      solid);
}

FieldBelow field_below(const Solid& solid, const Body& body, const ContactPoints& contact,
                       const half_space::PlaneGrid& points, const Poll& poll) {
  return visit_ground(solid, [&](const auto& its) -> FieldBelow {
    const auto asked = [](auto field) {
      return [field = std::move(field)](std::span<const double> coordinate, std::span<const double> node_force,
                                        const Poll& heed) { return field.at(coordinate, node_force, heed); };
    };
    if constexpr (has_layers<std::decay_t<decltype(its)>>) {
      return asked(bodies::plate::PlateField(its, body, contact, points, poll));
    } else {
      return asked(half_space::HalfSpaceField(its.poisson, body, contact, points));
    }
  });
}

half_space::Stress stress_below(const Solid& solid, const half_space::PlaneGrid& points,
                                const half_space::Field& field) {
  return visit_ground(solid, [&](const auto& its) {
    return half_space::stress(contour<std::decay_t<decltype(its)>>, layers_of(its), points, field);
  });
}

half_space::WaveSpeeds speeds_below(const Solid& solid) {
  return visit_ground(solid, [](const auto& its) {
    return half_space::wave_speeds(contour<std::decay_t<decltype(its)>>, its.poisson);
  });
}

double thickness_of(const Solid& solid) {
  return visit_ground(solid, [](const auto& its) { return layers_of(its).back().end; });
}

double lasting_duration(const Solid& solid, double time, double distance) {
  const double passing = distance / speeds_below(solid).shear;
  // What goes into the depth of a half-space has to be there, and back, for as long.
  const bool block = visit_ground(solid, [](const auto& its) { return is_block<std::decay_t<decltype(its)>>; });
  constexpr double margin = 1.2;
  return margin * (time + (block ? 2.0 : 1.0) * passing);
}

}  // namespace stoss::ground
