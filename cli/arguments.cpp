#include "arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "messages.hpp"
#include "numbers.hpp"
#include "options.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {
namespace {

std::string& stored_command_line() {
  static std::string line;
  return line;
}

}  // namespace

void OutputArguments::add_to(CLI::App& command) {
  command.add_option("--format", format, "Output format (default: table)")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->type_name("FORMAT")
      ->group("Output");
  add_place_to(command);
}

void OutputArguments::add_place_to(CLI::App& command) {
  command.add_option("-o,--output", path, "Write to FILE instead of stdout")->type_name("FILE")->group("Output");
  command.add_flag("--quiet", quiet, "No warnings and no progress on stderr")->group("Output");
}

Format OutputArguments::chosen_format() const {
  if (format == "csv") return Format::csv;
  return format == "json" ? Format::json : Format::table;
}

void OutputArguments::warn(const std::string& text) const {
  if (!quiet) say("stoss: warning: " + text);
}

void DiskArguments::add_to(CLI::App& command) {
  add_poisson_to(command)->required();
  add_material_to(command, round_material_group);
}

CLI::Option* DiskArguments::add_poisson_to(CLI::App& command) {
  return add_number(command, "--poisson", poisson,
                    "Poisson's ratio, -0.95 to 0.995 of a disk, to 0.4999 of a sphere; with\na material: of the solid")
      ->type_name("NU")
      ->group("Body");
}

void DiskArguments::add_material_to(CLI::App& command, const std::string& group) {
  add_number(command, "--young", young, "Young's modulus in Pa; makes speeds m/s and adds SI values")
      ->type_name("PA")
      ->group(group);
  add_number(command, "--density", density, "Density in kg/m^3")->type_name("RHO")->group(group);
  add_number(command, "--radius", radius, "Radius of the disk or the sphere in m")->type_name("M")->group(group);
  plane_option_ =
      command.add_option("--plane", plane, "Of a disk: thin (stress) or a long cylinder (strain); default: stress")
          ->check(CLI::IsMember({"stress", "strain"}))
          ->type_name("PLANE")
          ->group(group);
}

Plane DiskArguments::chosen_plane() const { return plane == "strain" ? Plane::strain : Plane::stress; }

Material DiskArguments::material() const { return {*young, poisson, *density}; }

std::optional<Scales> DiskArguments::si() const {
  const int given = (young ? 1 : 0) + (density ? 1 : 0) + (radius ? 1 : 0);
  if (given == 0 && !plane_given()) return std::nullopt;
  if (given != 3) {
    throw InvalidInput(fmt::format(
        "material: got {} of --young, --density, --radius, allowed all three or none (--plane needs all three)",
        given));
  }
  return scales(material(), chosen_plane(), *radius);
}

double DiskArguments::plane_poisson() const {
  return si() ? stoss::plane_poisson(material(), chosen_plane()) : poisson;
}

void DiskArguments::describe(nlohmann::ordered_json& inputs) const {
  inputs["poisson"] = plane_poisson();
  const auto units = si();
  if (!units) return;
  inputs["material_young[Pa]"] = *young;
  inputs["material_poisson"] = poisson;
  inputs["material_density[kg/m^3]"] = *density;
  inputs["radius[m]"] = *radius;
  inputs["plane"] = plane;
  inputs["c[m/s]"] = units->speed;
  inputs["R/c[s]"] = units->time;
}

std::vector<double> parse_speeds(const std::string& text, const std::optional<Scales>& si, const SpeedRange& range) {
  std::vector<double> speeds = parse_series("speed", text);
  const double unit = si ? si->speed : 1.0;
  for (double& speed : speeds) {
    const double slowest = range.slowest * unit, fastest = range.fastest * unit;
    if (!(speed >= slowest && speed <= fastest)) {
      throw InvalidInput(fmt::format("speed: got {}, allowed {} to {} {} ({})", speed, lower_end(slowest),
                                     upper_end(fastest), si ? "m/s" : "c", range.hint));
    }
    // The division may round beyond an end.
    speed = std::clamp(speed / unit, range.slowest, range.fastest);
  }
  return speeds;
}

std::string command_line() { return stored_command_line(); }

void set_command_line(int argc, char** argv) {
  std::string line = "stoss";
  for (int i = 1; i < argc; ++i) line += " " + shell_quoted(argv[i]);
  stored_command_line() = line;
}

}  // namespace stoss::cli
