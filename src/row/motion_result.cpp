// What is known of the motion of a row: its energies, its results, what an observer sees.
#include <algorithm>
#include <cmath>
#include <limits>

#include "row/motion.hpp"

namespace stoss {

double total(const RowEnergy& its) {
  return its.translation + its.vibration + its.contact + its.unresolved + its.dissipated + its.yielded;
}

double RowMotion::momentum() const {
  double sum = 0.0;
  for (const RowSolid& solid : solids_) sum += std::isfinite(solid.mass()) ? solid.mass() * solid.velocity() : 0.0;
  return sum;
}

RowEnergy RowMotion::in_units() const {
  RowEnergy its;
  for (const RowSolid& solid : solids_) {
    its.translation += solid.translation();
    its.vibration += solid.vibration();
    its.dissipated += solid.dissipated();
    its.contact += solid.stored_across();
  }
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    const double unit = energy_unit(row_.units_of(row_.joints[k]));
    its.contact += unit * meetings_[k].stored();
    its.unresolved += unit * meetings_[k].unresolved();
    its.dissipated += unit * meetings_[k].dissipated();
    its.yielded += unit * meetings_[k].yielded();
  }
  return its;
}

RowEnergy RowMotion::energy() const {
  RowEnergy its = in_units();
  for (double* each : {&its.translation, &its.vibration, &its.contact, &its.unresolved, &its.dissipated, &its.yielded})
    *each /= translation_;
  return its;
}

RowImpact RowMotion::result() const {
  RowImpact made;
  made.step = row_.step;
  made.steps = steps_;
  made.time = time();
  const double mass = solids_.front().mass();
  double of_walls = 0.0;
  for (const RowSolid& solid : solids_) made.velocities_after.push_back(solid.velocity());
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    const MadeRow::Joint& joint = row_.joints[k];
    const UnitRatios& units = row_.units_of(joint);
    const Meeting& its = meetings_[k];
    const double impulse = its.impulse * units.force * units.time;
    made.strain = std::max(made.strain, its.strain());
    const bool stands = joint.other < 0 || !std::isfinite(body(joint.other)->mass());
    if (stands) of_walls += joint.face == Face::right ? -impulse : impulse;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    made.contacts.push_back({joint.face == Face::left ? -1 : joint.one, its.touches > 0 ? its.first_touch : none,
                             its.touches > 0 ? its.last_touch : none, its.touches,
                             its.greatest_force * units.force / mass, impulse / mass,
                             its.greatest_compression * units.length});
  }
  made.energy = energy();
  made.energy_error = total(made.energy) - whole_ / translation_;
  made.momentum_error = (momentum() - momentum_ - of_walls) / (mass * row_.fastest);
  for (const RowSolid& solid : solids_) {
    made.after.coordinate.push_back(solid.coordinate());
    made.after.momentum.push_back(solid.momentum());
  }
  made.open = open();
  std::size_t modes = 0;
  for (const auto& each : row_.bodies) modes += mode_count(*each);
  constexpr double of_a_contact = 600.0;  // modes
  made.work =
      static_cast<double>(steps_) * (static_cast<double>(modes) + of_a_contact * static_cast<double>(meetings_.size()));
  return made;
}

void RowMotion::observe(const RowWatch& watch) {
  if (!watch.observer) return;
  for (std::size_t b = 0; b < solids_.size(); ++b) {
    const double flown = is_awake(b) ? 0.0 : static_cast<double>(now_ - known_at_[b]) * row_.step;
    displacement_[b] = solids_[b].position() + solids_[b].velocity() * flown;
    velocity_[b] = solids_[b].velocity();
  }
  const double mass = solids_.front().mass();
  for (std::size_t k = 0; k < meetings_.size(); ++k) {
    force_[k] = meetings_[k].force() * row_.units_of(row_.joints[k]).force / mass;
  }
  watch.observer({time(), displacement_, velocity_, force_, energy()});
}

}  // namespace stoss
