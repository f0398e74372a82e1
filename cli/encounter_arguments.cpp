// The options that say who meets whom.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "encounter.hpp"
#include "options.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

/// An option that only some bodies have.
struct Owned {
  std::string option;
  std::vector<std::string> bodies;
};

const std::vector<Owned> owned{
    {"poisson", {"disk", "sphere"}},
    {"radius", {"disk", "sphere"}},
    {"plane", {"disk"}},
    {"yield", {"sphere"}},
    {"rigid-body", {"disk", "sphere"}},
    {"length", {"rod"}},
    {"area", {"rod"}},
};

}  // namespace

void EncounterArguments::add_to(CLI::App& to, const std::string& kind, const std::string& help) {
  command = &to;
  to.add_option("--body", body, "Kind of body (default: disk); a rod has no Poisson's ratio")
      ->check(CLI::IsMember({"disk", "sphere", "rod"}))
      ->type_name("BODY")
      ->group("Body");
  to.add_flag("--rigid-body", rigid,
              "The body is rigid: it keeps its mass, and its modulus and density\n"
              "remain the units; what it meets must deform")
      ->group("Body");
  add_number(to, "--loss-time", loss_time,
             "Loss time eta of the body: stress = (1 + eta d/dt) elastic stress\n(default: 0); in R/c, with a material "
             "in s")
      ->type_name("ETA")
      ->group("Body");
  disk.add_material_to(to, material_group);
  sphere.add_to(to, material_group);
  rod.add_to(to);
  to.add_option("--against", against,
                "What the body meets (default: wall)\n"
                "  wall: a rigid wall; same: a second body, equal to the first\n"
                "  disk[,poisson=NU,radius=R,young=E,density=RHO]: a second disk,\n"
                "               in units of the first; with a material, in SI\n"
                "  sphere[,poisson=NU,radius=R,young=E,density=RHO,yield=Y]: a second\n"
                "               sphere, likewise; yield only with a material\n"
                "  rod[,length=L,young=E,density=RHO,area=A]: a second rod, likewise\n"
                "  half-space[,poisson=NU,young=E,density=RHO,yield=Y]: an elastic\n"
                "               half-space for a sphere, likewise\n"
                "  half-plane[,poisson=NU,young=E,density=RHO]: one for a disk;\n"
                "               every elastic one may have loss_time=ETA too" +
                    help)
      ->type_name("{wall,same,disk,sphere,rod,half-space,half-plane" + (kind.empty() ? "" : "," + kind) +
                  "}[,KEY=NUMBER]...")
      ->group("Against");
}

Encounter EncounterArguments::encounter() const {
  const BodyKind kind = body_kind(body);
  if (kind != BodyKind::rod && command->get_option("--poisson")->count() == 0) throw CLI::RequiredError("--poisson");
  for (const auto& [option, bodies] : owned) {
    if (command->get_option("--" + option)->count() == 0) continue;
    if (std::find(bodies.begin(), bodies.end(), body) != bodies.end()) continue;
    throw InvalidInput(fmt::format("{0}: got --{0} with --body {1}, allowed only with --body {2}", option, body,
                                   fmt::join(bodies, " or ")));
  }
  FirstBody first{kind, disk, {}, {}, rigid, loss_time};
  if (kind == BodyKind::sphere) first.sphere = sphere.si(disk);
  if (kind == BodyKind::rod) first.rod = rod.si(disk);
  return {std::move(first), parse_against(against)};
}

}  // namespace stoss::cli
