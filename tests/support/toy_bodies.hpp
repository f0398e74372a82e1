#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "stoss/body/body.hpp"

namespace stoss::test {

/// A body with one point of contact, made from bare numbers: modes of amplitude 1 or as given. The second moment is
/// that of a family of high overtones, so that the mass of the tail is Z π/(6 ω_c).
inline Body point_body(double mass, double cutoff, double residual_compliance, double impedance, ModeGroup modes) {
  Body body;
  body.name = "toy";
  body.mass = mass;
  body.extent = 0.5;
  body.cutoff = cutoff;
  body.groups.push_back(std::move(modes));
  body.surface = [impedance](const ContactPoints&) { return Surface{{0.0}, {1.0}, {impedance}, {1.0}}; };
  body.residual_compliance = [residual_compliance](const ContactPoints&, const Poll&) {
    return std::vector<double>{residual_compliance};
  };
  const double second_moment =
      residual_compliance * residual_compliance * impedance * std::numbers::pi / (6.0 * cutoff);
  body.residual_second_moment = [second_moment](const ContactPoints&, const Poll&) {
    return std::vector<double>{second_moment};
  };
  return body;
}

/// Two point masses, half of `mass` each, on a spring: one mode, no modes above the cutoff.
inline Body dumbbell(double mass, double omega) {
  return point_body(mass, omega, 1e-9, 1.0, {1, {omega}, {1.0}, {0.0}});
}

/// A thin rod in any units: length L, wave speed c, mass per length λ; modes lπc/L with amplitude √2, impedance λc.
inline Body rod_in_other_units(double length, double wave_speed, double line_density, double cutoff) {
  const double mass = line_density * length;
  ModeGroup modes;
  double compliance = length / (3.0 * line_density * wave_speed * wave_speed);
  double second_moment = std::pow(length, 3) / (45.0 * line_density * std::pow(wave_speed, 4));
  for (int l = 1; l * std::numbers::pi * wave_speed / length <= cutoff; ++l) {
    const double omega = l * std::numbers::pi * wave_speed / length;
    modes.omega.push_back(omega);
    modes.upper.push_back(std::numbers::sqrt2);
    modes.lower.push_back(0.0);
    compliance -= 2.0 / (mass * omega * omega);
    second_moment -= 2.0 / (mass * std::pow(omega, 4));
  }
  Body body = point_body(mass, cutoff, compliance, line_density * wave_speed, std::move(modes));
  body.extent = 0.5 * length;
  body.residual_second_moment = [second_moment](const ContactPoints&, const Poll&) {
    return std::vector<double>{second_moment};
  };
  return body;
}

/// Two points of contact with the compliance ((2, 1), (1, 2)) and one stiff mode.
inline Body two_point_body() {
  Body body = point_body(1.0, 5.0, 0.0, 1.0, {0, {5.0}, {1.0}, {0.0}});
  body.contour = Contour::cylinder;
  body.surface = [](const ContactPoints&) { return Surface{{0.0, 0.1}, {1.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}}; };
  body.residual_compliance = [](const ContactPoints&, const Poll&) { return std::vector<double>{2.0, 1.0, 1.0, 2.0}; };
  body.residual_second_moment = [](const ContactPoints&, const Poll&) {
    return std::vector<double>{0.2, 0.1, 0.1, 0.2};
  };
  return body;
}

}  // namespace stoss::test
