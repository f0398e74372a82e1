// Which contact `stoss quasistatic` is asked of.
#include <fmt/format.h>

#include <string>
#include <variant>

#include "commands/quasistatic.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

using namespace quasistatic;

CompressionLaw line_law(const std::string& law) {
  if (law == "center") return CompressionLaw::center;
  if (law == "diameter") return CompressionLaw::diameter;
  throw InvalidInput::out_of_range("law", fmt::format("{} with --body disk", law), "center or diameter");
}

PointLaw point_law(const std::string& law) {
  if (law == "center") return PointLaw::center;
  if (law == "hertz") return PointLaw::hertz;
  throw InvalidInput::out_of_range("law", fmt::format("{} with --body sphere", law), "center or hertz");
}

/// The theory knows an elastic half-space alone.
void require_elastic(const Participant& half_space) {
  const auto refuse = [](const std::string& name) {
    throw InvalidInput::out_of_range("against " + name, "one", "none", "here the half-space is elastic");
  };
  for (const auto& [name, value] : half_space.values) {
    if ((name == "loss_time" && value != 0.0) || name == "quality") refuse(name);
  }
  if (half_space.relaxation) refuse("relaxation");
}

}  // namespace

std::variant<LineContact, PointContact, BlockContact> slow_contact(const Encounter& encounter, const std::string& law) {
  const Participant& against = encounter.against;
  const Solid first = first_solid(encounter);
  const auto* sphere = std::get_if<Sphere>(&first);
  if (against.kind == "wall" && against.values.empty()) {
    if (sphere != nullptr) return PointContact{point_law(law), sphere->poisson};
    return LineContact{line_law(law), std::get<Disk>(first).poisson};
  }
  if (sphere == nullptr || against.kind != "half-space") {
    throw InvalidInput::out_of_range("against", against.values.empty() ? against.kind : against.kind + " with numbers",
                                     "a smooth wall, or with --body sphere a half-space");
  }
  require_elastic(against);
  const auto its = std::get<HalfSpace>(*second_solid(encounter));
  return BlockContact{point_law(law),
                      {.poisson = sphere->poisson,
                       .half_space_poisson = its.poisson,
                       .young = its.young / sphere->young,
                       .density = its.density / sphere->density}};
}

}  // namespace stoss::cli
