// Hollow spheres are not computed here: their modes would make a third of a second of loading on a slow line.
#include "bodies/sphere/hole/radial_shell.hpp"
#include "stoss/errors.hpp"

namespace stoss::bodies::sphere {

RadialShell::RadialShell(double, double, double, double) {
  throw InvalidInput::out_of_range("body", "a hollow sphere", "another body here", "the command and Python have it");
}

std::vector<Mode> RadialShell::modes(int, double) const { return {}; }
std::vector<ToroidalMode> RadialShell::toroidal_modes(int, double) const { return {}; }
RadialShell::Response RadialShell::response(int) const { return {}; }
RadialShell::ToroidalResponse RadialShell::toroidal_response(int) const { return {}; }

}  // namespace stoss::bodies::sphere
