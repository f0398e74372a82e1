#pragma once

// Impacts: everything in include/stoss/impact/.

#include "stoss/impact/impact.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/impact/resolution.hpp"
