#pragma once

// Bodies that vibrate: everything in include/stoss/vibration/.

#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/ensemble.hpp"
#include "stoss/vibration/quantities.hpp"
#include "stoss/vibration/rod_chain.hpp"
#include "stoss/vibration/rod_chain_run.hpp"
