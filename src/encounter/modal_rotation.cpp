#include "encounter/modal_rotation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace stoss {
namespace {

using namespace json;

/// How a body is free to turn about its centre of mass.
struct Rotation {
  Eigen::Matrix3d inertia;
  Eigen::Vector3d point;   // from the centre of mass
  Eigen::Vector3d normal;  // of length 1
};

Eigen::Vector3d vector(const std::string& where, const Json& given, const char* name) {
  if (!given.contains(name)) throw InvalidInput::missing(where + " " + name, "[x, y, z]");
  const std::vector<double> all = numbers(where + " " + name, given[name], 3);
  return {all[0], all[1], all[2]};
}

Eigen::Vector3d direction(const std::string& where, const Json& given, const char* name) {
  const Eigen::Vector3d any = vector(where, given, name);
  if (!(any.norm() > 0.0)) refuse(where + " " + name, given[name], "a direction");
  return any.normalized();
}

Rotation rotation_of(const std::string& where, const Json& given) {
  require_keys(where, given, {"inertia", "point", "normal"});
  if (!given.contains("inertia") || !given["inertia"].is_array() || given["inertia"].size() != 3) {
    throw InvalidInput::missing(where + " inertia", "or not three rows; it needs 3 x 3 numbers in kg m^2");
  }
  Rotation its;
  for (Eigen::Index row = 0; row < 3; ++row) {
    const std::vector<double> values = numbers(where + " inertia", given["inertia"][static_cast<std::size_t>(row)], 3);
    for (Eigen::Index column = 0; column < 3; ++column) {
      its.inertia(row, column) = values[static_cast<std::size_t>(column)];
    }
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(its.inertia);
  if (!its.inertia.isApprox(its.inertia.transpose(), 1e-6) || !(principal.eigenvalues().minCoeff() > 0.0)) {
    refuse(where + " inertia", given["inertia"], "a symmetric positive definite tensor about the centre of mass");
  }
  its.point = vector(where, given, "point");
  its.normal = direction(where, given, "normal");
  return its;
}

/// Of a body that turns so. @param mass of all of it
PointTangent turning(const std::string& where, const Json& given, const Rotation& rotation, double mass) {
  constexpr double most_along_normal = 0.02;  // some degree
  require_keys(where, given, {"direction", "compliance", "compliance_error"});
  Eigen::Vector3d along = direction(where, given, "direction");
  const double off = along.dot(rotation.normal);
  if (std::abs(off) > most_along_normal) {
    refuse(where + " direction", given["direction"], "one perpendicular to the normal, to a degree");
  }
  along = (along - off * rotation.normal).normalized();
  const Eigen::Vector3d lever = rotation.point.cross(along), answer = rotation.inertia.ldlt().solve(lever);
  PointTangent its;
  its.mass = mass;
  const double turned = lever.dot(answer);
  if (turned > 0.0) {
    its.arm = lever.norm();
    its.inertia = its.arm * its.arm / turned;
  }
  its.cross = rotation.point.cross(rotation.normal).dot(answer);
  return its;
}

/// As tangent_to_json has it.
PointTangent given_turning(const std::string& where, const Json& given, double mass) {
  require_keys(where, given, {"direction", "mass", "inertia", "arm", "cross", "compliance", "compliance_error"});
  if (given.contains("direction")) (void)direction(where, given, "direction");
  PointTangent its;
  its.mass = given.contains("mass") ? needed(where, given, "mass") : mass;
  for (const auto& [name, place] : {std::pair{"inertia", &its.inertia}, {"arm", &its.arm}}) {
    if (!given.contains(name)) {
      throw InvalidInput::missing(where + " " + name, "a number in SI", "or give the rotation of the body");
    }
    *place = needed(where, given, name);
  }
  if (given.contains("cross")) its.cross = needed(where, given, "cross");
  return its;
}

}  // namespace

void read_rotation(const std::string& where, const Json& given, ModalBody& body) {
  const double whole = body.mass;
  if (!(whole > 0.0)) return;  // which is refused of the body
  std::optional<Rotation> rotation;
  if (given.contains("rotation")) {
    rotation = rotation_of(where + " rotation", given["rotation"]);
    const Eigen::Vector3d lever = rotation->point.cross(rotation->normal);
    body.mass = 1.0 / (1.0 / whole + lever.dot(rotation->inertia.ldlt().solve(lever)));
  }
  if (!given.contains("tangent")) return;
  const std::string name = where + " tangent";
  const Json& its = given["tangent"];
  body.tangent = rotation ? turning(name, its, *rotation, whole) : given_turning(name, its, whole);
  body.tangent->compliance = needed(name, its, "compliance");
  if (its.contains("compliance_error")) body.tangent->compliance_error = needed(name, its, "compliance_error");
}

Json tangent_to_json(const PointTangent& tangent) {
  return {{"mass", tangent.mass},   {"inertia", tangent.inertia},       {"arm", tangent.arm},
          {"cross", tangent.cross}, {"compliance", tangent.compliance}, {"compliance_error", tangent.compliance_error}};
}

}  // namespace stoss
