#include "stoss/encounter/kinds.hpp"

#include <algorithm>
#include <limits>

#include "check.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/encounter/roughness.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double lowest = -0.95, highest_of_solid = 0.4999;

constexpr Parameter plane_poisson_number{
    "poisson",
    "",
    {},
    bodies::disk::min_poisson,
    bodies::disk::max_poisson,
    true,
    true,
    "Poisson's ratio: without a material the 2-D one, with a material that of the solid"};
constexpr Parameter solid_poisson_number{"poisson", "", {}, lowest, highest_of_solid, true, true, "Poisson's ratio"};
constexpr Parameter young{"young", "Pa", 1.0, 0.0, infinity, false, true, "Young's modulus"};
constexpr Parameter density{"density", "kg/m^3", 1.0, 0.0, infinity, false, true, "density"};
constexpr Parameter radius{"radius", "m", 1.0, 0.0, infinity, false, false, "radius"};
constexpr Parameter length{"length", "m", 1.0, 0.0, infinity, false, false, "length"};
constexpr Parameter thickness{"thickness", "m", {}, 0.0, infinity, false, false, "thickness, from face to face"};
constexpr Parameter inner{"inner", "", {}, 0.0, 0.99, true, false, "radius of its hole over that of the sphere"};
constexpr Parameter area{"area", "m^2", 1.0, 0.0, infinity, false, false, "area of the cross-section"};
constexpr Parameter loss_time{
    "loss_time",
    "s",
    0.0,
    0.0,
    1e5,
    true,
    false,
    "loss time eta of the material, stress = (1 + eta d/dt) elastic stress, in R/c of the first body or in s"};
constexpr Parameter quality{
    "quality", "",   0.0,   0.0,
    1e9,       true, false, "quality Q of the material, the same at all frequencies of an impact; 0: none"};
constexpr Parameter roughness{"roughness",
                              "m",
                              0.0,
                              0.0,
                              1.0 / asperities_over_rms,
                              true,
                              false,
                              "rms height of the asperities of its face (0: smooth), of which u0 is 0.45 (+- 0.05)"};
constexpr Parameter u0{
    "u0",  "m",
    0.0,   0.0,
    1.0,   true,
    false, "length u0 of its elastic asperities (0: smooth), pressure = p0 exp(-gap/u0), in place of a roughness"};
constexpr Parameter coat{
    "coat", "m", 0.0, 0.0, 1.0, true, false, "thickness of a soft layer on its face, thin beside the contact; 0: none"};
constexpr Parameter coat_young{"coat_young", "Pa", 0.0, 0.0, infinity, true, false, "Young's modulus of the coat"};
constexpr Parameter coat_poisson{"coat_poisson",   "",   0.3,   lowest,
                                 highest_of_solid, true, false, "Poisson's ratio of the coat"};
constexpr Parameter coat_quality{"coat_quality",
                                 "",
                                 0.0,
                                 0.0,
                                 1e9,
                                 true,
                                 false,
                                 "quality Q of the coat, whose modulus is then that at once; 0: no loss"};
constexpr Parameter yield_strength{
    "yield_strength", "Pa", 0.0,   0.0,
    infinity,         true, false, "yield strength of its material: a model; 0: it does not yield"};
constexpr Parameter yield_hardening{
    "yield_hardening",
    "Pa",
    0.0,
    0.0,
    infinity,
    true,
    false,
    "growth H of the strength for each unit of plastic strain, up to 0.03 of the modulus: a model"};
constexpr Parameter yield_rate{
    "yield_rate", "",   0.0,   0.0,
    1.0,          true, false, "C of the strength at a rate of strain in 1/s above 1, Y (1 + C ln(rate)): a model"};
constexpr Parameter extra_mass{
    "extra_mass",
    "kg",
    0.0,
    0.0,
    infinity,
    true,
    false,
    "mass fixed to it that moves as it does on average, as of a hammer; without a material in density radius^3"};
constexpr Parameter hardness{"hardness", "", 500.0, 1.0, 1e8, true, false, "alpha R = R/u0 of the wall"};
constexpr Parameter strength{"strength", "", 1.0, 1e-100, 1e100, true, false, "V0; it only shifts the wall"};

/// A disk or a sphere of its numbers.
template <typename Round>
Solid round(const Values& of) {
  return Round{of.at("poisson"), of.at("radius"), of.at("young"), of.at("density"), of.at("loss_time")};
}

/// A sphere or a hollow one, whose extra mass is put on it later.
template <Solid solid(const Values&)>
Solid ball(const Values& of) {
  require("extra_mass", of.at("extra_mass"), {0.0, infinity, true, false, "0 or more"}, "a mass fixed to the body");
  return solid(of);
}

template <typename Unbounded>
Solid unbounded(const Values& of) {
  return Unbounded{of.at("poisson"), of.at("young"), of.at("density"), of.at("loss_time")};
}

template <typename Flat>
Solid flat(const Values& of) {
  return Flat{of.at("thickness"), of.at("poisson"), of.at("young"), of.at("density"), of.at("loss_time")};
}

void add_layer(Solid& plate, const Values& of) {
  std::get<Plate>(plate).below.push_back({of.at("thickness"), of.at("poisson"), of.at("young"), of.at("density")});
}

Solid hollow_of(const Values& of) {
  return HollowSphere{of.at("poisson"), of.at("inner"),   of.at("radius"),
                      of.at("young"),   of.at("density"), of.at("loss_time")};
}

Solid rod_of(const Values& of) {
  return Rod{of.at("length"), of.at("young"), of.at("density"), of.at("area"), of.at("loss_time")};
}

std::vector<Kind> make_kinds() {
  Kind disk{.name = "disk",
            .plural = "disks",
            .help = "an elastic disk, thin or a slice of a long cylinder",
            .wall = false,
            .bounded = true,
            .can_be_rigid = true,
            .can_yield = false,
            .has_plane = true,
            .contour = Contour::cylinder,
            .own = UnitSystem::disk,
            .si = UnitSystem::disk_si,
            .parameters = {plane_poisson_number, radius, young, density, loss_time, quality},
            .solid = round<Disk>};
  Kind sphere = disk;
  sphere.name = "sphere", sphere.plural = "spheres", sphere.help = "an elastic sphere";
  sphere.can_yield = true, sphere.has_plane = false, sphere.contour = Contour::ball;
  sphere.own = UnitSystem::sphere, sphere.si = UnitSystem::sphere_si;
  sphere.parameters.front() = solid_poisson_number, sphere.solid = ball<round<Sphere>>;
  sphere.parameters.push_back(extra_mass);
  Kind hollow = sphere;
  hollow.name = "hollow-sphere", hollow.plural = "hollow spheres", hollow.help = "a shell between concentric spheres";
  hollow.can_be_rigid = false, hollow.solid = ball<hollow_of>;
  hollow.parameters = {solid_poisson_number, radius, inner, young, density, loss_time, quality, extra_mass};
  Kind rod = sphere;
  rod.name = "rod", rod.plural = "rods", rod.help = "a thin elastic rod that meets with one end";
  rod.can_be_rigid = rod.can_yield = false, rod.contour = Contour::flat;
  rod.own = UnitSystem::rod, rod.si = UnitSystem::rod_si;
  rod.parameters = {length, young, density, area, loss_time, quality}, rod.solid = rod_of;
  Kind modal = sphere;
  modal.name = "modal", modal.plural = "modal bodies";
  modal.help = "any body by its modes at a point, from a file";
  modal.can_be_rigid = modal.can_yield = false;
  modal.parameters = {}, modal.solid = {}, modal.from_file = true;
  Kind half_space = sphere;
  half_space.name = "half-space", half_space.plural = "half-spaces";
  half_space.help = "a large block for spheres, whose waves do not return";
  half_space.bounded = half_space.can_be_rigid = false;
  half_space.parameters = {solid_poisson_number, young, density, loss_time, quality};
  half_space.solid = unbounded<HalfSpace>;
  Kind half_plane = disk;
  half_plane.name = "half-plane", half_plane.plural = "half-planes", half_plane.help = "elastic half-plane, for disks";
  half_plane.bounded = half_plane.can_be_rigid = false;
  half_plane.parameters = {plane_poisson_number, young, density, loss_time, quality};
  half_plane.solid = unbounded<HalfPlane>;
  Kind plate = half_space;
  plate.name = "plate", plate.plural = "plates";
  plate.help = "an elastic plate for spheres, free on both faces";
  plate.parameters = {thickness, solid_poisson_number, young, density, loss_time, quality};
  plate.solid = flat<Plate>;
  plate.add_layer = add_layer;
  Kind strip = half_plane;
  strip.name = "strip", strip.plural = "strips", strip.help = "elastic strip of finite thickness, for disks";
  strip.parameters = {thickness, plane_poisson_number, young, density, loss_time, quality};
  strip.solid = flat<Strip>;
  Kind wall = half_space;
  wall.name = "wall", wall.plural = "walls", wall.help = "a rigid wall";
  wall.wall = true, wall.can_yield = false, wall.parameters = {roughness, u0}, wall.solid = {};
  for (Kind* each : {&disk, &sphere, &hollow, &rod, &modal, &half_space, &half_plane, &plate, &strip}) {
    each->parameters.insert(each->parameters.end(), {roughness, u0, coat, coat_young, coat_poisson, coat_quality});
  }
  for (Kind* each : {&sphere, &hollow, &modal, &half_space, &plate})
    each->parameters.insert(each->parameters.end(), {yield_strength, yield_hardening, yield_rate});
  Kind same = wall;
  same.name = "same", same.plural = "equal bodies", same.help = "a second body, equal to the first";
  same.parameters = {};
  Kind exponential = wall;
  exponential.name = "exponential", exponential.plural = "exponential walls";
  exponential.help = "a rigid wall with elastic asperities of the length 1/alpha: the paper's soft wall";
  exponential.parameters = {hardness, strength};
  return {wall, same, disk, sphere, hollow, rod, half_space, half_plane, plate, strip, modal, exponential};
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = make_kinds();
  return all;
}

const Kind& kind(std::string_view name) {
  std::string names;
  for (const Kind& each : kinds()) {
    if (each.name == name) return each;
    names += (names.empty() ? "" : ", ") + std::string(each.name);
  }
  throw InvalidInput::out_of_range("kind", in_quotes(name), names);
}

const Parameter* parameter(const Kind& kind, std::string_view name) {
  const auto found = std::find_if(kind.parameters.begin(), kind.parameters.end(),
                                  [name](const Parameter& each) { return each.name == name; });
  return found == kind.parameters.end() ? nullptr : &*found;
}

bool meets(const Kind& first, const Kind& against) {
  return first.bounded && (against.wall || first.contour == against.contour);
}

}  // namespace stoss
