// The table of the identity suite. A new body, wall or partner is a line here; contacts.cpp makes their contacts.
#include "identities/cases.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "stoss/restitution/ladder.hpp"

namespace stoss::test {
namespace {

struct Named {
  std::string name;
  Solid solid;
  Relaxation relaxation{};
  std::vector<MaterialLoss> layers{};
};

// Faster and slower than an impact.
const Relaxation relaxes{{{0.3, 0.2}, {0.2, 3.0}}}, creeps{{{0.4, 8.0}}};

struct Meeting {
  std::string name;
  bool soft;
  Tail tail;
  std::vector<double> speeds;
  double asperities = 0.0;  // of the first body, a sixth of which the second has
};

const std::vector<Named> bodies{{"disk_m50", Disk{-0.5}},
                                {"disk_0", Disk{0.0}},
                                {"disk_33", Disk{0.33}},
                                {"disk_90", Disk{0.9}},
                                {"rod", Rod{}},
                                {"sphere_m50", Sphere{-0.5}},
                                {"sphere_30", Sphere{0.3}},
                                {"sphere_49", Sphere{0.49}},
                                {"hollow_50", HollowSphere{.poisson = 0.3, .inner = 0.5}},
                                {"lossy_hollow_60", HollowSphere{.poisson = 0.3, .inner = 0.6, .loss_time = 0.1}},
                                {"lossy_disk", Disk{.poisson = 0.33, .loss_time = 0.1}},
                                {"lossy_rod", Rod{.loss_time = 0.05}},
                                {"lossy_sphere", Sphere{.poisson = 0.3, .loss_time = 0.1}},
                                {"relaxing_disk", Disk{0.33}, relaxes},
                                {"relaxing_rod", Rod{}, creeps},
                                {"relaxing_sphere", Sphere{0.3}, relaxes}};

const std::vector<Meeting> walls{{"static", false, Tail::quasistatic, {1e-3, 0.3}},
                                 {"radiating", false, Tail::radiating, {1e-3, 0.1, 0.3}},
                                 {"exponential", true, Tail::none, {1e-3, 0.3}},
                                 {"rough", false, Tail::radiating, {0.1}, 0.01},
                                 {"rough_static", false, Tail::quasistatic, {0.1}, 0.01}};

// A fast sphere rattles on an exponential wall (docs/theory/spheres.md): there no number is exact.
const std::vector<Meeting> walls_of_spheres{
    walls[0], walls[1], {"exponential", true, Tail::none, {1e-3}}, walls[3], walls[4]};

const std::vector<Meeting> between_bodies{{"static", false, Tail::quasistatic, {0.02}},
                                          {"radiating", false, Tail::radiating, {0.3}}};

// In size, modulus, density and Poisson's ratio they differ from all bodies.
const std::vector<Named> other_disks{{"small", Disk{0.2, 0.5, 2.0, 3.0}}, {"large", Disk{-0.3, 3.0, 0.5, 0.2}}};
const std::vector<Named> other_spheres{{"small", Sphere{0.2, 0.5, 2.0, 3.0}}, {"large", Sphere{-0.3, 3.0, 0.5, 0.2}}};
const std::vector<Named> other_rods{{"long", Rod{2.5, 1.0, 1.0, 1.0}}, {"thin", Rod{0.4, 2.0, 3.0, 0.2}}};

// Partners of a lossy body: one that loses nothing, and one that loses more; of one that relaxes one of each kind.
const std::vector<Named> beside_lossy_disks{{"small", Disk{0.2, 0.5, 2.0, 3.0}},
                                            {"large", Disk{-0.3, 3.0, 0.5, 0.2, 0.7}}};
const std::vector<Named> beside_lossy_spheres{{"small", Sphere{0.2, 0.5, 2.0, 3.0}},
                                              {"large", Sphere{-0.3, 3.0, 0.5, 0.2, 0.7}}};
const std::vector<Named> beside_lossy_rods{{"long", Rod{2.5, 1.0, 1.0, 1.0}}, {"thin", Rod{0.4, 2.0, 3.0, 0.2, 0.3}}};

const std::vector<Named> beside_relaxing_disks{{"small", Disk{0.2, 0.5, 2.0, 3.0}, creeps},
                                               {"large", Disk{-0.3, 3.0, 0.5, 0.2, 0.7}}};
const std::vector<Named> beside_relaxing_spheres{{"small", Sphere{0.2, 0.5, 2.0, 3.0}, creeps},
                                                 {"large", Sphere{-0.3, 3.0, 0.5, 0.2, 0.7}}};
const std::vector<Named> beside_relaxing_rods{{"long", Rod{2.5, 1.0, 1.0, 1.0}},
                                              {"thin", Rod{0.4, 2.0, 3.0, 0.2}, relaxes}};

const Named half_plane_beside{"half_plane", Disk{0.2, 1.0, 2.0, 3.0}};
const Named half_space_beside{"half_space", Sphere{0.2, 1.0, 2.0, 3.0}};
const Named lossy_half_plane{"half_plane", Disk{0.2, 1.0, 2.0, 3.0, 0.03}};
const Named lossy_half_space{"half_space", Sphere{0.2, 1.0, 2.0, 3.0, 0.03}};

// Waves are back from their other face while they are met.
constexpr double thickness = 1.5;
const Named strip_beside{"strip", half_plane_beside.solid}, plate_beside{"plate", half_space_beside.solid};
const Named relaxing_half_plane{"half_plane", half_plane_beside.solid, creeps};
const Named relaxing_half_space{"half_space", half_space_beside.solid, creeps};
const Named lossy_strip{"strip", lossy_half_plane.solid}, lossy_plate{"plate", lossy_half_space.solid};
const Named relaxing_strip{"strip", half_plane_beside.solid, creeps};
const Named relaxing_plate{"plate", half_space_beside.solid, creeps};

// An elastic layer on one that relaxes, and one with a loss time; one that relaxes on top.
const Named elastic_top{"elastic_top", half_space_beside.solid, {}, {{}, {0.0, creeps}, {0.05, {}}}};
const Named relaxing_top{"relaxing_top", half_space_beside.solid, {}, {{0.0, relaxes}, {}, {0.0, creeps}}};

double loss_time_of(const Solid& solid) {
  return std::visit([](const auto& body) { return body.loss_time; }, solid);
}

double cutoff_of(const Case& its) {
  if (is_rod(its)) return 50.0;
  if (its.soft) return 12.5;
  if (its.half_space) return 16.0;
  return its.second ? 18.0 : 25.0;
}

void add(const Named& first, const Named* second, const Meeting& meeting, std::vector<Case>& cases,
         bool half_space = false, double of_plate = 0.0) {
  for (const double speed : meeting.speeds) {
    Case its;
    its.name = first.name + (second == nullptr ? "" : "_" + second->name) + "_" + meeting.name + "_" +
               std::to_string(std::lround(1000.0 * speed));
    its.first = first.solid;
    its.relaxation = first.relaxation;
    if (second != nullptr)
      its.second = second->solid, its.second_relaxation = second->relaxation, its.layers = second->layers;
    its.half_space = half_space;
    its.thickness = of_plate;
    its.soft = meeting.soft;
    its.tail = meeting.tail;
    its.asperities = meeting.asperities;
    its.speed = speed;
    its.cutoff = cutoff_of(its);
    cases.push_back(its);
  }
}

const std::vector<Named>& others(const Named& body) {
  const Solid& solid = body.solid;
  const bool lossy = loss_time_of(solid) > 0.0;
  if (!body.relaxation.terms.empty()) {
    if (std::holds_alternative<Rod>(solid)) return beside_relaxing_rods;
    return is_ball(solid) ? beside_relaxing_spheres : beside_relaxing_disks;
  }
  if (std::holds_alternative<Rod>(solid)) return lossy ? beside_lossy_rods : other_rods;
  if (is_ball(solid)) return lossy ? beside_lossy_spheres : other_spheres;
  return lossy ? beside_lossy_disks : other_disks;
}

/// The half-space that a body meets; a rod meets none.
const Named* half_space_for(const Named& body) {
  const Solid& solid = body.solid;
  const bool lossy = loss_time_of(solid) > 0.0;
  if (body.name == "relaxing_sphere") return &relaxing_half_space;
  if (body.name == "relaxing_disk") return &relaxing_half_plane;
  if (is_ball(solid)) return lossy ? &lossy_half_space : &half_space_beside;
  if (std::holds_alternative<Disk>(solid)) return lossy ? &lossy_half_plane : &half_plane_beside;
  return nullptr;
}

/// The plate or strip that some bodies meet.
const Named* plate_for(const Named& body) {
  if (body.name == "sphere_30") return &plate_beside;
  if (body.name == "disk_33") return &strip_beside;
  if (body.name == "lossy_sphere") return &lossy_plate;
  if (body.name == "relaxing_sphere") return &relaxing_plate;
  if (body.name == "relaxing_disk") return &relaxing_strip;
  return body.name == "lossy_disk" ? &lossy_strip : nullptr;
}

std::vector<Case> make_cases() {
  std::vector<Case> cases;
  for (const Named& body : bodies) {
    const bool ball = is_ball(body.solid);
    for (const Meeting& wall : ball ? walls_of_spheres : walls) add(body, nullptr, wall, cases);
    std::vector<Named> partners = others(body);
    partners.push_back({"same", body.solid, body.relaxation});
    for (const Named& partner : partners) {
      for (const Meeting& meeting : between_bodies) add(body, &partner, meeting, cases);
    }
    if (const Named* solid = half_space_for(body)) {
      for (const Meeting& meeting : between_bodies) add(body, solid, meeting, cases, true);
    }
    if (const Named* solid = plate_for(body)) {
      for (const Meeting& meeting : between_bodies) add(body, solid, meeting, cases, true, thickness);
    }
    for (const Named& plate : {elastic_top, relaxing_top}) {
      if (body.name != "sphere_30") continue;
      for (const Meeting& meeting : between_bodies) add(body, &plate, meeting, cases, true, thickness);
    }
  }
  return cases;
}

template <typename Condition>
std::vector<Case> those(Condition condition) {
  std::vector<Case> some;
  std::copy_if(all_cases().begin(), all_cases().end(), std::back_inserter(some), condition);
  return some;
}

}  // namespace

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = make_cases();
  return cases;
}

std::vector<Case> pairs() {
  return those([](const Case& its) { return its.second.has_value() && !its.half_space; });
}

std::vector<Case> equal_pairs() {
  return those([](const Case& its) { return its.name.find("_same_") != std::string::npos; });
}

std::vector<Case> soft_walls() {
  return those([](const Case& its) { return its.soft; });
}

std::vector<Case> rubbing(std::vector<Case> cases) {
  std::erase_if(cases, [](const Case& its) { return is_rod(its) || its.soft || its.tail == Tail::quasistatic; });
  return cases;
}

bool is_lossy(const Case& its) {
  if (!its.layers.empty()) return true;
  if (!its.relaxation.terms.empty() || !its.second_relaxation.terms.empty()) return true;
  return loss_time_of(its.first) > 0.0 || (its.second && loss_time_of(*its.second) > 0.0);
}

bool is_rod(const Case& its) { return std::holds_alternative<Rod>(its.first); }

}  // namespace stoss::test
