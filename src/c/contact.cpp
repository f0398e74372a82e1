#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "c/interface.hpp"
#include "encounter/participant.hpp"
#include "stoss/contact/contact.hpp"
#include "stoss/encounter/collision.hpp"
#include "stoss/encounter/document.hpp"
#include "stoss/errors.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/oblique_curve.hpp"

namespace {

using stoss::c::guarded;
using stoss::c::require_given;

stoss_estimate in_c(const stoss::Estimate& estimate) { return {estimate.value, estimate.error}; }

stoss_result in_c(double speed, const stoss::Restitution& result) {
  return {speed,
          in_c(result.restitution),
          in_c(result.lost_fraction),
          in_c(result.contact_time),
          in_c(result.max_force),
          in_c(result.max_compression),
          result.converged ? 1 : 0};
}

stoss_oblique_result in_c(const stoss::ObliqueRestitution& result) {
  const stoss::Obliquity& before = result.before;
  return {{result.speed, before.tangential, before.spin, before.second_spin, before.friction},
          result.sliding,
          in_c(result.restitution),
          in_c(result.tangential_restitution),
          in_c(result.sliding_after),
          in_c(result.tangential_after),
          in_c(result.spin_after),
          in_c(result.second_spin_after),
          in_c(result.friction_loss),
          in_c(result.vibration),
          result.neglected.dundurs,
          result.neglected.restitution,
          result.neglected.tangential_restitution,
          result.neglected.sliding_after,
          result.converged ? 1 : 0};
}

}  // namespace

extern "C" {

int stoss_wall_contact_make(const stoss_body* body, stoss_contact** contact) {
  return guarded([&] {
    require_given(body, "body");
    require_given(contact, "contact");
    constexpr double without_modes = 1e-6;
    (void)stoss::contact(body->maker(without_modes, {}));  // refuses what cannot meet a wall
    *contact = new stoss_contact{stoss::RefinableContact(body->maker), *body};
  });
}

int stoss_pair_contact_make(const stoss_body* first, const stoss_body* second, stoss_contact** contact) {
  return guarded([&] {
    require_given(first, "first");
    require_given(second, "second");
    require_given(contact, "contact");
    *contact = new stoss_contact{stoss::RefinableContact(first->maker, second->maker), *first, *second};
  });
}

int stoss_open(const char* json, stoss_contact** contact) {
  return guarded([&] {
    require_given(json, "json");
    require_given(contact, "contact");
    const stoss::Encounter given = stoss::encounter_from_json(json);
    const stoss::Solid solid = stoss::first_solid(given);
    const stoss_body first{solid, given.first.rigid, stoss::first_maker(given),
                           stoss::relaxation_of(given, given.first, solid)};
    stoss_contact made{stoss::refinable(given), first};
    if (const auto second = stoss::second_solid(given)) {
      const stoss::Participant& its = given.against.kind == "same" ? given.first : given.against;
      made.second = stoss_body{*second, given.against.rigid, stoss::second_maker(given),
                               stoss::relaxation_of(given, its, *second)};
    }
    made.encounter = given;
    *contact = new stoss_contact(std::move(made));
  });
}

double stoss_speed_unit(const stoss_contact* contact) {
  return contact == nullptr ? 1.0 : stoss::speed_unit(contact->encounter);
}

void stoss_contact_free(stoss_contact* contact) { delete contact; }

int stoss_collision(const stoss_contact* contact, const char* json, stoss_obliquity* obliquity) {
  return guarded([&] {
    require_given(contact, "contact");
    require_given(json, "json");
    require_given(obliquity, "obliquity");
    const auto [speed, before] = stoss::own_units(contact->encounter, stoss::collision_from_json(json));
    *obliquity = {speed, before.tangential, before.spin, before.second_spin, before.friction};
  });
}

int stoss_curve(const stoss_contact* contact, const double* speeds, size_t count, double tolerance, double absolute,
                const stoss_control* control, stoss_result* results) {
  return guarded([&] {
    require_given(contact, "contact");
    require_given(speeds, "speeds");
    require_given(results, "results");
    const std::vector<double> at(speeds, speeds + count);
    std::vector<stoss_result> found;
    std::string reason;
    const stoss::CurveOptions options{.each = {.tolerance = tolerance,
                                               .absolute = absolute,
                                               .poll = stoss::c::poll_of(control),
                                               .vibration = contact->encounter.vibration},
                                      .threads = stoss::c::threads_of(control)};
    stoss::restitution_curve(contact->contact, at, options, [&](std::size_t i, const stoss::Restitution& result) {
      found.push_back(in_c(at[i], result));
      if (!result.converged && reason.empty()) reason = "speed " + std::to_string(i) + ": " + result.reason;
    });
    std::copy(found.begin(), found.end(), results);
    if (!reason.empty()) throw stoss::NotConverged(reason);
  });
}

int stoss_oblique(const stoss_contact* contact, const stoss_obliquity* obliquities, size_t count, double tolerance,
                  const stoss_control* control, stoss_oblique_result* results) {
  return guarded([&] {
    require_given(contact, "contact");
    require_given(obliquities, "obliquities");
    require_given(results, "results");
    std::vector<stoss::ObliqueCase> cases;
    for (std::size_t i = 0; i < count; ++i) {
      const stoss_obliquity& its = obliquities[i];
      cases.push_back({its.speed, {its.tangential, its.spin, its.second_spin, its.friction}});
    }
    std::vector<stoss_oblique_result> found;
    std::string reason;
    const stoss::ObliqueCurveOptions options{
        .each = {.tolerance = tolerance, .poll = stoss::c::poll_of(control), .vibration = contact->encounter.vibration},
        .threads = stoss::c::threads_of(control)};
    stoss::oblique_curve(contact->contact, cases, options, [&](std::size_t i, const stoss::ObliqueRestitution& result) {
      found.push_back(in_c(result));
      if (!result.converged && reason.empty()) {
        reason = "obliquity " + std::to_string(i) + ": " + result.reason;
      }
    });
    std::copy(found.begin(), found.end(), results);
    if (!reason.empty()) throw stoss::NotConverged(reason);
  });
}

}  // extern "C"
