#include "row_output.hpp"

#include <fmt/format.h>

#include <utility>

#include "interrupt.hpp"
#include "resume.hpp"
#include "stoss/errors.hpp"
#include "text.hpp"

namespace stoss::cli {

void RowOutput::add_to(CLI::App& to) {
  command = &to;
  output.add_to(to);
  to.add_option("--resume", resume,
                "Continue an interrupted run: keep the rows of the CSV file FILE,\n"
                "add the missing ones; without FILE begin it")
      ->type_name("FILE")
      ->group("Output");
}

void RowOutput::redirect() {
  const auto given = [this](const std::string& option) { return command->get_option(option)->count() > 0; };
  if (!given("--resume")) return;
  if (resume == "-") throw InvalidInput("resume: got '-', allowed the name of a file");
  if (given("--format") && output.format != "csv") {
    throw InvalidInput(fmt::format("resume: got --format {}, allowed csv (which --resume implies)", output.format));
  }
  if (given("--output") && !same_output(output.path, resume)) {
    throw InvalidInput(
        fmt::format("resume: got another file as --output, allowed '{}' (all rows go there)", shortened(resume)));
  }
  output.format = "csv";
  output.path = resume;
}

Report RowOutput::open(const Provenance& provenance, Sweep& sweep) const {
  if (resume.empty()) return {Output(output.path, Output::Use::rows), output.chosen_format(), provenance};
  Output file(resume, Output::Use::resume);  // locked from before the first row is read
  const Earlier earlier =
      read_earlier(file, provenance, sweep.columns(),
                   [&sweep](std::size_t, const std::vector<std::string>& cells) { sweep.take(cells); });
  if (earlier.size > 0) return {std::move(file), earlier.size};
  return {std::move(file), Format::csv, provenance};
}

void RowOutput::write(const Provenance& provenance, Sweep& sweep, const std::function<void(Report&)>& compute) const {
  catch_interrupts();
  Report report = open(provenance, sweep);
  report.finish_after([&] { compute(report); });
}

}  // namespace stoss::cli
