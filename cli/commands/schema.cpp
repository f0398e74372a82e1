// stoss schema: the JSON Schema of who meets whom.
#include <memory>

#include "app.hpp"
#include "output/output_options.hpp"
#include "stoss/encounter/document.hpp"

namespace stoss::cli {

void add_schema(CLI::App& app) {
  auto* command = app.add_subcommand("schema", "JSON Schema of an encounter: who meets whom, as programs say it");
  auto arguments = std::make_shared<OutputOptions>();
  arguments->add_place_to(*command);
  command->footer("Examples:\n  stoss schema -o encounter.schema.json");
  command->callback([arguments] {
    Output output(arguments->path);
    output.write(encounter_schema() + "\n");
    output.close();
  });
}

}  // namespace stoss::cli
