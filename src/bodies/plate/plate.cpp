// Plate and strip as bodies: at each wave number the branches of Rayleigh and Lamb are their modes.
#include "stoss/bodies/plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "bodies/plate/given.hpp"
#include "bodies/plate/plate_waves.hpp"
#include "bodies/sphere/degree_sums.hpp"
#include "bodies/surface/wave_body.hpp"
#include "check.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using namespace bodies;
using namespace bodies::plate;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double most_waves = 4e5, most_turns = 2e4;

MediumSurface surface_of(const Lamina& plate, double poisson, bool along) {
  const Sheet& top = plate.sheets.front();
  MediumSurface its;
  its.contour = plate.contour;
  its.pressure_speed = std::sqrt(top.pressure_modulus / top.density);
  its.shear_speed = std::sqrt(top.shear_modulus / top.density);
  const double normal = plate.contour == Contour::ball ? 1.0 - poisson * poisson : 1.0;
  its.softness = along ? sphere::softness_along(poisson) : normal;
  its.leaving_speed = along ? its.shear_speed : its.pressure_speed;
  if (along) {
    its.compliance = [plate](double k) { return compliance_along(plate, k); };
    its.second_moment = [plate](double k) { return second_moment_along(plate, k); };
  } else {
    its.compliance = [plate](double k) { return plane_compliance(plate, k).radial; };
    its.second_moment = [plate](double k) { return plane_second_moment(plate, k).radial; };
  }
  return its;
}

/// Greatest strain under a load (Body::strain), in orders of magnitude:
///
///   layers    (0.47 + 1.5 (a/(a + h))²) p/E*: 0.47 p/E* as near any contact; 2p/E* where the layer is much thinner
///             than the contact and takes its pressure, at most 2p, as a whole. The pressure spreads with the depth z:
///             that of a contact of a half-width a + z
///   bending   F/Eh² of a plate (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, section 19: stress
///             under a load on a small circle); 1.3 F √(ct/h)/Eh of a strip, on which the load has been for t
///             (Euler's beam, 6M/Eh²)
///   stretch   δ/2h of a plate that gives way by δ: it bends as linear theory has it up to some 0.2 h, and stretches
///             beyond
double strain_under(const Given& given, const Load& load) {
  constexpr double squeezed = 1.5, stretched = 0.5, bent = 1.3;
  const bool ball = given.contour == Contour::ball;
  const double unit = given.layers.front().young;
  double greatest = 0.0, depth = 0.0, stiffness = 0.0;
  for (const Layer& layer : given.layers) {
    const double softness = (ball ? 1.0 - layer.poisson * layer.poisson : 1.0) * unit / layer.young;
    Load here = load;
    here.half_width += depth;
    const double wide = here.half_width / (here.half_width + layer.thickness);
    greatest =
        std::max(greatest, (strain_of_contact + squeezed * wide * wide) * softness * pressure(given.contour, here));
    depth += layer.thickness;
    stiffness += layer.thickness * layer.young / unit;
  }
  if (std::isinf(depth)) return greatest;
  const double bending = load.force / (stiffness * depth);
  const double longer = ball ? 1.0 : bent * std::sqrt(load.duration * depth);
  return std::max({greatest, longer * bending, stretched * load.compression / depth});
}

/// The modes of a plate, which all that is made of it shares.
struct Modes {
  Lamina plate;
  double poisson;
  double cutoff;
  double highest_kept;
  std::vector<PlaneWaves> waves;

  [[nodiscard]] PlaneSurface surface() const {
    return {surface_of(plate, poisson, false), highest_kept,
            [its = plate](double k) { return plane_compliance(its, k); },
            [its = plate](double k) { return plane_second_moment(its, k); }};
  }
};

Body body_along(const Body& like, const Modes& its, const Poll& poll) {
  Body body = like;
  const MediumSurface surface = surface_of(its.plate, its.poisson, true);
  body.softness = surface.softness;
  set_waves(surface, waves_along(its.waves, its.plate, its.cutoff, poll), its.highest_kept, body);
  return body;
}

/// As such a plate it is a half-space.
Body as_half_space(const Given& given, double cutoff, double duration, const Poll& poll) {
  const Layer& its = given.layers.front();
  const MaterialLoss loss = given.losses.empty() ? MaterialLoss{given.loss_time, {}} : given.losses.front();
  const Body body =
      given.contour == Contour::ball
          ? stoss::half_space({its.poisson, its.young, its.density, loss.loss_time}, cutoff, duration, poll)
          : stoss::half_plane({its.poisson, its.young, its.density, loss.loss_time}, cutoff, duration, poll);
  return relaxing(body, in_time(loss.relaxation, given.speed()));
}

Body of_branches(const Given& given, double cutoff, double duration, const Poll& poll) {
  const LayerKinds kinds = kinds_of(given, duration);
  constexpr double swinging = 4.0;  // 1 to 8 change what is lost to a laminate by 2·10⁻⁵ of it
  const Lamina plate =
      lamina(given.contour, sheets_of(given, kinds, duration), kinds.differ() ? kinds.stiffness : std::vector<double>{},
             swinging * turning_frequency(given, duration));
  double loss_time = 0.0;
  for (const MaterialLoss& its : kinds.all) loss_time = std::max(loss_time, its.loss_time);
  const double highest = kept_cutoff(cutoff, loss_time);
  const double most = std::min(cutoff_of_count(plate, most_waves, duration), most_turns / duration);
  if (highest > most) {
    throw InvalidInput::out_of_range(
        "cutoff",
        rounded(cutoff) + " of a " + given.kind() + " for contacts of " + rounded(duration) + " in its own time",
        "a smaller product", "more waves than are computed");
  }
  const double poisson = given.layers.front().poisson;
  const auto modes = std::make_shared<const Modes>(
      Modes{plate, poisson, highest, highest_kept(plate, highest, poll), plane_waves(plate, highest, duration, poll)});
  const MediumSurface surface = surface_of(plate, poisson, false);
  Body body = unbounded_body(surface, cutoff, kinds.all.front().loss_time, duration);
  body.relaxation = kinds.all.front().relaxation;
  if (kinds.differ()) body.layers = kinds.all;
  body.scale = {1.0, given.speed(), given.layers.front().density};
  body.highest_cutoff = loss_time * most > 1.0 ? infinity : most;
  if (given.contour == Contour::cylinder) {
    body.along = [like = body, modes](const Poll&) {
      return plane_bodies(like, modes->surface(), modes->waves, {Parity::normal_even, Parity::along_even});
    };
  } else {
    body.along = [like = body, modes](const Poll& heed) { return std::vector<Body>{body_along(like, *modes, heed)}; };
    body.outward = [like = body, modes](const Poll&) {
      return plane_bodies(like, modes->surface(), modes->waves, {Parity::normal_even}).front();
    };
  }
  set_waves(surface, normal_waves(modes->waves), modes->highest_kept, body);
  return body;
}

/// How a plate or a strip gives way by bending, with D from that by a load of long waves, w = p/(Dk⁴). One so thick
/// that this is below all numbers does not.
void give_way(const Given& given, const LayerKinds& kinds, BodyPart& part) {
  const Lamina real = lamina(given.contour, sheets_of(given, kinds, infinity));
  // In a unit of length of which all powers below are exact, so that thick plates are far from the largest numbers.
  const double unit = std::exp2(2.0 * std::floor(0.5 * std::log2(real.thickness)));
  std::vector<Sheet> sheets = real.sheets;
  double mass = 0.0;
  for (Sheet& sheet : sheets) {
    sheet.thickness /= unit;
    mass += sheet.thickness * sheet.density;
  }
  const Lamina plate = lamina(given.contour, std::move(sheets));
  const double wave_number = 1e-3 / plate.thickness;
  const double stiffness =
      plate.weight(wave_number) / (std::pow(wave_number, 4) * plane_compliance(plate, wave_number).radial);
  const double mobility = 1.0 / (8.0 * std::sqrt(stiffness * mass)) / unit / unit;
  const double giving =
      1.0 / (2.0 * mass * std::sqrt(2.0 * std::numbers::pi * std::sqrt(stiffness / mass))) / unit / std::sqrt(unit);
  const bool ball = given.contour == Contour::ball;
  part.keeps_displacement = std::isnormal(ball ? mobility : giving);
  if (!part.keeps_displacement) return;
  part.giving = giving;
  if (ball) part.mobility = mobility;
}

Body made(const Given& given, double cutoff, double duration, const Poll& poll) {
  require_given(given);
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("cutoff", cutoff, positive, "highest frequency of the plate");
  require("duration", duration, positive, "longest contact with the plate");
  Body body = is_thick(given, duration) ? as_half_space(given, cutoff, duration, poll)
                                        : of_branches(given, cutoff, duration, poll);
  body.name = name_of(given);
  if (!std::isinf(given.layers.back().thickness)) give_way(given, kinds_of(given, duration), body.part);
  body.strain = [given](const Load& load) { return strain_under(given, load); };
  body.near_side = [given](double longest, double limit, const Poll& heed) {
    return made(given, limit, longest, heed);
  };
  return body;
}

BodyMaker maker(const Given& given) {
  require_given(given);
  constexpr double usual_duration = 10.0;  // of a fast impact
  return [given](double cutoff, const Poll& poll) { return made(given, cutoff, usual_duration, poll); };
}

}  // namespace

Body plate(const Plate& plate, double cutoff, double duration, const Poll& poll) {
  return made(given_of(plate), cutoff, duration, poll);
}

Body strip(const Strip& strip, double cutoff, double duration, const Poll& poll) {
  return made(given_of(strip), cutoff, duration, poll);
}

BodyMaker plate(const Plate& plate) { return maker(given_of(plate)); }

BodyMaker strip(const Strip& strip) { return maker(given_of(strip)); }

}  // namespace stoss
