#include "contact/yield/indentation.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "contact/touch.hpp"
#include "stoss/errors.hpp"

namespace stoss {

namespace {

/// At a strength in E.
Onset onset_at(double strength, const Contact& contact, double speed) {
  const double hardening = contact.yield.hardening;
  const Touch met = touch(contact);
  const double strain = 0.5 * std::numbers::pi * yield_pressure_ratio * strength * met.softness;
  Onset onset;
  onset.radius = strain / met.curvature;
  onset.depth = strain * onset.radius;
  onset.force = 4.0 / 3.0 * onset.depth * onset.radius / met.softness;
  constexpr double most = 1e6;
  const double work = 0.5 * contact.whole_mass * speed * speed / (onset.force * onset.depth);
  onset.deepest = work >= loading_work(most, hardening) ? most : depth_of_work(work, hardening);
  return onset;
}

}  // namespace

Onset onset_of(const Contact& contact, double speed) {
  const auto& [yield, hardening, rate, reference] = contact.yield;
  Onset onset = onset_at(yield, contact, speed);
  const std::vector<RelaxingBody> relaxing = relaxing_bodies(contact);
  if (rate == 0.0 && relaxing.empty()) return onset;
  constexpr int rounds = 8;
  const double curvature = touch(contact).curvature;
  for (int i = 0; i < rounds; ++i) {
    const double inverse_time = speed / (onset.depth * onset.deepest);
    const double strain = 0.2 * onset.radius * loading_radius(onset.deepest) * curvature;
    const double harder = 1.0 + rate * std::log(std::max(1.0, strain * inverse_time / reference));
    const double frequency = std::numbers::pi / hertzian_duration * inverse_time;
    double softer = 1.0;  // E(0) over the modulus
    for (const RelaxingBody& each : relaxing) {
      softer += each.share * (1.0 / std::abs(modulus(each.relaxation, {0.0, frequency})) - 1.0);
    }
    onset = onset_at(yield * harder * softer, contact, speed);
  }
  return onset;
}

Indentation::Indentation(const Contact& contact, double compliance, double speed, double step)
    : onset_(onset_of(contact, speed)),
      hardening_(contact.yield.hardening),
      compliance_(compliance * onset_.force / onset_.depth),
      answers_(contact, step),
      springs_(answers_, loading_radius(onset_.deepest)),
      rest_(answers_.none()) {}

double Indentation::returned(double depth) const {
  return depth > back_.residual ? (depth - back_.residual) / (deepest_ - back_.residual) : 0.0;
}

double Indentation::force_at(double depth) const {
  if (depth >= deepest_) return loading_force(std::max(depth, 0.0), hardening_);
  return most_ * std::pow(returned(depth), back_.exponent);
}

double Indentation::stiffness_at(double depth) const {
  if (depth >= deepest_) return loading_stiffness(std::max(depth, 0.0), hardening_);
  return most_ * back_.exponent / (deepest_ - back_.residual) * std::pow(returned(depth), back_.exponent - 1.0);
}

/// Of d + k f(d) = target, by Newton's method between bounds.
double Indentation::root(double target, double compliance, double low, double high) const {
  constexpr int most = 200;
  constexpr double rounding = 1e-15;
  double depth = std::clamp(depth_, low, high);
  for (int i = 0; i < most; ++i) {
    const double rest = depth + compliance * force_at(depth) - target;
    (rest > 0.0 ? high : low) = depth;
    double next = depth - rest / (1.0 + compliance * stiffness_at(depth));
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double change = std::abs(next - depth);
    depth = next;
    if (change <= rounding * (1.0 + depth)) break;
  }
  return depth;
}

/// Goes to the depth where d + k f(d) = target.
void Indentation::press(double target, double compliance) {
  if (target >= deepest_ + compliance * most_) {  // deeper than ever
    double high = std::max(target, deepest_);
    constexpr int most = 60;
    for (int wider = 0; high + compliance * loading_force(high, hardening_) < target; ++wider) {
      if (wider == most || 1.0 + compliance * loading_stiffness(high, hardening_) <= 0.0) {
        throw NotConverged("impact: the yielding contact is wider than its points", "half_width", "give a larger one");
      }
      high += 0.25 * high;
    }
    depth_ = deepest_ = root(target, compliance, deepest_, high);
    most_ = loading_force(deepest_, hardening_);
    return;
  }
  const double dent = back().residual;
  depth_ = target <= dent ? target : root(target, compliance, dent, deepest_);
}

/// From the deepest compression so far.
const Unloading& Indentation::back() {
  if (back_from_ != deepest_) back_ = unloading(deepest_, hardening_), back_from_ = deepest_;
  return back_;
}

void Indentation::press_before(double deepest) {
  before_ = deepest_ = deepest;
  most_ = loading_force(deepest, hardening_);
}

void Indentation::move(double place) {
  const double missing = answers_.missing(rest_), answer = answers_.answer();
  const double share = std::clamp(2.0 * share_ - share_before_, 0.0, 1.0 + answer);  // at the end of the step
  const double flowed = answers_.relaxes() ? flow_down_to(deepest_) : 0.0;
  press(place / onset_.depth - compliance_ * missing / answer, compliance_ * share / answer);
  const double pressed = force_at(depth_);
  share_before_ = share_;
  if (answers_.relaxes()) share_ = springs_.move(answers_, depth_ - back().residual, back().radius_ratio);
  if (answers_.relaxes()) flow_ += 0.5 * (share_before_ + share_) * (flow_down_to(deepest_) - flowed);
  const double before = force_;
  force_ = onset_.force * share_ * pressed;
  work_ += 0.5 * (place - place_) * (before + force_);
  answers_.keep(rest_, (share_ * pressed + missing) / answer);
  place_ = place;
}

double Indentation::radius() const {
  if (force_ == 0.0) return 0.0;
  const double widest = onset_.radius * loading_radius(deepest_);
  return depth_ >= deepest_ ? widest : widest * std::sqrt(returned(depth_));
}

double Indentation::dent() const { return onset_.depth * unloading(deepest_, hardening_).residual; }

double Indentation::stored() const {
  if (force_ == 0.0) return 0.0;
  const double unit = onset_.force * onset_.depth, all = unit * unloading_work(deepest_, hardening_);
  const double rest = 0.5 * unit * compliance_ * rest_.before * rest_.before;
  return rest + share_ * (depth_ >= deepest_ ? all : all * std::pow(returned(depth_), back_.exponent + 1.0));
}

/// Of materials without loss.
double Indentation::flow_down_to(double depth) const {
  return onset_.force * onset_.depth * (loading_work(depth, hardening_) - unloading_work(depth, hardening_));
}

double Indentation::flow() const { return answers_.relaxes() ? flow_ : flow_down_to(deepest_) - flow_down_to(before_); }

}  // namespace stoss
