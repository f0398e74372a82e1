#pragma once

#include <optional>

#include "stoss/encounter/laws.hpp"
#include "stoss/stoss.h"
#include "stoss/table/restitution_function.hpp"

// What the handles of the C interface hold.

struct stoss_body {
  stoss::Solid value;
  bool rigid = false;
  stoss::BodyMaker maker;
};

struct stoss_contact {
  stoss::RefinableContact contact;
  stoss_body first;
  std::optional<stoss_body> second{};  ///< otherwise a wall
  stoss::Vibration vibration{};
  double speed_unit = 1.0;  ///< m/s where the encounter is in SI
  double friction = 0.0;    ///< that of the encounter
};

struct stoss_function {
  stoss::RestitutionFunction function;
};
