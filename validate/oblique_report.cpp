#include "oblique_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iostream>
#include <ostream>
#include <string>

#include "judgement.hpp"
#include "oblique_text.hpp"

namespace validate {
namespace {

constexpr std::size_t at_points = 1;  // the tolerance of the table of all points

double processor_time() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

ObliqueAnswer answer_to(const ObliqueCase& its, const stoss::RefinableContact& contact, double tolerance) {
  const std::vector one{its.before};
  (void)stoss::oblique_restitution(contact, its.speed, one, {.tolerance = tolerance});  // makes the modes
  const double begin = processor_time();
  const stoss::ObliqueRestitution result =
      stoss::oblique_restitution(contact, its.speed, one, {.tolerance = tolerance}).front();
  return {result.restitution, result.sliding_after, result.converged,
          result.runs.empty() ? 0.0 : result.runs.back().cutoff * stoss::time_scale(contact.at(0)),
          processor_time() - begin};
}

std::string number(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string cell(const char* format, double value) { return ' ' + number(format, value) + " |"; }

double percent(int part, int all) { return 100.0 * part / all; }

/// The points of one kind of body, or all.
struct Share {
  const char* name;
  const char* body;  // null: all
};
constexpr std::array shares{Share{"all", nullptr}, Share{"disks", "disk"}, Share{"spheres", "sphere"}};

using Values = stoss::Estimate ObliqueAnswer::*;
using References = stoss::Estimate ObliquePoint::*;

bool is_of(const ObliquePoint& point, const Share& share) {
  return share.body == nullptr || point.its.body == share.body;
}

Tally tally_of(const JudgedOblique& judged, std::size_t at, const Share& share, Values value, References reference) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < judged.points.size(); ++i) {
    if (is_of(judged.points[i], share)) all.push_back({judged.answers[at][i].*value, judged.points[i].*reference});
  }
  return tally(all);
}

/// @return whether the errors are what is promised: not padded only with s′ at the first tolerance
bool write_tally(std::ostream& out, const JudgedOblique& judged, std::size_t at, const Share& share, bool along) {
  Tally all = along ? tally_of(judged, at, share, &ObliqueAnswer::sliding_after, &ObliquePoint::sliding_after)
                    : tally_of(judged, at, share, &ObliqueAnswer::restitution, &ObliquePoint::restitution);
  out << "|" << cell("%g", judged.tolerances[at]) << ' ' << share.name << (along ? " | s′ | " : " | ε | ") << all.points
      << " |" << cell("%.1f %%", percent(all.within, all.points))
      << cell("%.1f %%", percent(all.strictly_within, all.points)) << cell("%.2f", all.greatest)
      << (std::isfinite(all.padding) ? cell("%.1f", all.padding) : " – |") << ' ' << all.blurred << " |\n";
  if (!along || at > 0) all.padding = 0.0;
  return share.body != nullptr || honest(all);
}

void write_times_of(std::ostream& out, const JudgedOblique& judged, std::size_t at, const Share& share) {
  std::vector<double> seconds, cutoffs;
  int converged = 0;
  for (std::size_t i = 0; i < judged.points.size(); ++i) {
    if (!is_of(judged.points[i], share)) continue;
    const ObliqueAnswer& answer = judged.answers[at][i];
    seconds.push_back(1e3 * answer.seconds);
    cutoffs.push_back(answer.cutoff);
    converged += answer.converged ? 1 : 0;
  }
  out << "|" << cell("%g", judged.tolerances[at]) << ' ' << share.name << " | " << converged << " of " << seconds.size()
      << " |" << cell("%.0f", median(cutoffs)) << cell("%.0f", median(seconds)) << cell("%.0f", quantile(seconds, 0.9))
      << cell("%.0f", quantile(seconds, 1.0)) << '\n';
}

void write_point(std::ostream& out, const ObliquePoint& point, const ObliqueAnswer& answer) {
  const ObliqueCase& its = point.its;
  const double unit = std::max(std::abs(its.sliding()), its.before.friction * its.speed);
  const Deviation along = deviation(answer.sliding_after, point.sliding_after),
                  normal = deviation(answer.restitution, point.restitution);
  out << "| " << its.body << (its.loss_time > 0.0 ? ", lossy" : "") << " | " << its.against << " |"
      << cell("%g", its.poisson) << cell("%.3g", its.speed) << cell("%.3g", its.before.friction)
      << cell(its.before.spin != 0.0 ? "%.3g Ω" : "%.3g", its.sliding() / (its.before.friction * its.speed))
      << cell("%.5f", -point.sliding_after.value / its.sliding()) << cell("%.0e", point.sliding_after.error / unit)
      << cell("%.5f", -answer.sliding_after.value / its.sliding()) << cell("%.1e", answer.sliding_after.error / unit)
      << cell(along.padding ? "%.2f" : "%.2f u", along.ratio) << cell("%.6f", point.restitution.value)
      << cell("%.6f", answer.restitution.value) << cell("%.1e", answer.restitution.error)
      << cell(normal.padding ? "%.2f" : "%.2f u", normal.ratio) << cell("%.0f", answer.cutoff) << '\n';
}

}  // namespace

JudgedOblique judge_oblique() {
  JudgedOblique judged{read_oblique(), {1e-2, 1e-3}, {}};
  judged.answers.resize(judged.tolerances.size());
  for (const ObliquePoint& point : judged.points) {
    const stoss::RefinableContact contact = contact_of(point.its);
    for (std::size_t k = 0; k < judged.tolerances.size(); ++k) {
      judged.answers[k].push_back(answer_to(point.its, contact, judged.tolerances[k]));
    }
    std::cerr << "\roblique " << judged.answers[0].size() << " of " << judged.points.size() << std::flush;
  }
  std::cerr << '\n';
  return judged;
}

void write_oblique_times(std::ostream& out, const JudgedOblique& judged) {
  out << text::oblique_times;
  for (std::size_t at = 0; at < judged.tolerances.size(); ++at) {
    for (const Share& share : shares) write_times_of(out, judged, at, share);
  }
}

bool write_oblique(std::ostream& out, const JudgedOblique& judged) {
  out << text::oblique_tally;
  bool all_honest = true;
  for (std::size_t at = 0; at < judged.tolerances.size(); ++at) {
    for (const Share& share : shares) {
      for (const bool along : {true, false}) all_honest = write_tally(out, judged, at, share, along) && all_honest;
    }
  }
  out << "\nThe conditions are" << (all_honest ? " met.\n" : " **not met**.\n") << text::oblique_points;
  for (std::size_t i = 0; i < judged.points.size(); ++i) {
    write_point(out, judged.points[i], judged.answers[at_points][i]);
  }
  return all_honest;
}

}  // namespace validate
