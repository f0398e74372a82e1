// With the force f = s^(3/2) as well as s: the ball moves at V = ṡ + λ f, V̇ = −f, and the plate at λ f.
#include "contact/zener.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"

namespace stoss {
namespace {

using Motion = std::array<double, 2>;  // s, V

Motion rate(const Motion& at, double inelasticity) {
  const double force = at[0] > 0.0 ? at[0] * std::sqrt(at[0]) : 0.0;
  return {at[1] - inelasticity * force, -force};
}

Motion moved(const Motion& at, const Motion& rate, double time) {
  return {at[0] + time * rate[0], at[1] + time * rate[1]};
}

}  // namespace

ZenerImpact zener_impact(double inelasticity, const ZenerMotion& start) {
  constexpr double usual_step = 2e-3, stays = 2e-5;
  constexpr double following = 0.03, room = 2.0;  // ṡ over V of a ball that follows its force, and for how long
  constexpr double rounding = 1e-12;              // of ṡ over V
  // A ball that follows its force has −ṡ/V = ⅔ λ^(−5/3) V^(−1/3): with this λ or more it does so until it stays.
  constexpr double follows_to_the_end = 20.0;
  // From s = 0 on, in the time in which the dashpot's force grows to the speed's.
  const double first_step = std::cbrt(0.04 / (inelasticity * inelasticity));
  double time = 0.0, followed = 0.0;
  Motion now{start.compression, start.speed};
  while (true) {
    // A stiff dashpot lets the compression follow the speed of the ball at once.
    const double stiff = 1.5 * inelasticity * std::sqrt(std::max(now[0], 0.0));
    const double step = std::min(usual_step * (1.0 + 0.2 * time), std::min(0.3 / stiff, first_step));
    const Motion first = rate(now, inelasticity), second = rate(moved(now, first, 0.5 * step), inelasticity);
    const Motion third = rate(moved(now, second, 0.5 * step), inelasticity);
    const Motion fourth = rate(moved(now, third, step), inelasticity);
    Motion next = now;
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] += step / 6.0 * (first[i] + 2.0 * second[i] + 2.0 * third[i] + fourth[i]);
    }
    if (next[0] <= 0.0) {
      const double share = now[0] / (now[0] - next[0]);
      return {-(now[1] + share * (next[1] - now[1])), time + share * step};
    }
    const bool back = first[0] < rounding * now[1], slowly = -first[0] < following * now[1];
    if (followed == 0.0 && back && slowly) followed = room * time;
    now = next;
    time += step;
    if (followed > 0.0 && time > followed && inelasticity > follows_to_the_end) return {0.0, followed};
    const double potential = 0.8 * now[0] * now[0] * std::sqrt(now[0]);  // over the same ½mv² as V²
    if (now[1] * now[1] + potential < stays) return {0.0, followed > 0.0 ? std::min(followed, time) : time};
  }
}

ZenerScales zener_scales(const Contact& contact, double speed) {
  const Touch met = touch(contact);
  const double stiffness = 4.0 / (3.0 * met.softness * std::sqrt(met.curvature));
  const double time = std::pow(contact.whole_mass / (stiffness * std::sqrt(speed)), 0.4);
  const double mobility = contact.second->part.mobility / units_of(contact, 1).impedance;
  return {mobility * contact.whole_mass / time, time};
}

}  // namespace stoss
