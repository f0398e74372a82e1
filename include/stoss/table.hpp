#pragma once

// ε(v) as a function: everything in include/stoss/table/.

#include "stoss/table/adaptive.hpp"
#include "stoss/table/c_source.hpp"
#include "stoss/table/restitution_function.hpp"
#include "stoss/table/slow_law.hpp"
#include "stoss/table/two_column.hpp"
