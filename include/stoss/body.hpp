#pragma once

// Bodies by themselves: everything in include/stoss/body/.

#include "stoss/body/body.hpp"
