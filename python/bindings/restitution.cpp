// The coefficient of restitution: curves, distributions, sequences, chains.
#include <array>
#include <optional>

#include "rows.hpp"
#include "stoss/restitution/curve.hpp"
#include "stoss/restitution/quantities.hpp"
#include "stoss/restitution/restitution.hpp"
#include "stoss/vibration/bounce.hpp"
#include "stoss/vibration/distribution.hpp"
#include "stoss/vibration/quantities.hpp"
#include "stoss/vibration/rod_chain_run.hpp"
#include "support.hpp"

namespace stoss::python {
namespace {

void curve(const RefinableContact& contact, const Doubles& speeds, double tolerance, double absolute, int threads,
           const Oscillations& state, py::array& rows, py::list reasons, const std::optional<py::function>& tick) {
  if (rows.size() != speeds.size()) throw std::invalid_argument("rows: one restitution_row for each speed");
  const std::vector<double> at = to_vector(speeds);
  const CurveOptions options{
      .each = {.tolerance = tolerance, .absolute = absolute, .poll = signal_poll(), .vibration = to_vibration(state)},
      .threads = threads};
  fill(restitution_quantities(), rows, reasons, tick, [&](const auto& put) {
    restitution_curve(contact, at, options, [&](std::size_t, const Restitution& result) { put(result); });
  });
}

using Means = py::array_t<MeanEnergy, py::array::c_style>;

Spectrum to_spectrum(const Means& array) { return {array.data(), array.data() + array.size()}; }

py::dict summarize(const Doubles& restitution, const Doubles& error) {
  std::vector<Sample> samples(static_cast<std::size_t>(restitution.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].restitution = samples[i].lost_fraction = {restitution.data()[i], error.data()[i]};
  }
  return to_dict(distribution_quantities(), summary(samples));
}

/// Adds the rows of a sequence to `done` at its end, also if Ctrl-C ends it. Returns why it ended too early.
std::string sequence(const Contact& contact, const std::string& tail, double speed, long count,
                     std::optional<double> flight_time, std::optional<double> gravity, std::optional<double> decay_time,
                     const Oscillations& state, py::list done) {
  const BounceOptions options{.count = count,
                              .flight_time = flight_time,
                              .gravity = gravity,
                              .decay_time = decay_time,
                              .resolution = {.tail = to_tail(tail)},
                              .vibration = to_vibration(state),
                              .poll = signal_poll()};
  Rows<Bounce> rows(bounce_quantities());
  try {
    const Released released;
    bounce(contact, speed, options, [&](const Bounce& bounce, const Impact&) { rows.add(bounce); });
  } catch (const NotConverged& error) {
    done.append(rows.take());
    return error.what();
  } catch (const py::error_already_set&) {
    done.append(rows.take());
    throw;
  }
  done.append(rows.take());
  return {};
}

/// A chain and what was seen of it so far.
struct WatchedChain {
  RodChain chain;
  RodChainRecord record{};
};

std::vector<Rod> rods_of(const std::vector<std::array<double, 5>>& values) {
  std::vector<Rod> rods;
  for (const auto& [length, young, density, area, loss_time] : values) {
    rods.push_back({length, young, density, area, loss_time});
  }
  return rods;
}

void bind_distribution(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(MeanEnergy, body, order, index, energy);
  module.attr("mean_energy") = py::dtype::of<MeanEnergy>();
  module.attr("sample_row") = Rows<Sample>(sample_quantities()).type();
  def(module, "thermal", {"contact", "temperature", "highest"},
      [](const RefinableContact& contact, double temperature, double highest) {
        return take(computed([&](const Poll& poll) { return thermal(contact, temperature, highest, poll); }));
      });
  def(module, "usual_highest", {"contact"}, [](const RefinableContact& contact) {
    return computed([&](const Poll& poll) { return usual_highest(contact, poll); });
  });
  def(module, "frequencies", {"contact", "spectrum"}, [](const RefinableContact& contact, const Means& spectrum) {
    const Spectrum modes = to_spectrum(spectrum);
    return take(computed([&](const Poll& poll) { return frequencies(contact, modes, poll); }));
  });
  def(module, "check_distribution", {"contact", "speed", "spectrum", "samples", "seed", "error", "threads"},
      [](const RefinableContact& contact, double speed, const Means& spectrum, long samples, std::uint64_t seed,
         double error, int threads) {
        const Spectrum means = to_spectrum(spectrum);
        const DistributionOptions options{
            .samples = samples, .seed = seed, .error = error, .threads = threads, .poll = signal_poll()};
        const Released released;
        validate(contact, speed, means, options);
      });
  def(module, "restitution_distribution",
      {"contact", "speed", "spectrum", "seed", "error", "threads", "rows", "reasons", "tick", "first"},
      [](const RefinableContact& contact, double speed, const Means& spectrum, std::uint64_t seed, double error,
         int threads, py::array& rows, py::list reasons, const std::optional<py::function>& tick, long first) {
        const Spectrum means = to_spectrum(spectrum);
        const DistributionOptions options{.first = first,
                                          .samples = static_cast<long>(rows.size()),
                                          .seed = seed,
                                          .error = error,
                                          .threads = threads,
                                          .poll = signal_poll()};
        fill(sample_quantities(), rows, reasons, tick,
             [&](const auto& put) { restitution_distribution(contact, speed, means, options, put); });
      });
  def(module, "summary", {"restitution", "error"}, &summarize);
}

void bind_rod_chain(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RodCollision, time, pair, speed, restitution, vibration_before, vibration_after, unresolved);
  PYBIND11_NUMPY_DTYPE(RodChainSample, time, collisions, translation, vibration, dissipated, unresolved, momentum);
  def(module, "thermal_velocities", {"rods", "temperature", "seed"},
      [](const std::vector<std::array<double, 5>>& rods, double temperature, std::uint64_t seed) {
        return take(thermal_velocities(rods_of(rods), temperature, seed));
      });
  py::class_<WatchedChain> chain(module, "RodChain", "A chain of rods and what was seen of it.");
  seal(chain);
  def(module, "rod_chain", {"rods", "circumference", "velocities", "modes", "count", "pieces", "tail", "decay_time"},
      [](const std::vector<std::array<double, 5>>& rods, double circumference, const Doubles& velocities, bool modes,
         int count, int pieces, const std::string& tail, std::optional<double> decay_time) {
        RodChainOptions options;
        options.method = modes ? RodMethod::modes : RodMethod::characteristics;
        options.modes = count;
        options.pieces = pieces;
        options.resolution.tail = to_tail(tail);
        options.decay_time = decay_time;
        options.poll = signal_poll();
        return WatchedChain{RodChain(rods_of(rods), circumference, to_vector(velocities), options)};
      });
  def(chain, "run", {"collisions", "time"}, [](WatchedChain& self, long collisions, double time) {
    const Released released;
    run(self.chain, self.record, collisions, time);
  });
  def(chain, "collisions", [](const WatchedChain& self) { return take(std::vector(self.record.collisions)); });
  def(chain, "samples", [](const WatchedChain& self) { return take(std::vector(self.record.samples)); });
  def(chain, "velocities", [](const WatchedChain& self) { return take(self.chain.velocities()); });
}

}  // namespace

void bind_restitution(py::module_& module) {
  module.attr("restitution_row") = Rows<Restitution>(restitution_quantities()).type();
  def(module, "check_curve", {"speeds", "tolerance", "absolute", "threads"},
      [](const Doubles& speeds, double tolerance, double absolute, int threads) {
        validate(to_vector(speeds), {.each = {.tolerance = tolerance, .absolute = absolute}, .threads = threads});
      });
  def(module, "restitution_curve",
      {"contact", "speeds", "tolerance", "absolute", "threads", "state", "rows", "reasons", "tick"}, &curve);
  def(module, "slowest_bounce", {"speed"}, &slowest_bounce);
  def(module, "bounce", {"contact", "tail", "speed", "count", "flight_time", "gravity", "decay_time", "state", "done"},
      &sequence);
  bind_distribution(module);
  bind_rod_chain(module);
}

}  // namespace stoss::python
