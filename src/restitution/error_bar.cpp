#include "restitution/error_bar.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/touch.hpp"
#include "contact/unit_ratios.hpp"
#include "restitution/calibration.hpp"
#include "restitution/face_errors.hpp"
#include "restitution/few_modes.hpp"
#include "restitution/ladder/climb.hpp"
#include "restitution/layer_doubt.hpp"
#include "restitution/loss_shares.hpp"
#include "restitution/missing_energy.hpp"
#include "restitution/node_errors.hpp"
#include "restitution/yield_errors.hpp"

namespace stoss {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// b of the thinner shell of both, 0 of solid bodies.
double thinner_hole(const Contact& contact) {
  return std::max(contact.first->hole, contact.second == nullptr ? 0.0 : contact.second->hole);
}

/// To a plate that takes nearly all of the energy, more of it does nothing, and where a ball stays nothing can.
double rebound(const Contact& contact, const Run& run) {
  return contact.keeps_displacement ? std::pow(std::max(0.0, 1.0 - run.lost_fraction), 0.25) : 1.0;
}

/// Share of the unresolved energy that is the first body's: a half-space or a plate returns nothing.
double returned(const Contact& contact) { return contact.unbounded ? unresolved_share(contact) : 1.0; }

/// What follows from the differences of runs.
template <typename Quantity>
Term by_differences(std::string_view constant, const calibration::Differences& from, const std::vector<Run>& runs,
                    double highest_order, const Quantity& quantity) {
  const double order = std::min(from.order, highest_order);
  return {constant, from.safety, from.safety * spread(runs, order, quantity)};
}

Bar lost_on_a_growing_contact(const Contact& contact, double speed, const std::vector<Run>& runs, double order) {
  using namespace calibration;
  const bool circle = touch(contact).circle;
  const double thin = thinner_hole(contact);
  const auto missing = [circle, thin](double cutoff, double own) {
    return circle ? missing_of_balls(cutoff, own, thin) : missing_on_a_line(cutoff, own);
  };
  const double scale = time_scale(contact), own = mach_number(contact, speed);
  const bool few = has_few_modes(contact);
  const auto corrected_from = [&](const Run& run, double least) {
    const double share = missing(std::max(run.cutoff * scale, least), own).share;
    return run.lost_fraction - rebound(contact, run) * returned(contact) * share * run.unresolved;
  };
  const auto corrected = [&](const Run& run) { return corrected_from(run, 0.0); };
  const Run& last = runs.back();
  const double value = few ? corrected_from(last, share_of_few_modes_from) : corrected(last);
  Term doubt = few ? doubt_of_few_modes(runs, scale, own) : missing(last.cutoff * scale, own).doubt;
  // At a half-space less is in doubt, as the body alone gives back; but its quadrature leaves something out. Both are
  // less on plates (docs/developer/numerics.md, section 14).
  const bool plate = contact.keeps_displacement;
  const double calm = plate ? calm_on_a_plate : 1.0;
  doubt.error = calm * rebound(contact, last) * std::max(least_returned, returned(contact)) * doubt.error;
  if (!few) doubt.error *= last.unresolved;
  Bar bar{&Restitution::lost_fraction, value, {doubt, node_error_of_losses(contact, speed, last)}};
  bar.terms.push_back(lost_error_of_faces(contact, speed, last));
  if (contact.unbounded && last.remaining == 0.0) {  // a body that stays could have nothing more taken
    const double waves = plate ? waves_of_a_plate : waves_of_a_half_space;
    bar.terms.push_back({plate ? "waves_of_a_plate" : "waves_of_a_half_space", waves,
                         waves * sensitivity(contact, last.lost_fraction)});
  }
  bar.terms.push_back(by_differences("lost_fraction.safety", lost_fraction, runs, order, corrected));
  return bar;
}

Bar lost_at_a_point(const std::vector<Run>& runs, double order) {
  using namespace calibration;
  const Run& last = runs.back();
  return {&Restitution::lost_fraction,
          last.lost_fraction,
          {{"unresolved_at_a_point", unresolved_at_a_point, unresolved_at_a_point * last.unresolved},
           by_differences("lost_at_a_point.safety", calibration::lost_at_a_point, runs, order, &Run::lost_fraction)}};
}

std::vector<Bar> other_bars(const Contact& contact, double speed, const Restitution& result, double order) {
  using namespace calibration;
  const std::vector<Run>& runs = result.runs;
  const Run& last = runs.back();
  const bool at_a_point = has_single_point(contact), plate = contact.keeps_displacement;
  const bool calm = touch(contact).circle && translation_before(result.finest.energy) == 1.0;  // balls at rest inside
  const bool of_waves = calm && contact.unbounded;
  const auto differences = [&](std::string_view constant, const Differences& from, double Run::*quantity) {
    return by_differences(constant, from, runs, order, quantity);
  };
  // An instant is known to half a step at either end, and so are the parts of an impulse that begins with a jump.
  const Term instants{
      at_a_point ? "blur" : "", blur,
      (plate ? 2.0 : 1.0) * last.resolution.step + (at_a_point ? blur * 2.0 * std::numbers::pi / last.cutoff : 0.0)};
  // Parts of the impulse are known to the square of the step, and three runs may agree by chance.
  const double steps = last.resolution.step / last.impulse_time;
  const double of_parts = (at_a_point ? 1.0 : squared_step * steps) * last.resolution.step;
  const Term parts{at_a_point ? "" : "squared_step", squared_step, last.impulse_time > 0.0 ? of_parts : 0.0};
  // A wave that comes back to the edge of a disk, or was there, is a short peak; balls have roughness, from what of the
  // unresolved energy may come back.
  const double shell = roughness_of_shells * std::pow(thinner_hole(contact), 6);
  const double amplitude = shell + (calm ? roughness * std::sqrt(rebound(contact, last) * returned(contact)) : focus);
  const double peak = amplitude * std::sqrt(std::max(0.0, last.unresolved));
  Term force{calm ? "roughness" : "focus", calm ? roughness : focus, peak * last.max_force};
  if (shell > roughness) force.constant = "roughness_of_shells", force.in_use = roughness_of_shells;
  if (at_a_point && ripple > peak) force = {"ripple", ripple, ripple * last.max_force};
  const Term nodes = at_a_point ? Term{} : node_error_of_losses(contact, speed, last);
  const double closest = turn * last.unresolved, missing = closest + nodes.error;
  Term compression = closest < nodes.error ? nodes : Term{"turn", turn, 0.0};
  compression.error = missing * std::abs(last.max_compression);
  return {{&Restitution::contact_time,
           last.contact_time,
           {plate ? differences("last_touch.safety", last_touch, &Run::contact_time)
                  : differences("contact_time.safety", calibration::contact_time, &Run::contact_time),
            instants, yield_error_of_time(contact, result, last.contact_time)}},
          {&Restitution::impulse_time,
           last.impulse_time,
           {differences("smooth.safety", smooth, &Run::impulse_time), parts,
            yield_error_of_time(contact, result, last.impulse_time),
            pulse_error_of_faces(contact, last, last.impulse_time)}},
          {&Restitution::max_force,
           last.max_force,
           {of_waves ? differences("force_of_waves.safety", force_of_waves, &Run::max_force)
                     : differences("max_force.safety", calibration::max_force, &Run::max_force),
            force, yield_error_of_force(contact, result, last.max_force),
            pulse_error_of_faces(contact, last, last.max_force)}},
          {&Restitution::max_compression,
           last.max_compression,
           {differences("smooth.safety", smooth, &Run::max_compression), compression,
            yield_error_of_force(contact, result, last.max_compression), compression_error_of_faces(contact, last)}}};
}

}  // namespace

const Term& Bar::greatest() const {
  return *std::max_element(terms.begin(), terms.end(), [](const Term& a, const Term& b) { return a.error < b.error; });
}

double convergence_order(const Contact& contact, double speed) {
  if (has_single_point(contact)) return calibration::lost_at_a_point.order;
  const bool slower = loses(contact) && contact.yield.yield == 0.0 && leaves_edge(contact, speed);
  const double order = slower ? calibration::order_of_losses : calibration::lost_fraction.order;
  return std::min(
      order, calibration::lost_fraction.order - calibration::slower_in_shells * std::pow(thinner_hole(contact), 6));
}

double sensitivity(const Contact& contact, double lost) {
  if (!contact.keeps_displacement) return std::abs(lost);
  const double left = 1.0 - lost;
  return left > 0.0 ? left * std::abs(std::log(left)) : 0.0;
}

std::vector<Bar> error_bars(const Contact& contact, double speed, const Restitution& result) {
  const double order = convergence_order(contact, speed);
  std::vector<Bar> bars = other_bars(contact, speed, result, order);
  bars.insert(bars.begin(), has_single_point(contact) ? lost_at_a_point(result.runs, order)
                                                      : lost_on_a_growing_contact(contact, speed, result.runs, order));
  return bars;
}

void add_spacing(const Contact& contact, Restitution& result) {
  const Run& last = result.runs.back();
  if (!contact.unbounded || last.remaining > 0.0) return;
  const double nodes = last.resolution.nodes, lost = result.lost_fraction.value;
  const double open = calibration::spacing_on_waves * sensitivity(contact, lost) / (nodes * nodes);
  if (open <= result.lost_fraction.error) return;
  result.lost_fraction.error = open;
  const double squared = std::max(0.0, 1.0 - lost);
  result.restitution.error = open / (std::sqrt(squared + open) + std::abs(result.restitution.value));
}

void conclude(const Contact& contact, double speed, const CurvatureCorrection& correction, Restitution& result) {
  const Run& last = result.runs.back();
  for (const Bar& bar : error_bars(contact, speed, result)) {
    Estimate& estimate = result.*bar.estimate;
    estimate = {bar.value, bar.greatest().error};
    // An error as large as the value leaves nothing of it.
    const bool is_loss = bar.estimate == &Restitution::lost_fraction;
    if (!is_loss && estimate.error >= std::abs(estimate.value)) estimate.error = unknown;
  }
  result.lost_fraction.error += neglected(correction, result.finest) + last.remaining;
  const double lost = result.lost_fraction.value, error = result.lost_fraction.error;
  const double squared = std::max(0.0, 1.0 - lost);
  const double value = std::copysign(std::sqrt(squared), result.finest.restitution);
  result.restitution = {value, error / (std::sqrt(squared + error) + std::abs(value))};
  if (last.remaining > 0.0) {  // a body that stays goes on pushing, and moving along with the plate
    for (Estimate* unending : {&result.contact_time, &result.impulse_time, &result.max_compression}) {
      unending->error = unknown;
    }
  }
  apportion_losses(contact, result);
  result.converged = error <= std::max(result.tolerance * std::abs(lost), result.absolute);
}

void add_doubt_of_laws(const Contact& contact, Restitution& result) {
  const double open = doubt_of_layers(contact, result.runs.back()) + doubt_of_yield(contact, result.finest);
  if (open == 0.0) return;
  result.lost_fraction.error += open;
  const double squared = std::max(0.0, 1.0 - result.lost_fraction.value), error = result.lost_fraction.error;
  result.restitution.error = error / (std::sqrt(squared + error) + std::abs(result.restitution.value));
}

}  // namespace stoss
