#pragma once

#include <optional>

#include "stoss/encounter/encounter.hpp"
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
  stoss::Encounter encounter{};        ///< with its units and vibration; without any where bodies made it
};

struct stoss_function {
  stoss::RestitutionFunction function;
};
