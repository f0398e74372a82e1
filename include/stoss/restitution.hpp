#pragma once

// Coefficients of restitution: everything in include/stoss/restitution/.

#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/ladder.hpp"
#include "stoss/restitution/oblique.hpp"
#include "stoss/restitution/oblique_curve.hpp"
#include "stoss/restitution/restitution.hpp"
