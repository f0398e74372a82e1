// The options of the command follow from the table of inputs.
#include "input/inputs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "app.hpp"
#include "stoss/errors.hpp"

namespace stoss::cli {
namespace {

class Inputs : public testing::Test {
 protected:
  Inputs() { declare(app_, ""); }
  CLI::App app_;
};

TEST_F(Inputs, AreOptionsOfTheirSubcommands) {
  for (const auto& [question, name] : questions()) {
    const CLI::App* command = app_.get_subcommand(std::string(name));
    for (const Input& each : inputs()) {
      const CLI::Option* option = command->get_option_no_throw("--" + option_of(each.name));
      const Use* use = each.use(question);
      if (use == nullptr) continue;
      ASSERT_NE(option, nullptr) << name << " --" << option_of(each.name);
      EXPECT_EQ(option->get_description(), help_of(each, question)) << name;
      EXPECT_EQ(option->get_required(), use->needed) << name << " --" << option_of(each.name);
      EXPECT_NE(help_of(each, question).find(each.range), std::string::npos) << name << ' ' << each.name;
    }
  }
}

TEST_F(Inputs, AreTheOnlyOnesOfTheirNames) {
  for (const auto& [question, name] : questions()) {
    for (const CLI::Option* option : app_.get_subcommand(std::string(name))->get_options()) {
      for (const Input& each : inputs()) {
        if (option->get_name() != "--" + option_of(each.name)) continue;
        EXPECT_NO_THROW((void)input(question, each.name)) << name << ' ' << option->get_name();
      }
    }
  }
}

/// Numbers that are just out of the range of an input, or far where its unit may be another.
std::vector<std::string> refused_values(const Input& input, Form form) {
  const double far = input.dimension == Dimension::none ? 1.01 : 1e6;
  const auto text = [&](double value) {
    return form == Form::whole ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
  };
  std::vector<std::string> values{"nan", "x"};
  if (std::isfinite(input.low)) {
    const double out = input.low < 0.0 ? input.low * far : form == Form::whole ? input.low - 1.0 : input.low / 2.0;
    const double below = !input.low_included ? input.low : input.low == 0.0 ? -1.0 : out;
    values.push_back(form == Form::range ? fmt::format("{}:{}", below, below + 0.5) : text(below));
  }
  if (std::isfinite(input.high)) {
    const double out = form == Form::whole ? input.high + 1.0 : input.high * far;
    const double above = input.high_included ? out : input.high;
    values.push_back(form == Form::range ? fmt::format("0.5:{}", above) : text(above));
  }
  return values;
}

/// The options of a question, which takes all of them, but for the value of one.
std::map<std::string, std::string> options_with(const Input& input, Question question) {
  using enum Question;
  const bool in_si = question == predict || question == fit || question == calibrate || input.name == "height" ||
                     input.name == "adhesion";
  std::map<std::string, std::string> options{{"--poisson", "0.3"}};
  if (in_si) options = {{"--material", "glass"}, {"--radius", "0.001"}};
  options["--speed"] = question == table || question == fit ? "0.1:0.2" : "0.1";
  if (input.name == "height") options.erase("--speed");
  if (question == bounce && input.name != "gravity") options["--flight-time"] = "30";
  if (question == oblique) options["--friction"] = "0.1";
  if (question == distribution) options["--temperature"] = "0.1";
  if (question == fit) options["--law"] = "tsuji";
  if (question == calibrate) options["--unknown"] = "quality", options.erase("--speed");
  if (input.name == "ratio") options["--against"] = "same";
  return options;
}

TEST_F(Inputs, AreRefusedOutOfTheirRanges) {
  for (const auto& [question, name] : questions()) {
    for (const Input& each : inputs()) {
      const Use* use = each.use(question);
      if (use == nullptr) continue;
      for (const std::string& value : refused_values(each, use->form)) {
        auto options = options_with(each, question);
        options["--" + option_of(each.name)] = value;
        std::vector<std::string> words{std::string(name)};
        if (question == Question::calibrate) words.emplace_back("data.csv");
        const bool of_rule = each.name == "tolerance" || each.name == "friction";
        if (question == Question::table && of_rule) words.emplace_back("--oblique");
        if (question == Question::table && each.name == "adhesion") words.emplace_back("--predict");
        for (const auto& [option, its] : options) words.insert(words.end(), {option, its});
        std::reverse(words.begin(), words.end());
        CLI::App app;
        declare(app, "");
        try {
          app.parse(words);
          ADD_FAILURE() << name << ' ' << each.name << ' ' << value << " is not refused";
        } catch (const InvalidInput& error) {
          EXPECT_EQ(error.name(), each.name) << name << ' ' << value << ": " << error.what();
        }
      }
    }
  }
}

}  // namespace
}  // namespace stoss::cli
