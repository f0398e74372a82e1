#include "tables.hpp"

#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/sphere/modes.hpp"
#include "stoss/impact/quantities.hpp"
#include "stoss/quasistatic/quantities.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::cli {

using bodies::disk::Mode;
using quasistatic::DrivenMode;
using quasistatic::PointRayleighEstimate;
using quasistatic::RayleighEstimate;

namespace {

/// Of Rayleigh's estimates for one kind of body.
template <typename Made>
Table<Made> table_of_estimates(const Quantities<Made>& quantities) {
  return Table<Made>(quantities, {
                                     {"lost_fraction",
                                      {.width = 24,
                                       .si_width = 24,
                                       .with_error = true,
                                       .marked = [](const Made& e) { return e.beyond_perturbation; }}},
                                     {"contact_time", {.width = 14, .si_width = 17}},
                                     {"max_compression", {.width = 17, .si_width = 20}},
                                     {"max_force", {.width = 13}},
                                 });
}

/// Of static contacts. @param size what the half-width is called, and how it is shown
Table<Compressed> table_of_compressions(const std::string& size, const Column<Compressed>& shown) {
  using C = Compressed;
  using enum Dimension;
  const auto static_force = [](const C& c) { return Estimate{c.contact.force, c.contact.force_error}; };
  const Quantities<C> quantities{
      {"compression", length, &C::compression},  //
      {"force", force, &C::force},               //
      {"energy", energy, &C::energy},            //
      {size, length, &C::half_width},            //
      {"static_force", force, static_force},
  };
  return Table<C>(quantities, {
                                  {"compression", {.width = 13, .si_width = 16}},
                                  {"force", {.width = 13, .si_width = 13}},
                                  {"energy", {.width = 13, .si_width = 13}},
                                  {size, shown},
                                  {"static_force", {.width = 25, .si_width = 17, .with_error = true}},
                              });
}

}  // namespace

const Table<Restitution>& restitution_table() {
  const auto unconverged = [](const Restitution& r) { return !r.converged; };
  static const Table<Restitution> table(
      restitution_quantities(),
      {
          {"restitution", {.width = 22, .si_width = 22, .with_error = true}},
          {"lost_fraction", {.width = 25, .si_width = 25, .with_error = true, .marked = unconverged}},
          {"contact_time", {.width = 13, .si_width = 17}},
          {"cutoff", {.in_si = false}},
      });
  return table;
}

const Table<Run>& run_table() {
  static const Table<Run> table(run_quantities());
  return table;
}

const Table<ExtrapolatedRestitution>& extrapolation_table() {
  static const Table<ExtrapolatedRestitution> table(
      extrapolation_quantities(), {
                                      {"restitution", {.width = 22, .si_width = 22, .with_error = true}},
                                      {"lost_fraction", {.width = 24, .si_width = 24, .with_error = true}},
                                      {"impacts", {.width = 9, .si_width = 9}},
                                  });
  return table;
}

const Table<SoftImpact>& soft_impact_table() {
  static const Table<SoftImpact> table(soft_impact_quantities());
  return table;
}

const Table<Impact>& impact_table() {
  static const Table<Impact> table(impact_quantities(), {
                                                            {"cutoff", {.in_si = false}},
                                                            {"step", {.in_si = false}},
                                                            {"half_width", {.left_out = true}},
                                                        });
  return table;
}

const Table<EnergyLedger>& ledger_table() {
  static const Table<EnergyLedger> table(ledger_quantities());
  return table;
}

const Table<ModeEnergy>& mode_energy_table() {
  static const Table<ModeEnergy> table(mode_energy_quantities());
  return table;
}

const Table<Snapshot>& snapshot_table() {
  static const Table<Snapshot> table(snapshot_quantities());
  return table;
}

const Table<Sample>& sample_table() {
  const auto unconverged = [](const Sample& sample) { return !sample.converged; };
  static const Table<Sample> table(
      sample_quantities(),
      {
          {"sample", {.width = 8, .si_width = 8}},
          {"vibration", {.width = 13, .si_width = 13}},
          {"restitution", {.width = 22, .si_width = 22, .with_error = true}},
          {"lost_fraction", {.width = 25, .si_width = 25, .with_error = true, .marked = unconverged}},
          {"contact_time", {.width = 13, .si_width = 17}},
      });
  return table;
}

const Table<DistributionSummary>& distribution_table() {
  static const Table<DistributionSummary> table(distribution_quantities());
  return table;
}

const Table<Bounce>& bounce_table() {
  static const Table<Bounce> table(bounce_quantities(), {
                                                            {"number", {.width = 8, .si_width = 8}},
                                                            {"speed", {.width = 13, .si_width = 13}},
                                                            {"restitution", {.width = 13, .si_width = 13}},
                                                            {"translation", {.width = 13, .si_width = 13}},
                                                            {"vibration", {.width = 13, .si_width = 13}},
                                                            {"dissipated", {.width = 13, .si_width = 13}},
                                                            {"unresolved", {.width = 13, .si_width = 13}},
                                                            {"flight_time", {.width = 13, .si_width = 16}},
                                                        });
  return table;
}

const Table<Mode>& mode_table() {
  static const Table<Mode> table(bodies::disk::mode_quantities(), {
                                                                      {"order", {.width = 7, .si_width = 7}},
                                                                      {"index", {.width = 7, .si_width = 7}},
                                                                      {"omega", {.width = 13, .si_width = 13}},
                                                                      {"radial", {.width = 13, .si_width = 13}},
                                                                      {"tangential", {.width = 13, .si_width = 13}},
                                                                      {"family", {.width = 13, .si_width = 13}},
                                                                  });
  return table;
}

const Table<bodies::sphere::Mode>& sphere_mode_table() {
  static const Table<bodies::sphere::Mode> table(bodies::sphere::mode_quantities(),
                                                 {
                                                     {"order", {.width = 7, .si_width = 7}},
                                                     {"index", {.width = 7, .si_width = 7}},
                                                     {"omega", {.width = 13, .si_width = 13}},
                                                     {"radial", {.width = 13, .si_width = 13}},
                                                     {"tangential", {.width = 13, .si_width = 13}},
                                                 });
  return table;
}

const Table<RayleighEstimate>& rayleigh_table() {
  static const Table<RayleighEstimate> table = table_of_estimates(quasistatic::rayleigh_quantities());
  return table;
}

const Table<PointRayleighEstimate>& point_rayleigh_table() {
  static const Table<PointRayleighEstimate> table = table_of_estimates(quasistatic::point_rayleigh_quantities());
  return table;
}

const Table<DrivenMode>& driven_mode_table() {
  static const Table<DrivenMode> table(quasistatic::driven_mode_quantities());
  return table;
}

const Table<Compressed>& compression_table() {
  static const Table<Compressed> table = table_of_compressions("half_width", {.width = 12, .si_width = 15});
  return table;
}

const Table<Compressed>& point_compression_table() {
  static const Table<Compressed> table = table_of_compressions("contact_radius", {.width = 16, .si_width = 19});
  return table;
}

}  // namespace stoss::cli
