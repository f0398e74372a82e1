#include "bodies/half_space/pressed_block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stoss::bodies::half_space {
namespace {

/// ∫Ḟ G dt of a series F at its steps.
void convolve(const std::vector<double>& series, const Instants& its, const std::vector<LastingForce::Step>& answer,
              const Displaced& weight, std::vector<double>& normal, std::vector<double>& radial) {
  std::vector<double> rate(series.size() - 1), turn(series.size() - 1, 0.0);
  for (std::size_t j = 0; j < rate.size(); ++j) rate[j] = (series[j + 1] - series[j]) / its.step;
  for (std::size_t j = 1; j + 1 < rate.size(); ++j) turn[j] = 0.5 * (rate[j + 1] - rate[j - 1]) / its.step;
  for (std::size_t i = 0; i < its.outputs; ++i) {
    const std::size_t now = i * its.stride + its.before;
    double along = 0.0, out = 0.0;
    for (std::size_t j = 0; j < rate.size() && j < now; ++j) {
      const LastingForce::Step& moved = answer[now - j - 1];
      along += rate[j] * moved.whole.normal - turn[j] * moved.moment.normal;
      out += rate[j] * moved.whole.radial - turn[j] * moved.moment.radial;
    }
    normal[i] += weight.normal * along;
    radial[i] += weight.radial * out;
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
    std::vector<LastingForce::Step> steps =
        LastingForce(PointForce(poisson, at, depth), latest, poll).over_steps(step, count);
    for (LastingForce::Step& each : steps) each.moment.normal /= speed, each.moment.radial /= speed;
    sources_.push_back({middle, {normal / (modulus * speed), radial / (modulus * speed)}, std::move(steps)});
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
