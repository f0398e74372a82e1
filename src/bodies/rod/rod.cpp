// A free–free rod: u(s) = Σ Q_l √2 cos lπs, ω_l = lπ (l ≥ 1). Σ_l 2/(lπ)² (1/3 over all l) is its static compliance
// with inertia relief, Σ_l 2/(lπ)⁴ (1/45) the second moment; its impedance is that of a plane wave, 1, at every
// frequency.
#include "stoss/bodies/rod.hpp"

#include <boost/math/special_functions/polygamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "check.hpp"

namespace stoss {
namespace {

constexpr double highest_cutoff = 1e6;

/// η in L/c
double own_loss_time(const Rod& rod) {
  return in_own_time(rod.loss_time, std::sqrt(rod.young / rod.density) / rod.length);
}

void require_rod(const Rod& rod) {
  constexpr Range positive{0.0, std::numeric_limits<double>::max(), false, true, "a positive finite number"};
  require("length", rod.length, positive, "of the rod");
  require("young", rod.young, positive, "Young's modulus of the rod");
  require("density", rod.density, positive, "of the rod");
  require("area", rod.area, positive, "cross-section of the rod");
  require_loss_time(own_loss_time(rod));
}

std::string name_of(const Rod& rod) {
  std::string name = "rod";
  if (rod.length != 1.0) name += " length=" + shown(rod.length);
  if (rod.young != 1.0) name += " young=" + shown(rod.young);
  if (rod.density != 1.0) name += " density=" + shown(rod.density);
  if (rod.area != 1.0) name += " area=" + shown(rod.area);
  if (rod.loss_time != 0.0) name += " loss_time=" + shown(rod.loss_time);
  return name;
}

}  // namespace

Scales scales(const Rod& rod) {
  require_rod(rod);
  const double speed = std::sqrt(rod.young / rod.density);
  return {rod.length, speed, rod.length / speed, speed / rod.length, rod.young * rod.area};
}

Body rod(const Rod& rod, double cutoff) {
  require_rod(rod);
  require("cutoff", cutoff, {0.0, highest_cutoff, false, true, "above 0 to 1e6"}, "highest frequency in c/L");
  ModeGroup group;
  const double highest = kept_cutoff(cutoff, own_loss_time(rod));
  for (int l = 1; l * std::numbers::pi <= highest; ++l) {
    const double omega = l * std::numbers::pi;
    group.omega.push_back(omega);
    group.upper.push_back(std::numbers::sqrt2);
    group.lower.push_back(0.0);
  }
  // Σ_{l>L} 1/l² = ψ′(L + 1), Σ_{l>L} 1/l⁴ = ψ‴(L + 1)/6: no difference of nearly equal numbers.
  const auto next = static_cast<double>(group.omega.size() + 1);
  constexpr double square = std::numbers::pi * std::numbers::pi;
  const double compliance = 2.0 / square * boost::math::trigamma(next);
  const double second_moment = boost::math::polygamma(3, next) / (3.0 * square * square);
  Body body;
  body.name = name_of(rod);
  body.scale = {rod.length, std::sqrt(rod.young / rod.density), rod.density * rod.area * rod.length};
  body.contour = Contour::flat;
  body.mass = 1.0;
  body.extent = 0.5;
  body.loss_time = own_loss_time(rod);
  body.cutoff = cutoff;
  body.highest_cutoff = highest_cutoff;
  body.groups.push_back(std::move(group));
  body.surface = [](const ContactPoints&) { return Surface{{0.0}, {1.0}, {1.0}, {1.0}}; };
  body.residual_compliance = [compliance](const ContactPoints&, const Poll&) {
    return std::vector<double>{compliance};
  };
  body.residual_second_moment = [second_moment](const ContactPoints&, const Poll&) {
    return std::vector<double>{second_moment};
  };
  // Σ_{l>L} (−1)^{l+1} 2/(lπ)²: modes move both ends outward in turn.
  const double sign = static_cast<long>(next) % 2 == 1 ? 1.0 : -1.0;
  const double opposite =
      sign * 0.5 / square * (boost::math::trigamma(0.5 * next) - boost::math::trigamma(0.5 * (next + 1.0)));
  body.opposite_compliance = [opposite](const ContactPoints&, const ContactPoints&) {
    return std::vector<double>{opposite};
  };
  return body;
}

Body rod(double cutoff) {
  require("cutoff", cutoff, {std::numbers::pi, highest_cutoff, true, true, "3.14160 to 1e6"},
          "highest frequency of the rod in c/L; its lowest mode is at pi");
  return rod(Rod{}, cutoff);
}

BodyMaker rod(const Rod& rod) {
  require_rod(rod);
  return [rod](double cutoff, const Poll&) { return stoss::rod(rod, cutoff); };
}

}  // namespace stoss
