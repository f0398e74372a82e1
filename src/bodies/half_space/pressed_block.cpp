#include "bodies/half_space/pressed_block.hpp"

#include <algorithm>
#include <cmath>

#include "bodies/half_space/lasting_force.hpp"

namespace stoss::bodies::half_space {
namespace {

/// Σ of the changes of a polygon times the answers at the steps since.
void convolve(const std::vector<double>& polygon, const Instants& its, const std::vector<Displaced>& answer,
              const Displaced& weight, std::vector<double>& normal, std::vector<double>& radial) {
  const double unit = 1.0 / its.step;
  for (std::size_t i = 0; i < its.outputs; ++i) {
    const std::size_t now = i * its.stride + its.before;
    double along = 0.0, out = 0.0;
    for (std::size_t j = 0; j + 1 < polygon.size() && j < now; ++j) {
      const double change = polygon[j + 1] - polygon[j];
      const Displaced& moved = answer[now - j - 1];
      along += change * moved.normal;
      out += change * moved.radial;
    }
    normal[i] += weight.normal * unit * along;
    radial[i] += weight.radial * unit * out;
  }
}

std::vector<double> slopes(const std::vector<double>& of, double step) {
  std::vector<double> its(of.size(), 0.0);
  for (std::size_t j = 1; j + 1 < of.size(); ++j) its[j] = 0.5 * (of[j + 1] - of[j - 1]) / step;
  return its;
}

}  // namespace

PressedBlock::PressedBlock(double poisson, double distance, double depth, double largest, const Instants& instants,
                           const Poll& poll)
    : instants_(instants), cross_(largest) {
  const double modulus = 0.5 / (1.0 + poisson), speed = std::sqrt(modulus);
  const std::size_t count = instants.outputs * instants.stride + instants.before + 1;
  const double step = instants.step * speed, latest = step * static_cast<double>(count);
  const auto add = [&](bool middle, double at, double normal, double radial) {
    const LastingForce lasting(PointForce(poisson, at, depth), latest, poll);
    sources_.push_back(
        {middle, {normal / (modulus * speed), radial / (modulus * speed)}, lasting.over_steps(step, count)});
  };
  add(true, distance, 1.0, 1.0);
  if (!(cross_.reach > 0.0)) return;
  cross_.around(distance, [&](double at, double normal, double radial) { add(false, at, normal, radial); });
}

Motion PressedBlock::of(const PressedLoad& load) const {
  Motion motion(instants_.outputs);
  std::vector<double> middle = load.force, around = load.force;
  for (std::size_t j = 0; j < middle.size(); ++j) {
    around[j] *= cross_.share(load.radius[j]);
    middle[j] -= around[j];
  }
  const std::vector<double> middle_slope = slopes(middle, instants_.step),
                            around_slope = slopes(around, instants_.step);
  for (const Source& source : sources_) {
    convolve(source.middle ? middle : around, instants_, source.answer, source.weight, motion.normal, motion.radial);
    convolve(source.middle ? middle_slope : around_slope, instants_, source.answer, source.weight,
             motion.normal_velocity, motion.radial_velocity);
  }
  return motion;
}

}  // namespace stoss::bodies::half_space
