#pragma once

#include "stoss/body/body.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/stoss.h"
#include "stoss/table/restitution_function.hpp"

// What the handles of the C interface hold.

struct stoss_body {
  stoss::BodyMaker maker;
};

struct stoss_contact {
  stoss::RefinableContact contact;
};

struct stoss_function {
  stoss::RestitutionFunction function;
};
