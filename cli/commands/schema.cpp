// stoss schema: the JSON Schema of who meets whom.
#include "stoss/encounter/schema.hpp"
#include "app.hpp"
#include "output/output_options.hpp"

namespace stoss::cli {
namespace {

struct SchemaArguments {
  OutputOptions output;
  CLI::App* command = nullptr;
};

void run(const SchemaArguments& arguments) {
  Output output(arguments.output.path);
  output.write(encounter_schema() + "\n");
  output.close();
}

}  // namespace

void add_schema(CLI::App& app) {
  auto& arguments =
      add_subcommand<SchemaArguments>(app, "schema", "JSON Schema of an encounter: who meets whom, as programs say it",
                                      run, "Examples:\n  stoss schema -o encounter.schema.json");
  arguments.output.add_place_to(*arguments.command);
}

}  // namespace stoss::cli
