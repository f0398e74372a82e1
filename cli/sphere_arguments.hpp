#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "stoss/bodies/sphere.hpp"

namespace stoss::cli {

/// A sphere in SI.
struct SolidSphere {
  Material material;
  double radius = 0.0;  ///< m

  /// As a value of the core, in SI.
  [[nodiscard]] Sphere sphere() const { return {material.poisson, radius, material.young, material.density}; }
};

/// What a sphere has in addition to what a disk has: the yield strength.
struct SphereArguments {
  std::optional<double> yield;

  void add_to(CLI::App& command, const std::string& group);

  /// The sphere in SI if a material was given. @throws InvalidInput if only part of one was, and for a plane
  [[nodiscard]] std::optional<SolidSphere> si(const DiskArguments& given) const;
};

/// Adds the Poisson's ratio and, in SI, the sphere and its scales to the inputs of a result.
void describe(double poisson, const std::optional<SolidSphere>& sphere, nlohmann::ordered_json& inputs);

}  // namespace stoss::cli
