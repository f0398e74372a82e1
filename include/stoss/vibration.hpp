#pragma once

// Bodies that vibrate: everything in include/stoss/vibration/.

#include "stoss/vibration/bounce.hpp"
