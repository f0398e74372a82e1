#include "stoss/version.hpp"

namespace stoss {

std::string_view version() { return STOSS_VERSION; }

}  // namespace stoss
