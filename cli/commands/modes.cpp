// stoss modes: the eigenmodes of a disk or a sphere, solid or hollow.
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/bodies/disk/modes.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/sphere/modes.hpp"

namespace stoss::cli {
namespace {

struct ModesArguments {
  BodyOptions body;
  double cutoff = 30.0;
  OutputOptions output;
  CLI::App* command = nullptr;
};

double in_hertz(const Scales& si) { return si.frequency / (2.0 * std::numbers::pi); }

template <typename Mode>
void write(const ModesArguments& arguments, Output output, const Encounter& encounter,
           const Quantities<Mode>& quantities, const std::vector<Mode>& modes) {
  Provenance its = provenance(*arguments.command, encounter);
  its.inputs.erase("against");
  its.inputs["cutoff"] = arguments.cutoff;
  Units units = units_of(encounter);
  const auto si = std::exchange(units.si, std::nullopt);  // in SI, frequencies are in Hz
  const Shown number{.width = 13};
  const Fields<Mode> fields(quantities, units,
                            {{"order", {.width = 7}},
                             {"index", {.width = 7}},
                             {"omega", number},
                             {"radial", number},
                             {"tangential", number},
                             {"family", number}});
  Columns columns = fields.columns();
  if (si) columns.push_back({"frequency", "Hz", 13});
  Writer writer(std::move(output), arguments.output.chosen_format(), std::move(its), columns);
  for (const Mode& mode : modes) {
    Row row = fields.row(mode);
    if (si) row.emplace_back(mode.omega * in_hertz(*si));
    writer.add(row);
  }
  writer.finish();
}

void run(const ModesArguments& arguments) {
  const Encounter encounter{.first = arguments.body.body()};
  validate(encounter);
  const double poisson = *poisson_of(encounter);
  Output output(arguments.output.path, Output::Use::whole);
  catch_interrupts();
  const Poll poll = waiting(arguments.output, "modes");
  using bodies::sphere::hollow_modes;
  const Solid solid = first_solid(encounter);
  if (const auto* hollow = std::get_if<HollowSphere>(&solid)) {
    write(arguments, std::move(output), encounter, bodies::sphere::mode_quantities(),
          hollow_modes(poisson, hollow->inner, arguments.cutoff, poll));
  } else if (encounter.first.kind == "sphere") {
    using namespace bodies::sphere;
    write(arguments, std::move(output), encounter, mode_quantities(), modes(poisson, arguments.cutoff, poll));
  } else {
    using namespace bodies::disk;
    write(arguments, std::move(output), encounter, mode_quantities(), modes(poisson, arguments.cutoff, poll));
  }
}

}  // namespace

void add_modes(CLI::App& app) {
  auto& arguments = add_subcommand<ModesArguments>(
      app, "modes", "Eigenmodes of a free elastic disk or sphere, solid or hollow, with edge amplitudes", run,
      "Examples:\n"
      "  stoss modes --body disk --poisson 0.33 --cutoff 30 --format csv -o modes.csv\n"
      "  stoss modes --body sphere --poisson 0.3 --cutoff 12.5\n"
      "  stoss modes --body hollow-sphere --inner 0.9 --poisson 0.3 --cutoff 3");
  CLI::App& command = *arguments.command;
  arguments.body.add_kind_to(command, {"sphere", "hollow-sphere", "disk"});
  arguments.body.add_poisson_to(command);
  arguments.body.add_material_to(command);
  add(command, "--cutoff", arguments.cutoff,
      "Highest frequency in c/R, up to 1000, of a hollow sphere to 400 (default: 30)", "OMEGA", "Resolution");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
