// A free–free rod: u(s) = Σ Q_l √2 cos lπs, ω_l = lπ (l ≥ 1). Σ_l 2/(lπ)² = 1/3 is its static compliance with inertia
// relief, Σ_l 2/(lπ)⁴ = 1/45 the second moment; its impedance is that of a plane wave, 1, at every frequency.
#include "stoss/bodies/rod.hpp"

#include <cmath>
#include <numbers>

#include "check.hpp"

namespace stoss {

Body rod(double cutoff) {
  constexpr Range allowed{std::numbers::pi, 1e4, true, true, "3.14160 to 10000"};
  require("cutoff", cutoff, allowed, "highest frequency of the rod in c/L; its lowest mode is at pi");
  ModeGroup group;
  double compliance = 1.0 / 3.0, second_moment = 1.0 / 45.0;
  for (int l = 1; l * std::numbers::pi <= cutoff; ++l) {
    const double omega = l * std::numbers::pi;
    group.omega.push_back(omega);
    group.radial.push_back(std::numbers::sqrt2);
    group.tangential.push_back(0.0);
    compliance -= 2.0 / (omega * omega);
    second_moment -= 2.0 / (omega * omega * omega * omega);
  }
  Body body;
  body.name = "rod";
  body.mass = 1.0;
  body.extent = 0.5;
  body.cutoff = cutoff;
  body.groups.push_back(std::move(group));
  body.expected_half_width = [](double) { return 0.0; };
  body.grid = [](double, int) { return ContactGrid{{0.0}, {0.0}, {1.0}, {1.0}, {1.0}}; };
  body.residual_compliance = [compliance](const ContactGrid&, const Poll&) { return std::vector<double>{compliance}; };
  body.residual_second_moment = [second_moment](const ContactGrid&, const Poll&) {
    return std::vector<double>{second_moment};
  };
  return body;
}

BodyMaker rod() {
  return [](double cutoff, const Poll&) { return rod(cutoff); };
}

}  // namespace stoss
