#include "stoss/vibration/distribution.hpp"

#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "arrays.hpp"
#include "bindings.hpp"
#include "interpreter.hpp"
#include "quantities.hpp"
#include "stoss/vibration/quantities.hpp"

namespace stoss::python {
namespace {

using Means = py::array_t<MeanEnergy, py::array::c_style>;
using Doubles = py::array_t<double, py::array::c_style>;

Spectrum to_spectrum(const Means& array) { return {array.data(), array.data() + array.size()}; }

/// What the command and the package ask of an ensemble.
struct Asked {
  long samples;
  std::uint64_t seed;
  double error;
  int threads;

  [[nodiscard]] DistributionOptions options() const {
    return {.samples = samples, .seed = seed, .error = error, .threads = threads, .poll = signal_poll()};
  }
};

/// A mode that vibrates, with its frequency, c/R of the first body.
struct WarmMode {
  int body, order, index;
  double omega, energy;
};

std::vector<WarmMode> warm_modes(const RefinableContact& contact, double temperature, double highest,
                                 const Poll& poll) {
  std::vector<WarmMode> modes;
  Vibration named;
  for (const MeanEnergy& mode : thermal(contact, temperature, highest, poll)) {
    modes.push_back({mode.body, mode.order, mode.index, 0.0, mode.energy});
    named.push_back({mode.body, mode.order, mode.index});
  }
  int level = 0;
  while (!keeps(contact.at(level, poll), named)) ++level;
  const Contact& resolved = contact.at(level, poll);
  std::map<std::tuple<int, int, int>, double> omega;
  for (std::size_t g = 0; g < resolved.groups.size(); ++g) {
    const ModeGroup& group = resolved.groups[g];
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const int index = group.index.empty() ? static_cast<int>(l) : group.index[l];
      omega.emplace(std::tuple(g < resolved.first_groups ? 0 : 1, group.order, index), group.omega[l]);
    }
  }
  for (WarmMode& mode : modes) mode.omega = omega.at({mode.body, mode.order, mode.index});
  return modes;
}

/// Fills rows as the samples come, and `reasons` at the end, so that what is done is there if Ctrl-C ends them.
void distribution(const RefinableContact& contact, double speed, const Spectrum& spectrum, const Asked& asked,
                  py::array& rows, py::list reasons, const std::optional<py::function>& tick) {
  const Rows<Sample> layout(sample_quantities());
  const bool fits = rows.ndim() == 1 && (rows.flags() & py::array::c_style) != 0 && rows.dtype().equal(layout.type());
  if (!fits || rows.size() != asked.samples) throw std::invalid_argument("rows: one sample_row for each sample");
  auto* const row = static_cast<std::byte*>(rows.mutable_data());
  std::vector<std::string> why;
  const auto hand_over = [&] {
    for (const std::string& reason : why) reasons.append(reason);
  };
  const DistributionOptions options = asked.options();
  try {
    const Released released;
    restitution_distribution(contact, speed, spectrum, options, [&](const Sample& sample) {
      layout.write(sample, row + why.size() * layout.width());
      why.push_back(sample.reason);
      if (!tick) return;
      const py::gil_scoped_acquire interpreter;
      (*tick)();
    });
  } catch (const py::error_already_set&) {
    hand_over();
    throw;
  }
  hand_over();
}

py::dict summarize(const Doubles& restitution, const Doubles& error) {
  std::vector<Sample> samples(static_cast<std::size_t>(restitution.size()));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].restitution = samples[i].lost_fraction = {restitution.data()[i], error.data()[i]};
  }
  return to_dict(distribution_quantities(), summary(samples));
}

}  // namespace

void bind_distribution(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(MeanEnergy, body, order, index, energy);
  PYBIND11_NUMPY_DTYPE(WarmMode, body, order, index, omega, energy);
  module.attr("mean_energy") = py::dtype::of<MeanEnergy>();
  module.attr("sample_row") = Rows<Sample>(sample_quantities()).type();
  module.def(
      "warm_modes",
      [](const RefinableContact& contact, double temperature, double highest) {
        const Poll poll = signal_poll();
        std::vector<WarmMode> modes;
        {
          const Released released;
          modes = warm_modes(contact, temperature, highest, poll);
        }
        return take(std::move(modes));
      },
      py::arg("contact"), py::arg("temperature"), py::arg("highest"));
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
         int threads, py::array& rows, const py::list& reasons, const std::optional<py::function>& tick) {
        const Asked asked{static_cast<long>(rows.size()), seed, error, threads};
        distribution(contact, speed, to_spectrum(spectrum), asked, rows, reasons, tick);
      },
      py::arg("contact"), py::arg("speed"), py::arg("spectrum"), py::arg("seed"), py::arg("error"), py::arg("threads"),
      py::arg("rows").noconvert(), py::arg("reasons"), py::arg("tick"),
      "fills rows and reasons; calls tick, unless it is None, after each");
  module.def("summary", &summarize, py::arg("restitution"), py::arg("error"), "of samples, at least one with a value");
}

}  // namespace stoss::python
