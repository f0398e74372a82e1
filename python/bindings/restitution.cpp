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

/// What the command and the package ask of an ensemble.
struct Asked {
  long samples;
  std::uint64_t seed;
  double error;
  int threads;
  long first = 0;

  [[nodiscard]] DistributionOptions options() const {
    return {
        .first = first, .samples = samples, .seed = seed, .error = error, .threads = threads, .poll = signal_poll()};
  }
};

void distribution(const RefinableContact& contact, double speed, const Spectrum& spectrum, const Asked& asked,
                  py::array& rows, py::list reasons, const std::optional<py::function>& tick) {
  const DistributionOptions options = asked.options();
  fill(sample_quantities(), rows, reasons, tick,
       [&](const auto& put) { restitution_distribution(contact, speed, spectrum, options, put); });
}

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
  module.def(
      "thermal",
      [](const RefinableContact& contact, double temperature, double highest) {
        return take(computed([&](const Poll& poll) { return thermal(contact, temperature, highest, poll); }));
      },
      py::arg("contact"), py::arg("temperature"), py::arg("highest"));
  module.def(
      "usual_highest",
      [](const RefinableContact& contact) {
        return computed([&](const Poll& poll) { return usual_highest(contact, poll); });
      },
      py::arg("contact"));
  module.def(
      "frequencies",
      [](const RefinableContact& contact, const Means& spectrum) {
        const Spectrum modes = to_spectrum(spectrum);
        return take(computed([&](const Poll& poll) { return frequencies(contact, modes, poll); }));
      },
      py::arg("contact"), py::arg("spectrum"), "c/R of the first body");
  module.def(
      "check_distribution",
      [](const RefinableContact& contact, double speed, const Means& spectrum, long samples, std::uint64_t seed,
         double error, int threads) {
        const Spectrum means = to_spectrum(spectrum);
        const DistributionOptions options = Asked{samples, seed, error, threads}.options();
        const Released released;
        validate(contact, speed, means, options);
      },
      py::arg("contact"), py::arg("speed"), py::arg("spectrum"), py::arg("samples"), py::arg("seed"), py::arg("error"),
      py::arg("threads"));
  module.def(
      "restitution_distribution",
      [](const RefinableContact& contact, double speed, const Means& spectrum, std::uint64_t seed, double error,
         int threads, py::array& rows, const py::list& reasons, const std::optional<py::function>& tick, long first) {
        const Asked asked{static_cast<long>(rows.size()), seed, error, threads, first};
        distribution(contact, speed, to_spectrum(spectrum), asked, rows, reasons, tick);
      },
      py::arg("contact"), py::arg("speed"), py::arg("spectrum"), py::arg("seed"), py::arg("error"), py::arg("threads"),
      py::arg("rows").noconvert(), py::arg("reasons"), py::arg("tick"), py::arg("first") = 0,
      "fills rows and reasons from sample `first` on; calls tick, unless it is None, after each");
  module.def("summary", &summarize, py::arg("restitution"), py::arg("error"), "of samples, at least one with a value");
}

void bind_rod_chain(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(RodCollision, time, pair, speed, restitution, vibration_before, vibration_after, unresolved);
  PYBIND11_NUMPY_DTYPE(RodChainSample, time, collisions, translation, vibration, dissipated, unresolved, momentum);
  module.def(
      "thermal_velocities",
      [](const std::vector<std::array<double, 5>>& rods, double temperature, std::uint64_t seed) {
        return take(thermal_velocities(rods_of(rods), temperature, seed));
      },
      py::arg("rods"), py::arg("temperature"), py::arg("seed"));
  py::class_<WatchedChain> chain(module, "RodChain", "A chain of rods and what was seen of it.");
  seal(chain);
  module.def(
      "rod_chain",
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
      },
      py::arg("rods"), py::arg("circumference"), py::arg("velocities"), py::arg("modes"), py::arg("count"),
      py::arg("pieces"), py::arg("tail"), py::arg("decay_time"));
  chain.def(
      "run",
      [](WatchedChain& self, long collisions, double time) {
        const Released released;
        run(self.chain, self.record, collisions, time);
      },
      py::arg("collisions"), py::arg("time"));
  chain.def("collisions", [](const WatchedChain& self) { return take(std::vector(self.record.collisions)); });
  chain.def("samples", [](const WatchedChain& self) { return take(std::vector(self.record.samples)); });
  chain.def("velocities", [](const WatchedChain& self) { return take(self.chain.velocities()); });
}

}  // namespace

void bind_restitution(py::module_& module) {
  module.attr("restitution_row") = Rows<Restitution>(restitution_quantities()).type();
  module.def(
      "check_curve",
      [](const Doubles& speeds, double tolerance, double absolute, int threads) {
        validate(to_vector(speeds), {.each = {.tolerance = tolerance, .absolute = absolute}, .threads = threads});
      },
      py::arg("speeds"), py::arg("tolerance"), py::arg("absolute"), py::arg("threads"));
  module.def("restitution_curve", &curve, py::arg("contact"), py::arg("speeds"), py::arg("tolerance"),
             py::arg("absolute"), py::arg("threads"), py::arg("state"), py::arg("rows").noconvert(), py::arg("reasons"),
             py::arg("tick"), "fills rows and reasons; calls tick, unless it is None, after each");
  module.def("slowest_bounce", &slowest_bounce, py::arg("speed"));
  module.def("bounce", &sequence, py::arg("contact"), py::arg("tail"), py::arg("speed"), py::arg("count"),
             py::arg("flight_time"), py::arg("gravity"), py::arg("decay_time"), py::arg("state"), py::arg("done"),
             "appends the rows to done; returns why the sequence ended too early");
  bind_distribution(module);
  bind_rod_chain(module);
}

}  // namespace stoss::python
