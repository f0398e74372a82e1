// Words of the command that say who meets whom, how fast and how they vibrate, one a line.
#include <CLI/CLI.hpp>
#include <vector>

#include "input/encounter.hpp"
#include "input/inputs.hpp"
#include "oracle.hpp"
#include "process/process.hpp"
#include "stoss/encounter/document.hpp"

using namespace stoss;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::text_of(data, size));
  if (text.find('@') != std::string::npos || text.find('\0') != std::string::npos) return 0;  // files; no argument
  std::vector<std::string> words = cli::split(text, '\n');
  std::string speed = words.back();
  words.pop_back();
  std::reverse(words.begin(), words.end());  // as CLI11 takes them
  CLI::App app;
  cli::EncounterOptions who;
  std::vector<std::string> modes;
  who.first.add_poisson_to(app);
  who.add_to(app);
  cli::add_modes_to(app, modes);
  (void)fuzz::reads([&] {
    try {
      app.parse(words);
      const Encounter encounter = who.encounter();
      fuzz::hold(to_json(encounter_from_json(to_json(encounter))) == to_json(encounter), "written as it was read");
      (void)cli::vibration_of(modes);
      (void)cli::series_of(input(Question::restitution, "speed"), speed, cli::units_of(encounter));
    } catch (const CLI::Error&) {  // of usage
    } catch (const InvalidInput& error) {
      throw InvalidInput::conflict("command", visible(error.what()));  // as the command says it
    }
  });
  return 0;
}
