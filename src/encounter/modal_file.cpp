#include "stoss/encounter/modal_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "check.hpp"
#include "encounter/json_values.hpp"
#include "encounter/modal_rotation.hpp"

namespace stoss {
namespace {

using namespace json;

constexpr std::size_t longest_name = 200, longest_origin = 2000;  // bytes
constexpr double turn = 2.0 * std::numbers::pi;

void read_curvature(const std::string& where, const Json& given, ModalBody& body) {
  if (!given.contains("curvature")) {
    throw InvalidInput::missing(where + " curvature", "one number or two in 1/m", "0: a plane");
  }
  const Json& value = given["curvature"];
  std::vector<double> both;
  if (value.is_array()) {
    both = numbers(where + " curvature", value, 2);
  } else {
    both.assign(2, number(where + " curvature", value));
  }
  if (both[0] + both[1] < 0.0 || (both[0] + both[1] == 0.0 && both[0] != 0.0)) {
    refuse(where + " curvature", value, "a sum above 0, or 0 (a surface that is hollow at the point is not computed)");
  }
  body.curvature = 0.5 * (both[0] + both[1]);
  body.curvature_difference = std::abs(both[0] - both[1]);
}

/// Of gels c is some 1 m/s, of diamond 18 km/s: a file in mm, t and MPa has 5·10⁶ for steel.
void require_wave_speed(const std::string& where, const ModalBody& body) {
  constexpr double least = 0.5, most = 3e4;
  if (!(body.young > 0.0 && body.density > 0.0)) return;  // refused with the body
  const double speed = std::sqrt(body.young / body.density);
  if (speed >= least && speed <= most) return;
  throw InvalidInput::out_of_range(where + " young",
                                   shown(body.young) + " with density " + shown(body.density) +
                                       ", which make a speed of sound of " + rounded(speed, 2) + " m/s",
                                   "Pa and kg/m3 that make 0.5 to 3e4 m/s", "body files are in SI units");
}

/// Of all bodies of one mass and density a ball has the least moments of inertia, 0.46 M (M/ρ)^{2/3} in sum.
void require_inertia(const std::string& where, const Json& given, const ModalBody& body) {
  if (!given.contains("rotation") || !(body.density > 0.0)) return;
  constexpr double of_ball = 0.46, denser_inside = 0.1;
  const double mass = needed(where, given, "mass"), least = of_ball * mass * std::pow(mass / body.density, 2.0 / 3.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += given["rotation"]["inertia"][i][i].get<double>();
  if (sum >= denser_inside * least) return;
  throw InvalidInput::out_of_range(
      where + " mass", shown(mass) + " with moments of inertia of " + rounded(sum) + " in sum",
      "moments of " + rounded(least) + " and more, those of a ball of this mass and density",
      "are all numbers in one system of units: kg, kg m2, kg/m3?");
}

void read_modes(const std::string& where, const Json& given, ModalBody& body) {
  require_keys(where, given,
               {"frequency", "displacement", "displacement_curvature", "frequency_error", "displacement_error",
                "tangential_displacement", "tangential_displacement_curvature", "tangential_displacement_error"});
  const auto list = [&](const char* name, std::optional<std::size_t> count) {
    if (given.contains(name)) return numbers(where + " " + name, given[name], count);
    if (std::string(name).find('_') == std::string::npos) {
      throw InvalidInput::missing(where + " " + name, "a list of numbers");
    }
    return std::vector<double>(count.value_or(0), 0.0);
  };
  const std::vector<double> frequency = list("frequency", {});
  const std::size_t count = frequency.size();
  const std::vector<double> displacement = list("displacement", count), bend = list("displacement_curvature", count),
                            frequency_error = list("frequency_error", count),
                            displacement_error = list("displacement_error", count),
                            tangential = list("tangential_displacement", count),
                            tangential_bend = list("tangential_displacement_curvature", count),
                            tangential_error = list("tangential_displacement_error", count);
  body.has_bends = given.contains("displacement_curvature");
  for (std::size_t i = 0; i < count; ++i) {
    body.modes.push_back({turn * frequency[i], displacement[i], bend[i], turn * frequency_error[i],
                          displacement_error[i], tangential[i], tangential_bend[i], tangential_error[i]});
  }
  const bool moves = given.contains("tangential_displacement");
  if (moves != body.tangent.has_value()) {
    throw InvalidInput::out_of_range(where + " tangential_displacement", (moves ? "one without a tangent" : "none"),
                                     "one beside a tangent, and none without");
  }
  if (body.tangent) body.tangent->has_bends = given.contains("tangential_displacement_curvature");
}

}  // namespace

ModalBody modal_body_from_json(std::string_view text, const std::string& where) {
  const Json given = parsed(where, text);
  require_format(where + " format", object(where, given).value("format", Json()), modal_body_format);
  require_keys(where, given,
               {"format", "name", "origin", "mass", "rotation", "curvature", "young", "poisson", "density", "loss_time",
                "compliance", "compliance_error", "complete_to", "held", "tangent", "modes"});
  ModalBody body;
  if (given.contains("name")) body.name = line(where + " name", given["name"], longest_name);
  if (given.contains("origin")) body.origin = line(where + " origin", given["origin"], longest_origin);
  body.mass = needed(where, given, "mass");
  if (given.contains("held")) {
    if (!given["held"].is_boolean()) refuse(where + " held", given["held"], "true or false");
    body.held = given["held"].get<bool>();
  }
  if (body.held && given.contains("rotation")) {
    throw InvalidInput::conflict(where + " rotation", "of a body that is held", "it does not turn as a whole");
  }
  read_rotation(where, given, body);
  read_curvature(where, given, body);
  for (const auto& [name, place] : std::array<std::pair<const char*, double*>, 4>{{{"young", &body.young},
                                                                                   {"poisson", &body.poisson},
                                                                                   {"density", &body.density},
                                                                                   {"compliance", &body.compliance}}}) {
    *place = needed(where, given, name);
  }
  require_wave_speed(where, body);
  require_inertia(where, given, body);
  if (given.contains("loss_time")) body.loss_time = needed(where, given, "loss_time");
  if (given.contains("compliance_error")) body.compliance_error = needed(where, given, "compliance_error");
  if (!given.contains("modes")) throw InvalidInput::missing(where + " modes", "frequency and displacement");
  read_modes(where + " modes", given["modes"], body);
  if (given.contains("complete_to")) {
    body.complete_to = turn * needed(where, given, "complete_to");
  } else if (!body.modes.empty()) {
    body.complete_to = body.modes.back().omega;
  }
  try {
    (void)modal_body(body);
  } catch (const InvalidInput& error) {
    throw error.within(where);
  }
  return body;
}

std::string to_json(const ModalBody& body) {
  const double half = 0.5 * body.curvature_difference;
  Json modes{{"frequency", Json::array()}, {"displacement", Json::array()}};
  const auto all = [&](const char* name, double scale, double PointMode::*value) {
    Json& list = modes[name] = Json::array();
    for (const PointMode& mode : body.modes) list.push_back(mode.*value / scale);
  };
  all("frequency", turn, &PointMode::omega);
  all("displacement", 1.0, &PointMode::displacement);
  if (body.has_bends) all("displacement_curvature", 1.0, &PointMode::bend);
  all("frequency_error", turn, &PointMode::omega_error);
  all("displacement_error", 1.0, &PointMode::displacement_error);
  if (body.tangent) {
    all("tangential_displacement", 1.0, &PointMode::tangential);
    if (body.tangent->has_bends) all("tangential_displacement_curvature", 1.0, &PointMode::tangential_bend);
    all("tangential_displacement_error", 1.0, &PointMode::tangential_error);
  }
  Json document{{"format", modal_body_format}, {"name", body.name}};
  if (!body.origin.empty()) document["origin"] = body.origin;
  document["mass"] = body.mass;
  document["curvature"] = {body.curvature + half, body.curvature - half};
  document["young"] = body.young;
  document["poisson"] = body.poisson;
  document["density"] = body.density;
  document["loss_time"] = body.loss_time;
  document["compliance"] = body.compliance;
  document["compliance_error"] = body.compliance_error;
  document["complete_to"] = body.complete_to / turn;
  if (body.held) document["held"] = true;
  if (body.tangent) document["tangent"] = tangent_to_json(*body.tangent);
  document["modes"] = modes;
  return document.dump();
}

}  // namespace stoss
