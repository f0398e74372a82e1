// A rod with a mass μ at its rear end: u(s) = C cos ωs, s from the struck end, tan ω = −μω.
#include "stoss/bodies/hammer.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "check.hpp"

namespace stoss {
namespace {

/// The root of sin ω + μω cos ω between (l − ½)π and lπ, by bisection.
double frequency(double ratio, int index) {
  double low = (index - 0.5) * std::numbers::pi;
  double high = index * std::numbers::pi;
  const auto f = [ratio](double omega) { return std::sin(omega) + ratio * omega * std::cos(omega); };
  const bool sign = std::signbit(f(low));
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (std::signbit(f(middle)) == sign ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Body hammer(double ratio, double cutoff) {
  require("ratio", ratio, {0.0, 1e6, false, true, "above 0 to 1e6"}, "point mass over the mass of the rod");
  require("cutoff", cutoff, {0.0, 1e5, false, true, "above 0 to 100000"}, "highest frequency in c/L");

  Body body;
  body.name = "hammer";
  body.contour = Contour::flat;
  body.mass = 1.0 + ratio;
  body.scale = {1.0, 1.0, body.mass};
  body.extent = (0.5 + ratio) / body.mass;
  body.cutoff = cutoff;
  body.highest_cutoff = 1e5;

  // Displacement of the struck end against the centre of mass under a unit force: Σ C²/(mω²) over all modes.
  double compliance = (0.5 + ratio - (1.0 / 6.0 + 0.5 * ratio) / body.mass) / body.mass;
  // Σ C²/(mω⁴) = ∫ u² ds + μ u(1)² of that displacement, u = u(0) − s + a s².
  const double a = 0.5 / body.mass, end = compliance - 1.0 + a;
  double moment = compliance * compliance + 1.0 / 3.0 + a * a / 5.0 - compliance + 2.0 * compliance * a / 3.0 -
                  0.5 * a + ratio * end * end;
  ModeGroup group;  // of one shape only: all weight is on the first row
  for (int l = 1;; ++l) {
    const double omega = frequency(ratio, l);
    if (omega > cutoff) break;
    // ∫ u² ds + μ u(1)² = 1 + μ, so that the modal mass is the mass of the body.
    const double c = std::cos(omega);
    const double amplitude = std::sqrt(body.mass / (0.5 + 0.5 * std::sin(omega) * c / omega + ratio * c * c));
    group.omega.push_back(omega);
    group.upper.push_back(amplitude);
    group.lower.push_back(0.0);
    compliance -= amplitude * amplitude / (body.mass * omega * omega);
    moment -= amplitude * amplitude / (body.mass * std::pow(omega, 4));
  }
  body.groups.push_back(std::move(group));

  // A flat end is asked about a single point, on the axis.
  body.surface = [](const ContactPoints&) {
    return Surface{.recess = {0.0}, .measure = {1.0}, .impedance = {1.0}, .shape = {1.0}};
  };
  body.residual_compliance = [compliance](const ContactPoints&, const Poll&) { return std::vector{compliance}; };
  body.residual_second_moment = [moment](const ContactPoints&, const Poll&) { return std::vector{moment}; };
  return body;
}

}  // namespace stoss
