#include "restitution/error_bar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/ladder/climb.hpp"

namespace stoss {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// How the error of a quantity other than 1 − ε² follows from the differences of runs.
struct Bar {
  double order;   ///< at which it falls with the cutoff, at most
  double safety;  ///< by which the maximum difference is multiplied
};
constexpr Bar instant{1.5, 5.0};     // at which waves open or close the contact once more
constexpr Bar rough{1.5, 4.0};       // the peak of a force that jumps about
constexpr Bar rougher{1.0, 4.0};     // of a ball on a half-space or a plate
constexpr Bar last_touch{1.0, 4.0};  // of a ball that a plate follows: short waves delay it
constexpr Bar smooth{2.0, 6.0};      // what is integrated twice, or between two parts of the impulse

/// What 1 − ε² lacks at a cutoff, as shares of the unresolved energy.
struct Missing {
  double share;  ///< which the modes above the cutoff would return
  double doubt;  ///< by which one run may be off
};

/// @param cutoff over the time scale of the contact
/// @param speed  of the faster body in its own wave speed
Missing missing_on_a_line(double cutoff, double speed) {
  constexpr double at_64 = 0.0115, cutoff_power = 0.8, at_16 = 0.27;
  const double slow = std::clamp(std::pow(speed / 0.02, -0.1), 1.0, 1.7);
  const double fast = 1.0 / (1.0 + speed / 0.1);
  const double calm = std::min(2.2, std::pow(speed / 1e-4, -0.25));
  const double whole = at_64 * std::pow(64.0 / cutoff, cutoff_power) * slow, share = whole * fast;
  const double noise = at_16 * calm * std::pow(16.0 / cutoff, 2.5);
  // At high speed the errors have either sign: they are greater than their mean.
  const double either = std::min(std::pow(speed / 0.33, 4), 3.5);
  return {share, std::max(0.8 * share + noise, either * whole)};
}

/// The same where a circle touches. At low speed the loss is a wave of the speed (docs/theory/spheres.md), and what one
/// run is off by falls no faster than the cutoff rises.
Missing missing_of_balls(double cutoff, double speed) {
  constexpr double at_64 = 0.045, cutoff_power = 0.6, at_16 = 0.2;
  const double slow = std::clamp(std::pow(speed / 0.02, -0.1), 1.0, 1.7);
  const double fast = 1.0 / (1.0 + speed / 0.2);
  const double whole = at_64 * std::pow(64.0 / cutoff, cutoff_power) * slow, share = whole * fast;
  const double calm = std::max(std::min(std::pow(speed / 1e-3, -0.4), 16.0), std::pow(speed / 1e-3, -0.25));
  // At high speed the errors have either sign: they fall less than their mean.
  return {share, std::max(0.8 * share + at_16 * calm * 16.0 / cutoff, 0.6 * whole)};
}

/// Share of the error by nodes that is left where each of them relaxes while the edge passes it: n nodes in a time t,
/// 2 η n/t or some τ n/t of them in the time of relaxation. Each term counts as it loses in an impact.
double left_by_relaxing(const Contact& contact, double nodes, double duration) {
  constexpr double relaxing = 0.7, always = 0.03;  // fits
  const double loss_time = touch(contact).loss_time, viscous = 1.0 + 2.0 * loss_time * nodes / duration;
  double sum = 0.0, whole = 0.0;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr) continue;
    const UnitRatios units = units_of(contact, number);
    for (const RelaxationTerm& term : body->relaxation.terms) {
      const double time = term.time * units.time, angle = std::numbers::pi * time / duration;
      const double loses = body->softness * units.softness * term.share * angle / (1.0 + angle * angle);
      const double passes = 1.0 + relaxing * time * nodes / duration;
      whole += loses;
      sum += loses * (always + (1.0 - always) / (passes * passes));
    }
  }
  return std::max(whole == 0.0 ? 0.0 : sum / whole, loss_time == 0.0 ? 0.0 : 1.0 / (viscous * viscous));
}

/// Error of what the material takes in one run, from its nodes: those that a lossy contact leaves are the worse
/// resolved the fewer there are and the less each of them relaxes meanwhile.
double node_error(const Contact& contact, const Run& run) {
  if (!loses(contact)) return 0.0;
  const double constant = touch(contact).circle ? 12.0 : 2.1, nodes = run.resolution.nodes;
  return constant * run.dissipated / (nodes * nodes) * left_by_relaxing(contact, nodes, run.contact_time);
}

/// To a plate that takes nearly all of the energy, more of it does nothing, and where a ball stays nothing can.
double rebound(const Contact& contact, const Run& run) {
  return contact.keeps_displacement ? std::pow(std::max(0.0, 1.0 - run.lost_fraction), 0.25) : 1.0;
}

/// Share of the unresolved energy that is the first body's: a half-space or a plate returns nothing.
double returned(const Contact& contact) { return contact.unbounded ? unresolved_share(contact) : 1.0; }

/// By what the loss changes with the compliance of what is met, relative to it: a half-space takes in proportion, and a
/// plate leaves a rebound ε² = 1 − q that falls exponentially with it, as in Zener's theory.
double sensitivity(const Contact& contact, double lost) {
  if (!contact.keeps_displacement) return std::abs(lost);
  const double left = 1.0 - lost;
  return left > 0.0 ? left * std::abs(std::log(left)) : 0.0;
}

Estimate lost_on_a_growing_contact(const Contact& contact, double speed, const std::vector<Run>& runs, double order) {
  constexpr double safety = 3.0;
  const auto missing = touch(contact).circle ? missing_of_balls : missing_on_a_line;
  const double scale = time_scale(contact), own = mach_number(contact, speed);
  const auto corrected = [&](const Run& run) {
    const double share = missing(run.cutoff * scale, own).share;
    return run.lost_fraction - rebound(contact, run) * returned(contact) * share * run.unresolved;
  };
  const Run& last = runs.back();
  const Missing lacks = missing(last.cutoff * scale, own);
  // At a half-space less is in doubt, as the body alone gives back; but its quadrature leaves something out. Both are
  // less on plates (docs/developer/numerics.md, section 14).
  constexpr double less = 0.5, of_a_half_space = 3e-5, of_a_plate = 3e-6, calm_on_a_plate = 0.5;
  const double calm = contact.keeps_displacement ? calm_on_a_plate : 1.0;
  const double quadrature = contact.keeps_displacement ? of_a_plate : of_a_half_space;
  const double doubt = calm * rebound(contact, last) * std::max(less, returned(contact)) * lacks.doubt;
  const bool returns = contact.unbounded && last.remaining == 0.0;  // a body that stays could have nothing more taken
  const double missed = returns ? quadrature * sensitivity(contact, last.lost_fraction) : 0.0;
  return {corrected(last), std::max({missed, doubt * last.unresolved, node_error(contact, last),
                                     safety * spread(runs, order, corrected)})};
}

Estimate lost_at_a_point(const std::vector<Run>& runs, double order) {
  constexpr double doubt = 0.5, safety = 6.0;
  const Run& last = runs.back();
  return {last.lost_fraction, std::max(doubt * last.unresolved, safety * spread(runs, order, &Run::lost_fraction))};
}

Estimate by_differences(const std::vector<Run>& runs, const Bar& bar, double highest_order, double Run::*quantity,
                        double least) {
  const double order = std::min(bar.order, highest_order);
  Estimate estimate{runs.back().*quantity, std::max(least, bar.safety * spread(runs, order, quantity))};
  // An error as large as the value leaves nothing of it.
  if (estimate.error >= std::abs(estimate.value)) estimate.error = unknown;
  return estimate;
}

/// Energy of the translation before the impact, as a share of the initial energy.
double translation_before(const EnergyLedger& ledger) {
  double share = 1.0;
  for (const ModeEnergy& mode : ledger.modes) share -= mode.before;
  return share;
}

/// Fills what each body keeps, and what the material takes, so that it adds up to the loss of a concluded result.
///
/// The ledger of the finest impact adds up to its own 1 − ε². What the result has less is energy that the modes above
/// the cutoff would have given back, each body its part of `unresolved`; of a half-space they give nothing back. What
/// the ledger misses, its energy error, belongs to each share as much as the share is large.
void apportion_losses(const Contact& contact, Restitution& result) {
  const EnergyLedger& ledger = result.finest.energy;
  const double unit = translation_before(ledger);
  const double given_back = unit * (result.finest.lost_fraction - result.lost_fraction.value);
  const double by_first = contact.unbounded ? 1.0 : unresolved_share(contact);
  const double first = ledger.lost_to_first - by_first * given_back;
  const double second = ledger.lost_to_second - (1.0 - by_first) * given_back;
  const double whole = 1.0 - unit * (1.0 - result.lost_fraction.value);
  const double counted = first + second;
  const double scale = counted == 0.0 ? 1.0 : whole / counted;
  result.lost_to_first = scale * first;
  result.lost_to_second = scale * second;
  result.dissipated = scale * ledger.dissipated;
}

}  // namespace

double convergence_order(const Contact& contact) {
  if (has_single_point(contact)) return 1.0;
  return loses(contact) ? 1.75 : 2.5;
}

void conclude(const Contact& contact, double speed, const CurvatureCorrection& correction, Restitution& result) {
  constexpr double focus = 0.6;          // a wave that comes back to the edge of a disk, or was there, is a short peak
  constexpr double roughness = 0.05;     // of the force of balls, from what of the unresolved energy may come back
  constexpr double ripple = 0.005;       // of a force that begins with a jump, in its mean (FlatForce)
  constexpr double blur = 0.5;           // of the period of that ripple, in which such a force ends
  constexpr double squared_step = 10.0;  // 95 % of 147 random half-spaces differ by less from finer runs
  constexpr double turn = 0.008;         // share of the unresolved energy that may be missing at closest approach
  const std::vector<Run>& runs = result.runs;
  const Run& last = runs.back();
  const bool at_a_point = has_single_point(contact);
  const double order = convergence_order(contact);
  result.lost_fraction =
      at_a_point ? lost_at_a_point(runs, order) : lost_on_a_growing_contact(contact, speed, runs, order);
  result.lost_fraction.error += neglected(correction, result.finest) + last.remaining;
  const double lost = result.lost_fraction.value, error = result.lost_fraction.error;
  const double squared = std::max(0.0, 1.0 - lost);
  const double value = std::copysign(std::sqrt(squared), result.finest.restitution);
  result.restitution = {value, error / (std::sqrt(squared + error) + std::abs(value))};
  const auto estimate = [&](const Bar& bar, double Run::*quantity, double least) {
    return by_differences(runs, bar, order, quantity, least);
  };
  // An instant is known to half a step at either end, and so are the parts of an impulse that begins with a jump.
  const double instants = (contact.keeps_displacement ? 2.0 : 1.0) * last.resolution.step +
                          (at_a_point ? blur * 2.0 * std::numbers::pi / last.cutoff : 0.0);
  result.contact_time = estimate(contact.keeps_displacement ? last_touch : instant, &Run::contact_time, instants);
  // Parts of the impulse are known to the square of the step, and three runs may agree by chance.
  const double steps = last.resolution.step / last.impulse_time;
  const double of_parts = (at_a_point ? 1.0 : squared_step * steps) * last.resolution.step;
  result.impulse_time = estimate(smooth, &Run::impulse_time, last.impulse_time > 0.0 ? of_parts : 0.0);
  const bool calm = touch(contact).circle && translation_before(result.finest.energy) == 1.0;  // balls at rest inside
  const double amplitude = calm ? roughness * std::sqrt(rebound(contact, last) * returned(contact)) : focus;
  const double beyond = std::max(amplitude * std::sqrt(std::max(0.0, last.unresolved)), at_a_point ? ripple : 0.0);
  const Bar& of_force = calm && contact.unbounded ? rougher : rough;
  result.max_force = estimate(of_force, &Run::max_force, beyond * last.max_force);
  const double missing = turn * last.unresolved + (at_a_point ? 0.0 : node_error(contact, last));
  result.max_compression = estimate(smooth, &Run::max_compression, missing * std::abs(last.max_compression));
  if (last.remaining > 0.0) {  // a body that stays goes on pushing, and moving along with the plate
    for (Estimate* lasting : {&result.contact_time, &result.impulse_time, &result.max_compression}) {
      lasting->error = unknown;
    }
  }
  apportion_losses(contact, result);
  result.converged = error <= std::max(result.tolerance * std::abs(lost), result.absolute);
}

}  // namespace stoss
