#include "stoss/encounter/modal_file.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "encounter/json_values.hpp"

namespace stoss {
namespace {

using namespace json;

constexpr const char* format = "stoss modal body 1";
constexpr double turn = 2.0 * std::numbers::pi;

void require_keys(const std::string& where, const Json& given, const std::vector<std::string>& allowed) {
  for (const auto& [name, value] : object(where, given).items()) {
    if (std::find(allowed.begin(), allowed.end(), name) != allowed.end()) continue;
    std::string all;
    for (const std::string& each : allowed) all += (all.empty() ? "" : ", ") + each;
    refuse(where, name, all);
  }
}

double needed(const std::string& where, const Json& given, const std::string& name) {
  if (!given.contains(name)) throw InvalidInput(where + " " + name + ": got none, allowed a number in SI");
  return number(where + " " + name, given[name]);
}

std::vector<double> numbers(const std::string& where, const Json& value, std::optional<std::size_t> count) {
  if (!value.is_array() || (count && value.size() != *count)) {
    refuse(where, value, count ? "a list of " + std::to_string(*count) + " numbers" : "a list of numbers");
  }
  std::vector<double> all;
  for (const Json& each : value) all.push_back(number(where, each));
  return all;
}

Eigen::Vector3d vector(const std::string& where, const Json& given, const char* name) {
  if (!given.contains(name)) throw InvalidInput(where + " " + name + ": got none, allowed [x, y, z]");
  const std::vector<double> all = numbers(where + " " + name, given[name], 3);
  return {all[0], all[1], all[2]};
}

/// Mass that the point feels along its normal, where the body is free to turn.
double turning_mass(const std::string& where, const Json& given, double mass) {
  require_keys(where, given, {"inertia", "point", "normal"});
  if (!given.contains("inertia") || !given["inertia"].is_array() || given["inertia"].size() != 3) {
    throw InvalidInput(where + " inertia: got none, or not three rows, allowed 3 x 3 numbers in kg m^2");
  }
  Eigen::Matrix3d inertia;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::vector<double> values = numbers(where + " inertia", given["inertia"][static_cast<std::size_t>(row)], 3);
    for (Eigen::Index column = 0; column < 3; ++column) inertia(row, column) = values[static_cast<std::size_t>(column)];
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
  if (!inertia.isApprox(inertia.transpose(), 1e-6) || !(principal.eigenvalues().minCoeff() > 0.0)) {
    refuse(where + " inertia", given["inertia"], "a symmetric positive definite tensor about the centre of mass");
  }
  const Eigen::Vector3d point = vector(where, given, "point"), normal = vector(where, given, "normal");
  if (!(normal.norm() > 0.0)) refuse(where + " normal", given["normal"], "a direction");
  const Eigen::Vector3d lever = point.cross(normal.normalized());
  return 1.0 / (1.0 / mass + lever.dot(inertia.ldlt().solve(lever)));
}

void read_curvature(const std::string& where, const Json& given, ModalBody& body) {
  if (!given.contains("curvature")) {
    throw InvalidInput(where + " curvature: got none, allowed one number or two in 1/m (0: a plane)");
  }
  const Json& value = given["curvature"];
  std::vector<double> both;
  if (value.is_array()) {
    both = numbers(where + " curvature", value, 2);
  } else {
    both.assign(2, number(where + " curvature", value));
  }
  if (std::min(both[0], both[1]) < 0.0) {
    refuse(where + " curvature", value, "0 or more (a surface that is hollow at the point is not computed)");
  }
  body.curvature = 0.5 * (both[0] + both[1]);
  body.curvature_difference = std::abs(both[0] - both[1]);
}

void read_modes(const std::string& where, const Json& given, ModalBody& body) {
  require_keys(where, given,
               {"frequency", "displacement", "displacement_curvature", "frequency_error", "displacement_error"});
  const auto list = [&](const char* name, std::optional<std::size_t> count) {
    if (given.contains(name)) return numbers(where + " " + name, given[name], count);
    if (std::string(name).find('_') == std::string::npos) {
      throw InvalidInput(where + " " + name + ": got none, allowed a list of numbers");
    }
    return std::vector<double>(count.value_or(0), 0.0);
  };
  const std::vector<double> frequency = list("frequency", {});
  const std::size_t count = frequency.size();
  const std::vector<double> displacement = list("displacement", count), bend = list("displacement_curvature", count),
                            frequency_error = list("frequency_error", count),
                            displacement_error = list("displacement_error", count);
  body.has_bends = given.contains("displacement_curvature");
  for (std::size_t i = 0; i < count; ++i) {
    body.modes.push_back(
        {turn * frequency[i], displacement[i], bend[i], turn * frequency_error[i], displacement_error[i]});
  }
}

}  // namespace

ModalBody modal_body_from_json(std::string_view text, const std::string& where) {
  Json given;
  try {
    given = Json::parse(text);
  } catch (const Json::exception& error) {
    throw InvalidInput(where + ": got no JSON document, allowed one (" + std::string(error.what()) + ")");
  }
  require_keys(where, given,
               {"format", "name", "origin", "mass", "rotation", "curvature", "young", "poisson", "density", "loss_time",
                "compliance", "compliance_error", "complete_to", "modes"});
  if (!given.contains("format") || given["format"] != format) {
    refuse(where + " format", given.value("format", Json()), '"' + std::string(format) + '"');
  }
  ModalBody body;
  if (given.contains("name")) body.name = word(where + " name", given["name"], "a name");
  if (given.contains("origin")) body.origin = word(where + " origin", given["origin"], "a text");
  body.mass = needed(where, given, "mass");
  if (given.contains("rotation") && body.mass > 0.0) {
    body.mass = turning_mass(where + " rotation", given["rotation"], body.mass);
  }
  read_curvature(where, given, body);
  for (const auto& [name, place] : std::array<std::pair<const char*, double*>, 4>{{{"young", &body.young},
                                                                                   {"poisson", &body.poisson},
                                                                                   {"density", &body.density},
                                                                                   {"compliance", &body.compliance}}}) {
    *place = needed(where, given, name);
  }
  if (given.contains("loss_time")) body.loss_time = needed(where, given, "loss_time");
  if (given.contains("compliance_error")) body.compliance_error = needed(where, given, "compliance_error");
  if (!given.contains("modes")) throw InvalidInput(where + " modes: got none, allowed frequency and displacement");
  read_modes(where + " modes", given["modes"], body);
  if (given.contains("complete_to")) {
    body.complete_to = turn * needed(where, given, "complete_to");
  } else if (!body.modes.empty()) {
    body.complete_to = body.modes.back().omega;
  }
  try {
    (void)modal_body(body);
  } catch (const InvalidInput& error) {
    throw InvalidInput(where + " " + error.what());
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
  Json document{{"format", format}, {"name", body.name}};
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
  document["modes"] = modes;
  return document.dump();
}

}  // namespace stoss
