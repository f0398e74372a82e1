#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <iosfwd>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// The median of one benchmark's repetitions.
struct Row {
  std::string name;
  double milliseconds = 0.0;  ///< processor time
  std::optional<double> lost_fraction;
  std::optional<double> error;
  std::optional<double> ratio;        ///< the reference's time over this one's
  std::optional<double> to_elements;  ///< the time of finite elements for the same task over this one's
  bool sphere = false;
  std::optional<double> tangential;  ///< ε_t of an oblique impact, whose ratio is that to the last rival's
  std::optional<double> of_peak;     ///< work per time over the machine's peak
};

/// Prints the medians as they come, with the ratio of times as a counter, and keeps them.
class Summary final : public benchmark::ConsoleReporter {
 public:
  Summary() : benchmark::ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& reports) override;

  /// The rows as Markdown tables, of disks, of spheres and of oblique impacts, headed by a description of the machine
  /// and the build.
  void write(std::ostream& out) const;

  [[nodiscard]] bool failed() const { return failed_; }

 private:
  void write_disks(std::ostream& out) const;
  void write_spheres(std::ostream& out) const;
  void write_oblique(std::ostream& out) const;

  std::vector<Row> rows_;
  std::map<std::array<double, 4>, double> elements_;  // milliseconds, by shape, obstacle, speed and tolerance
  double rival_ = 0.0;                                // milliseconds
  double peak_ = 0.0;                                 // multiply–adds in a millisecond
  bool failed_ = false;
};

}  // namespace bench
