#include "quantity_help.hpp"
#include "stoss/restitution/quantities.hpp"

namespace stoss {

using enum Dimension;

const Quantities<Pulse>& pulse_quantities() {
  using P = Pulse;
  static const Quantities<P> all{
      {"peak_force", force, help::max_force, &P::peak_force},
      {"contact_time", time, help::slow_contact_time, &P::contact_time},
      {"duration", time, "Time while the force is above the threshold", &P::duration},
      {"rise", time, "Time from the first force to the maximum", &P::rise},
      {"impulse", momentum, "Momentum that the contact transfers", &P::impulse},
      {"asymmetry", none, "1 less twice the share of the impulse before the maximum: positive where it falls slowly",
       &P::asymmetry},
      {"corner_frequency", frequency, "Angular frequency at which the amplitude of the force has fallen to 0.707",
       &P::corner_frequency},
      {"first_null", frequency, "Angular frequency of the first minimum of the amplitude of the force", &P::first_null},
      {"from_hertz", none, "Greatest difference from the pulse of Hertz' theory over its maximum, of balls",
       &P::from_hertz},
      {"from_sine", none, "Greatest difference from sin^(3/2) of the same maximum and contact time, over the maximum",
       &P::from_sine},
      {"threshold", none, "Share of the maximum force above which the duration is taken", &P::threshold},
      {"restitution", none, help::restitution, &P::restitution},
      {"yielded", none, help::yielded, [](const P& p) { return p.finest.energy.yielded; }},
      {"dissipated", none, help::dissipated, [](const P& p) { return p.finest.energy.dissipated; }},
      {"cutoff", frequency, help::cutoff, [](const P& p) { return p.finest.cutoff; }},
      {"runs", none, help::runs, [](const P& p) { return static_cast<long>(p.cutoffs.size()); }},
      {"steps", none, help::all_steps, &P::steps},
      {"converged", none, help::converged, &P::converged},
      {"strain", none, help::strain, [](const P& p) { return p.finest.strain; }},
      {"beyond_small_strain", none, help::beyond_small_strain, [](const P& p) { return p.finest.beyond_small_strain; }},
  };
  return all;
}

const Quantities<PulseInstant>& pulse_instant_quantities() {
  using I = PulseInstant;
  static const Quantities<I> all{
      {"time", time, "Time after unexcited bodies would touch", &I::time},
      {"force", force, help::force, &I::force},
  };
  return all;
}

}  // namespace stoss
