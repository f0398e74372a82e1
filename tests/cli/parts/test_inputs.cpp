// The options of the command follow from the table of inputs.
#include "input/inputs.hpp"

#include <gtest/gtest.h>

#include <string>

#include "app.hpp"

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

}  // namespace
}  // namespace stoss::cli
