// stoss materials: the named materials, with their sources.
#include "stoss/encounter/materials.hpp"

#include <fmt/format.h>

#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "app.hpp"
#include "output/output_options.hpp"
#include "stoss/encounter/relaxing.hpp"

namespace stoss::cli {
namespace {

struct MaterialsArguments {
  std::string name;
  OutputOptions output;
  CLI::App* command = nullptr;
};

/// For JSON: where the other constants are from, and within which factor 1 + u each is known.
nlohmann::ordered_json details_of(const NamedMaterial& of) {
  const Uncertainties& its = of.uncertainties;
  return {{"strength_source", of.strength_source},
          {"surface_source", of.surface_source},
          {"frequency[rad/s]", of.material.frequency},
          {"uncertainties",
           {{"young", its.young},
            {"poisson", its.poisson},
            {"density", its.density},
            {"loss", its.loss},
            {"yield_strength", its.yield_strength},
            {"surface_energy", its.surface_energy}}}};
}

/// Below the row of one material: what has no column.
std::string all_of(const NamedMaterial& its) {
  const auto line = [](std::string_view name, std::string_view text) {
    return text.empty() ? std::string() : fmt::format("{}: {}\n", name, text);
  };
  const Uncertainties& known = its.uncertainties;
  std::string text = "\n" + line("source", its.source) + line("yield strength", its.strength_source) +
                     line("surface energy", its.surface_source);
  const Material& of = its.material;
  const double hertz = of.frequency / (2.0 * std::numbers::pi);
  if (of.relaxation) {
    const std::complex<double> there = of.young * modulus(*of.relaxation, {0.0, of.frequency});
    text += fmt::format("at {:.6g} Hz: E' = {:.4g} Pa, E'' = {:.4g} Pa\n", hertz, there.real(), there.imag());
    text += fmt::format("relaxation from E(0) = {:.4g} Pa: {}\n", of.young, text_of(*of.relaxation));
  } else {
    text += fmt::format("frequency of the modulus: {:.6g} Hz\n", hertz);
  }
  text += "known within a factor of:";
  for (const auto& [name, uncertainty] :
       {std::pair{"young", known.young}, std::pair{"poisson", known.poisson}, std::pair{"density", known.density},
        std::pair{"loss", known.loss}, std::pair{"yield_strength", known.yield_strength},
        std::pair{"surface_energy", known.surface_energy}}) {
    if (uncertainty > 0.0) text += fmt::format(" {} {:g}", name, 1.0 + uncertainty);
  }
  return text + "\n";
}

void run(const MaterialsArguments& arguments) {
  std::vector<NamedMaterial> shown = named_materials();
  if (!arguments.name.empty()) shown = {material_of_the_list(arguments.name)};
  const Columns columns{{"name", "", 16},
                        {"young", "Pa", 10},
                        {"poisson", "", 8},
                        {"density", "kg/m^3", 8},
                        {"yield_strength", "Pa", 15},
                        {"quality", "", 8},
                        {"surface_energy", "J/m^2", 15},
                        {"relaxation", ""},
                        {"source", ""}};
  Writer writer = arguments.output.writer({"materials", command_line(), {}}, columns, Output::Use::whole);
  const auto known = [](const std::optional<double>& value) { return value ? Value(*value) : Value(std::string()); };
  const bool table = arguments.output.chosen_format() == Format::table;
  for (const NamedMaterial& each : shown) {
    const Material& its = each.material;
    // E(0) of a relaxation follows from its terms; a table has room for four digits of it.
    const double young = table ? std::stod(fmt::format("{:.4g}", its.young)) : its.young;
    writer.add({std::string(each.name), young, its.poisson, its.density, known(its.yield_strength), known(its.quality),
                known(its.surface_energy), its.relaxation ? text_of(*its.relaxation) : "", std::string(each.source)},
               details_of(each));
  }
  if (table) {
    writer.close_table(
        (arguments.name.empty() ? "" : all_of(shown.front())) +
        "\nquality: at all frequencies; nothing: not known well enough, or a relaxation,\nwhose young is E(0)\n" +
        (arguments.name.empty() ? "all of one: stoss materials NAME; all of all: --format json\n" : ""));
  }
  writer.finish();
}

}  // namespace

void add_materials(CLI::App& app) {
  auto& arguments = add_subcommand<MaterialsArguments>(
      app, "materials", "The materials that --material takes, with their sources", run,
      "Examples:\n  stoss materials\n  stoss materials PVB\n  stoss materials --format json");
  add(*arguments.command, "name", arguments.name, "One of them, with all that is known of it", "NAME", "Output");
  arguments.output.add_to(*arguments.command);
}

}  // namespace stoss::cli
