// stoss predict: what a drop test of a real ball shows, channel by channel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app.hpp"
#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "output/output_options.hpp"
#include "process/process.hpp"
#include "stoss/encounter/series.hpp"
#include "stoss/encounter/visible.hpp"
#include "stoss/errors.hpp"
#include "stoss/prediction/prediction.hpp"
#include "stoss/prediction/quantities.hpp"

namespace stoss::cli {
namespace {

struct PredictArguments {
  EncounterOptions who;
  ApproachOptions approach;
  std::optional<double> adhesion;
  std::vector<std::string> uncertainties;
  double tolerance = 1e-3;
  int threads = 0;
  bool quick = false;  // one number a speed
  OutputOptions output;
  CLI::App* command = nullptr;
};

PredictionOptions options_of(const PredictArguments& arguments) {
  PredictionOptions options{.work_of_adhesion = arguments.adhesion,
                            .tolerance = arguments.tolerance,
                            .threads = arguments.threads,
                            .poll = waiting(arguments.output, "predicts")};
  for (const std::string& each : arguments.uncertainties) {
    const std::size_t sign = each.find('=');
    if (sign == std::string::npos) {
      throw InvalidInput::out_of_range("uncertainty", fmt::format("'{}'", shortened(each)), "NAME=U, as in young=0.05");
    }
    const std::string name = each.substr(0, sign);
    const double its = parse_number("uncertainty " + name, each.substr(sign + 1));
    if (!options.uncertainties.emplace(name, its).second) {
      throw InvalidInput::conflict(fmt::format("uncertainty {}", shortened(name)), "given twice, allowed once");
    }
  }
  return options;
}

Provenance describe(const PredictArguments& arguments, const Encounter& encounter) {
  Provenance its = provenance(*arguments.command, encounter);
  if (!arguments.uncertainties.empty()) its.inputs["uncertainty"] = arguments.uncertainties;
  return its;
}

nlohmann::ordered_json details_of(const Prediction& prediction) {
  nlohmann::ordered_json details{{"influences", nlohmann::ordered_json::array()}, {"warnings", prediction.warnings}};
  for (const auto& [constant, uncertainty, change] : prediction.influences) {
    details["influences"].push_back({{"constant", constant}, {"uncertainty", uncertainty}, {"change", change}});
  }
  return details;
}

/// Below the rows, so that both parts fit a terminal: what each channel takes of the energy.
std::string channels_of(const std::vector<Prediction>& all) {
  std::string text = fmt::format("\n{:>10}", "speed");
  for (const std::string_view name : channel_names) text += fmt::format("{:>12}", name);
  text += fmt::format("\n{:>10}", "m/s");
  for (std::size_t i = 0; i < channel_names.size(); ++i) {
    text += fmt::format("{:>12}", is_model(static_cast<Channel>(i)) ? "modelled" : "computed");
  }
  for (const Prediction& each : all) {
    text += fmt::format("\n{:>10.6g}", each.speed);
    for (const double share : each.shares) {
      text += std::isfinite(share) ? fmt::format("{:>12.4g}", share) : fmt::format("{:>12}", "-");
    }
  }
  return text + "\n";
}

/// Below them: by how much the constants that matter most move the slowest and the fastest.
std::string influences_of(const std::vector<Prediction>& all) {
  constexpr std::size_t most = 5;
  std::string text;
  std::vector<const Prediction*> told{&all.front()};
  if (all.size() > 1) told.push_back(&all.back());
  for (const Prediction* each : told) {
    if (each->influences.empty()) continue;
    text += fmt::format("\nconstants, at {:.4g} m/s, by what eps changes:\n", each->speed);
    for (std::size_t i = 0; i < std::min(most, each->influences.size()); ++i) {
      const Influence& its = each->influences[i];
      text += fmt::format("  {:<24} times {:<5.3g} {:+.2g}\n", its.constant, 1.0 + its.uncertainty, its.change);
    }
  }
  return text;
}

/// ε with its spread: the sum of all three uncertainties and of what rounding does, to two digits.
std::string number_of(const Prediction& its) {
  const double spread = its.restitution.error + its.by_models + its.by_constants;
  if (!std::isfinite(its.restitution.value) || !std::isfinite(spread)) return "nan\n";
  const int digits = spread > 0.0 ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(spread)))) : 9;
  const double up = std::ceil(spread * std::pow(10.0, digits) + 0.5) / std::pow(10.0, digits);
  return fmt::format("{:.{}f} +- {:.{}f}\n", its.restitution.value, digits, up, digits);
}

void write(const PredictArguments& arguments, const Encounter& encounter, const std::vector<Prediction>& all,
           Output output) {
  if (arguments.quick) {
    for (const Prediction& each : all) output.write(number_of(each));
    return output.close();
  }
  const Units units{.own = UnitSystem::sphere_si, .in_si = UnitSystem::sphere_si};
  const Fields<Prediction> fields(prediction_quantities(), units,
                                  {{"speed", {.width = 10}},
                                   {"restitution", {.width = 22, .with_error = true}},
                                   {"by_models", {.width = 12}},
                                   {"by_constants", {.width = 14}},
                                   {"rebound_height", {.width = 16}}});
  Writer writer(std::move(output), arguments.output.chosen_format(), describe(arguments, encounter), fields.columns());
  for (const Prediction& each : all) writer.add(fields.row(each), details_of(each));
  if (arguments.output.chosen_format() == Format::table) writer.close_table(channels_of(all) + influences_of(all));
  writer.finish();
}

void run(const PredictArguments& arguments) {
  if (arguments.quick && given(*arguments.command, "--format")) {
    throw InvalidInput::out_of_range("quick", "--quick with --format", "only without");
  }
  const Encounter encounter = arguments.who.encounter();
  std::vector<double> speeds = arguments.approach.series(units_of(encounter));
  for (double& each : speeds) each *= speed_unit(encounter);
  Output output(arguments.output.path);
  catch_interrupts();
  const std::vector<Prediction> all = predict(encounter, speeds, options_of(arguments));
  write(arguments, encounter, all, std::move(output));
  std::set<std::string> warned;
  for (const Prediction& each : all) warned.insert(each.warnings.begin(), each.warnings.end());
  for (const std::string& each : warned) arguments.output.warn(each);
  const auto unknown = std::count_if(all.begin(), all.end(), [](const Prediction& each) {
    return !std::isfinite(each.restitution.value) || !std::isfinite(each.restitution.error);
  });
  if (unknown == 0) return;
  arguments.output.warn(fmt::format("{} of {} values not computed, or without an error", unknown, all.size()));
  throw NotAsAsked{};
}

}  // namespace

void add_predict(CLI::App& app) {
  auto& arguments = add_subcommand<PredictArguments>(
      app, "predict", "Predict the rebound of a real ball: computed elastic losses plus models of yield and adhesion",
      run,
      "Examples:\n"
      "  stoss predict --body sphere --material 'bearing steel' --radius 0.005 --speed 0.01,0.1,1\n"
      "      --against half-space,material=glass\n"
      "  stoss predict --body sphere --material glass --radius 0.002 --against same --speed 0.5 --quick\n"
      "  stoss predict --body sphere --material glass --radius 0.002 --height 0.1,0.5\n"
      "      --against plate,material=glass,thickness=0.01\n"
      "  stoss predict --body sphere --material ice --radius 1e-6 --speed log:0.1:10:5 --against same\n"
      "      --adhesion 0.2 --uncertainty against.loss=2");
  CLI::App& command = *arguments.command;
  arguments.who.first.add_poisson_to(command);
  arguments.approach.add_to(command, Question::predict, "Motion");
  arguments.who.add_to(command);
  const char* const models = "Models";
  add_input(command, Question::predict, "adhesion", arguments.adhesion, models);
  add(command, "--uncertainty", arguments.uncertainties,
      "A constant that is known within a factor of 1 + U, as in young=0.05 or\n"
      "against.yield_strength=0.2; as often as needed (default: those of\nnamed materials)",
      "NAME=U", models);
  add_input(command, Question::predict, "tolerance", arguments.tolerance, "Resolution");
  add_threads(command, arguments.threads);
  command.add_flag("--quick", arguments.quick, "Only one line a speed: eps +- the sum of its three uncertainties")
      ->group("Output");
  arguments.output.add_to(command);
}

}  // namespace stoss::cli
