#include "summary.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>

#include "common.hpp"
#include "stoss/version.hpp"

namespace bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

/// The processor's vector units, as far as inner loops have variants for them.
std::string vector_units() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
  if (__builtin_cpu_supports("x86-64-v4")) return "AVX-512";
  if (__builtin_cpu_supports("x86-64-v3")) return "AVX2";
#endif
  return "neither AVX2 nor AVX-512";
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::optional<double> find(const benchmark::UserCounters& counters, const char* name) {
  const auto found = counters.find(name);
  if (found == counters.end()) return std::nullopt;
  return found->second.value;
}

std::string cell(std::optional<double> value, int digits) {
  if (!value) return "–";
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << *value;
  return text.str();
}

std::string scientific(std::optional<double> value, int digits) {
  if (!value) return "–";
  std::ostringstream text;
  text << std::scientific << std::setprecision(digits) << *value;
  return text.str();
}

std::string percent(std::optional<double> share) { return share ? cell(100.0 * *share, 0) + " %" : "–"; }

constexpr const char* explanation_of_peak =
    "Of peak: steps × modes × points, over the multiply–adds that the machine can do in that time; as modes of one "
    "order "
    "share their sums over the points, 100 % is no limit.";

}  // namespace

void Summary::ReportRuns(const std::vector<Run>& reports) {
  std::vector<Run> medians;
  for (const Run& run : reports) {
    if (run.error_occurred) failed_ = true;
    const bool alone = run.run_type == Run::RT_Iteration && run.repetitions == 1;
    const bool median = run.run_type == Run::RT_Aggregate && run.aggregate_name == "median";
    if (!run.error_occurred && !alone && !median) continue;
    medians.push_back(run);
    if (run.error_occurred) continue;

    Row row;
    row.name = run.run_name.function_name;
    const bool wall_time = !run.run_name.time_type.empty();  // real or manual
    row.milliseconds = wall_time ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
    row.lost_fraction = find(run.counters, lost_fraction_counter);
    row.error = find(run.counters, error_counter);
    row.sphere = find(run.counters, sphere_counter).has_value();
    if (rows_.empty() && row.name == reference_name) row.ratio = 1.0;
    if (!rows_.empty() && rows_.front().name == reference_name && row.lost_fraction &&
        !find(run.counters, apart_counter)) {
      row.ratio = rows_.front().milliseconds / row.milliseconds;
    }
    const std::optional<double> at = find(run.counters, speed_counter);
    if (const std::optional<double> tolerance = find(run.counters, tolerance_counter); at && tolerance) {
      const std::array task{row.sphere ? 1.0 : 0.0, find(run.counters, obstacle_counter).value_or(0.0), *at,
                            *tolerance};
      if (find(run.counters, elements_counter)) elements_[task] = row.milliseconds;
      if (const auto found = elements_.find(task); found != elements_.end()) {
        row.to_elements = found->second / row.milliseconds;
        medians.back().counters[to_elements_counter] = *row.to_elements;
      }
    }
    row.tangential = find(run.counters, tangential_counter);
    if (find(run.counters, rival_counter)) rival_ = row.milliseconds;
    if (row.tangential && rival_ > 0.0) {
      row.ratio = find(run.counters, answers_counter).value_or(1.0) * rival_ / row.milliseconds;
    }
    if (const std::optional<double> work = find(run.counters, work_counter)) {
      const double rate = *work / row.milliseconds;
      if (find(run.counters, peak_counter)) peak_ = rate;
      if (peak_ > 0.0) row.of_peak = rate / peak_;
    }
    if (row.ratio) medians.back().counters[ratio_counter] = *row.ratio;
    rows_.push_back(row);
  }
  ConsoleReporter::ReportRuns(medians);
}

void Summary::write(std::ostream& out) const {
  out << processor() << ", one core, " << vector_units() << "; " << compiler() << ", " << STOSS_BUILD_TYPE << "; stoss "
      << stoss::version() << ".\n";
  const auto any = [this](const auto& is) { return std::any_of(rows_.begin(), rows_.end(), is); };
  if (any([](const Row& row) { return !row.sphere && !row.tangential; })) write_disks(out);
  if (any([](const Row& row) { return row.sphere; })) write_spheres(out);
  if (any([](const Row& row) { return row.tangential.has_value(); })) write_oblique(out);
}

void Summary::write_disks(std::ostream& out) const {
  out << "Disk, ν = " << poisson << ", v = " << speed
      << " c unless the row says otherwise. Time: processor time, median "
      << "(curves: wall time). Error: of 1−ε² against the converged value of the hard wall, " << converged_lost_fraction
      << ".\n"
      << "Ratio: time of the paper's protocol / time. To elements: time of finite elements, to the same tolerance at "
         "the "
      << "same speed, / time. " << explanation_of_peak << "\n\n"
      << "| benchmark | ms | 1−ε² | error | ratio | to elements | of peak |\n"
      << "|---|---:|---:|---:|---:|---:|---:|\n";
  for (const Row& row : rows_) {
    if (row.sphere || row.tangential) continue;
    out << "| " << row.name << " | " << cell(row.milliseconds, 3) << " | " << cell(row.lost_fraction, 5) << " | "
        << cell(row.error, 6) << " | " << cell(row.ratio, 2) << " | " << cell(row.to_elements, 2) << " | "
        << percent(row.of_peak) << " |\n";
  }
}

void Summary::write_spheres(std::ostream& out) const {
  out << "\nSphere, ν = " << poisson_of_sphere
      << ", default tolerances unless the row says otherwise. Error: relative, of 1−ε² against "
      << "tests/data/sphere_restitution.csv.\n"
      << "To elements: time of finite elements, to the same tolerance at the same speed, / time. "
      << explanation_of_peak << "\n\n"
      << "| benchmark | ms | 1−ε² | error | to elements | of peak |\n"
      << "|---|---:|---:|---:|---:|---:|\n";
  for (const Row& row : rows_) {
    if (!row.sphere) continue;
    std::optional<double> relative;
    if (row.error) relative = *row.error / *row.lost_fraction;
    out << "| " << row.name << " | " << cell(row.milliseconds, 2) << " | " << scientific(row.lost_fraction, 4) << " | "
        << scientific(relative, 0) << " | " << cell(row.to_elements, 2) << " | " << percent(row.of_peak) << " |\n";
  }
}

void Summary::write_oblique(std::ostream& out) const {
  out << "\nOblique impacts, disks of ν = " << poisson << " at a rigid wall, spheres of ν = " << poisson_of_sphere
      << ", x = s/μv. Error: of ε_t.\nRatio: time of the rival, which doubles all, for as many answers, / time.\n\n"
      << "| benchmark | ms | ε_t | error | ratio |\n"
      << "|---|---:|---:|---:|---:|\n";
  for (const Row& row : rows_) {
    if (!row.tangential) continue;
    out << "| " << row.name << " | " << cell(row.milliseconds, 2) << " | " << cell(row.tangential, 4) << " | "
        << cell(row.error, 4) << " | " << cell(row.ratio, 2) << " |\n";
  }
}

}  // namespace bench
