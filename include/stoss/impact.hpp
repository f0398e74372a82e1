#pragma once

// Impacts: everything in include/stoss/impact/.

#include "stoss/impact/impact.hpp"
#include "stoss/impact/oblique.hpp"
#include "stoss/impact/oblique_snapshot.hpp"
#include "stoss/impact/replay.hpp"
#include "stoss/impact/resolution.hpp"
#include "stoss/impact/sound.hpp"
#include "stoss/impact/state.hpp"
#include "stoss/impact/vibration.hpp"
