// Reference values for spheres and disks with rough or coated faces: at walls, on half-spaces and in pairs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "contact/touch.hpp"
#include "reference.hpp"
#include "runs.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/encounter/encounter.hpp"
#include "stoss/encounter/relaxing.hpp"

namespace validate {
namespace {

constexpr int impacts = 80;
constexpr Finenesses finenesses{Fineness{80.0, 0.2, 2.4}, Fineness{113.0, 0.35, 1.3}, Fineness{160.0, 0.3, 1.8}};
constexpr Finenesses on_half_spaces{Fineness{12.0, 0.2, 2.4}, Fineness{17.0, 0.35, 1.3}, Fineness{24.0, 0.3, 1.8}};

/// Point i of an additive sequence in eight dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.0850702454914508;  // x⁹ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// Evenly on the logarithmic scale.
double between(double least, double most, double share) { return least * std::pow(most / least, share); }

double drawn(double least, double most, double share) { return rounded("%.3g", between(least, most, share)); }

/// A sphere or a disk: every seventh relaxes, every fourteenth is lossy otherwise.
stoss::Participant body(int i) {
  stoss::Participant made = stoss::of_kind(i % 2 == 0 ? "sphere" : "disk");
  made.values["poisson"] = rounded("%.2f", -0.2 + 0.68 * spread(i, 0));
  if (i % 7 == 5) made.relaxation = {{{drawn(1e-3, 0.6, spread(i, 5)), drawn(0.1, 30.0, spread(i, 6))}}};
  if (i % 14 == 2) made.values["loss_time"] = drawn(1e-3, 1.0, spread(i, 5));
  return made;
}

/// In turn a wall, a half-space, an equal body, another one and an exponential wall.
stoss::Participant met(int i) {
  const bool round = i % 2 == 0;
  const std::array<const char*, 5> kinds{"wall", round ? "half-space" : "half-plane", "same", round ? "sphere" : "disk",
                                         "exponential"};
  const int which = i / 2 % 5;
  stoss::Participant made = stoss::of_kind(kinds[static_cast<std::size_t>(which)]);
  if (which != 1 && which != 3) return made;
  made.values["poisson"] = rounded("%.2f", -0.2 + 0.68 * spread(i, 1));
  made.values["young"] = which == 1 ? drawn(0.1, 10.0, spread(i, 2)) : drawn(0.5, 2.0, spread(i, 2));
  if (which == 3) made.values["radius"] = drawn(0.5, 2.0, spread(i, 7));
  return made;
}

struct Impact {
  stoss::Encounter encounter;
  double speed;
};

/// Ten after each other have faces of one kind: rough, coated or both; those at an exponential wall are always rough.
/// u₀ is 10⁻³ to 3 of the compression of smooth faces. A coat has 5 to 30 % of the half-width between bare ones, and
/// gives way as the bodies do over 0.03 to 10 half-widths.
void cover(int i, Impact& impact) {
  const int kind = i / 10 % 8;
  const bool has_coat = kind == 1 || kind == 3 || kind == 4 || kind == 6, loses = kind == 4 || kind == 6;
  const bool at_soft_wall = impact.encounter.against.kind == "exponential";
  stoss::Encounter smooth = impact.encounter;
  if (at_soft_wall) smooth.against.kind = "wall";
  const stoss::Contact bare = contact_of(smooth, usual_cutoff(smooth, impact.speed, 12.0), impact.speed);
  stoss::Values& faces = impact.encounter.first.values;
  if (at_soft_wall || !has_coat || kind == 3 || kind == 6) {
    const double length = between(1e-3, 3.0, spread(i, 4)) * stoss::impact(bare, impact.speed).max_compression;
    constexpr double hardest = 1e8;
    if (at_soft_wall) impact.encounter.against.values["hardness"] = rounded("%.4g", std::min(1.0 / length, hardest));
    if (!at_soft_wall) faces["u0"] = rounded("%.3e", length);
  }
  if (!has_coat) return;
  constexpr double confined_over_young = 0.7 / (1.3 * 0.4);  // at Poisson's ratio 0.3
  const double width = expected_half_width(bare, impact.speed), thickness = between(0.05, 0.3, spread(i, 5)) * width;
  const double length = between(0.03, 10.0, spread(i, 6)) * width;
  faces["coat"] = rounded("%.3e", thickness);
  faces["coat_young"] = rounded("%.3e", thickness / (length * touch(bare).softness * confined_over_young));
  if (loses) faces["coat_quality"] = drawn(2.0, 200.0, spread(i, 7));
}

/// Poisson's ratios from −0.2 to 0.48, speeds from 1e-6 to 0.3 in c of the body or of what it meets, whichever is less.
std::vector<Impact> design() {
  std::vector<Impact> all;
  for (int i = 0; i < impacts; ++i) {
    Impact its{{body(i), met(i)}, 0.0};
    const auto young = its.encounter.against.values.find("young");
    const double slower = young == its.encounter.against.values.end() ? 1.0 : std::min(1.0, std::sqrt(young->second));
    its.speed = rounded("%.3e", slower * between(1e-6, 0.3, spread(i, 3)));
    cover(i, its);
    all.push_back(its);
  }
  return all;
}

std::string text_of(const stoss::Values& values, const std::vector<const char*>& names) {
  std::ostringstream text;
  for (const char* name : names) {
    const auto found = values.find(name);
    if (found != values.end()) text << found->second;
    text << ',';
  }
  return text.str();
}

ReferencePoint computed(const Impact& its) {
  const auto& [first, met, vibration] = its.encounter;
  std::ostringstream place;
  place << first.kind << ',' << text_of(first.values, {"poisson", "loss_time"})
        << (first.relaxation ? text_of(*first.relaxation) : "") << ','
        << text_of(first.values, {"u0", "coat", "coat_young", "coat_quality"}) << met.kind << ','
        << text_of(met.values, {"hardness", "poisson", "radius", "young"}) << its.speed;
  const stoss::Contact probe = refinable(its.encounter).at(0);
  return {place.str(), its.speed, [its, unit = 1.0 / stoss::time_scale(probe)](double cutoff) {
            return contact_of(its.encounter, unit * cutoff, its.speed);
          }};
}

/// Asperities let nothing happen faster than in the time u₀/v: cutoffs of 24 v/u₀ and more on half-spaces.
Finenesses finenesses_of(const Impact& its) {
  const stoss::Contact probe = refinable(its.encounter).at(0);
  const double slowness = probe.asperities > 0.0 ? 2.0 * its.speed / probe.asperities : 1.0;
  const double share = std::clamp(slowness, probe.unbounded ? 0.02 : 0.1, 1.0);
  Finenesses all = probe.unbounded ? on_half_spaces : finenesses;
  for (Fineness& each : all) each.cutoff *= share;
  return all;
}

std::string header() {
  return "# Impacts of spheres and disks with rough or coated faces, in units of the body (docs/theory/faces.md), "
         "more\n"
         "# finely resolved than those of restitution(). As options of the command; the coat has Poisson's ratio 0.3.\n"
         "# Made by: stoss_validate --make-face-reference FILE\n"
         "# Three runs at each point, with cutoffs 80, 113, 160 over the time scale of the contact (12, 17, 24 on\n"
         "# half-spaces), less where asperities are longer than the way in two units of time, at least 128 nodes and "
         "up to\n"
         "# 2.4 times those of restitution(). Value: that of the last run; uncertainty: spread of the three.\n"
         "body,poisson,loss_time,terms,u0,coat,coat_young,coat_quality,against,against_hardness,against_poisson,"
         "against_radius,against_young,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_face_reference(const std::string& path) {
  std::vector<ReferencePoint> points;
  std::vector<std::string> places;
  const std::vector<Impact> all = design();
  for (const Impact& its : all) {
    points.push_back(computed(its));
    places.push_back(points.back().place);
  }
  write_reference(path, header(), places,
                  [&](std::size_t i) { return resolved_runs(points[i], finenesses_of(all[i])); });
}

}  // namespace validate
