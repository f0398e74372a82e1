#pragma once

// What meets what: everything in include/stoss/contact/.

#include "stoss/contact/contact.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/contact/wall.hpp"
