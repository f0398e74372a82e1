#pragma once

#include <optional>
#include <variant>

#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/rod.hpp"
#include "stoss/bodies/sphere.hpp"
#include "stoss/body/body.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/stoss.h"
#include "stoss/table/restitution_function.hpp"

// What the handles of the C interface hold.

struct stoss_body {
  std::variant<stoss::Disk, stoss::Sphere, stoss::Rod, stoss::HalfSpace, stoss::HalfPlane> value;
  bool rigid = false;
  stoss::BodyMaker maker;
};

struct stoss_contact {
  stoss_body first;
  std::optional<stoss_body> second;  ///< otherwise a wall
  stoss::RefinableContact contact;
};

struct stoss_function {
  stoss::RestitutionFunction function;
};
