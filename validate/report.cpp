#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iostream>
#include <ostream>
#include <string>

#include "introduction.hpp"
#include "judgement.hpp"
#include "modal_report.hpp"
#include "oblique_report.hpp"
#include "plate_report.hpp"
#include "sets.hpp"
#include "stoss/bodies/rod.hpp"
#include "tally_rows.hpp"
#include "text.hpp"
#include "times.hpp"

namespace validate {
namespace {

constexpr std::array tolerances{1e-2, 1e-3, 1e-4};
constexpr std::size_t by_default = 1;

using Answers = std::vector<Answer>;
using AllAnswers = std::array<Answers, tolerances.size()>;

double percent(int part, int all) { return 100.0 * part / all; }

std::string shown(double tolerance) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", tolerance);
  return text.data();
}

/// The points of a set, and what restitution() said of them at each tolerance.
struct Judged {
  Set set;
  std::vector<Point> points;
  AllAnswers answers;
};

void write_verdict(std::ostream& out, const Judged& judged, std::size_t at) {
  const Tally all = tally(judged.points, judged.answers[at], lost_fraction);
  const auto converged = std::count_if(judged.answers[at].begin(), judged.answers[at].end(),
                                       [](const Answer& answer) { return answer.converged; });
  out << "|" << cell("%g", tolerances[at]) << " " << judged.set.name << " | " << converged << " of "
      << judged.points.size() << " |" << cell("%.1f %%", percent(all.within, all.points)) << cell("%.2f", all.greatest)
      << cell("%.1f", all.padding) << (honest(all) ? " met |" : " **not met** |") << "\n";
}

void write_time(std::ostream& out, double tolerance, const Times& times) {
  std::vector<double> seconds, cutoffs;
  for (const Time& time : times) {
    seconds.push_back(time.seconds);
    cutoffs.push_back(time.cutoff);
  }
  const auto converged = std::count_if(times.begin(), times.end(), [](const Time& time) { return time.converged; });
  const auto longest =
      std::max_element(times.begin(), times.end(), [](const Time& a, const Time& b) { return a.seconds < b.seconds; });
  out << "|" << cell("%g", tolerance) << " " << converged << " of " << times.size() << " |"
      << cell("%.0f", median(cutoffs)) << cell("%.1f", 1e3 * median(seconds))
      << cell("%.0f", 1e3 * quantile(seconds, 0.99)) << cell("%.0f", 1e3 * longest->seconds)
      << cell("%.3f", longest->poisson) << cell("%.2g", longest->speed) << cell("%.0f", longest->cutoff) << "\n";
}

void write_times(std::ostream& out) {
  out << text::speed;
  const std::vector<Times> all = measure_times({tolerances.begin(), tolerances.end()});
  for (std::size_t i = 0; i < tolerances.size(); ++i) write_time(out, tolerances[i], all[i]);
}

void write_tallies(std::ostream& out, const Judged& judged) {
  out << judged.set.tally;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    for (std::size_t quantity = 0; quantity < quantities; ++quantity) {
      const Tally all = tally(judged.points, judged.answers[i], static_cast<Quantity>(quantity));
      write_tally(out, shown(tolerances[i]).c_str(), quantity_names[quantity], all);
    }
  }
}

void write_points(std::ostream& out, const Judged& judged) {
  out << judged.set.points;
  judged.set.write_points(out, judged.points, judged.answers[by_default]);
}

void write_finite_element_point(std::ostream& out, const Point& point, const Answer& answer) {
  const stoss::Estimate& value = answer.value[restitution_coefficient];
  const stoss::Estimate& reference = *point.finite_elements;
  out << "|" << cell("%g", point.poisson) << cell("%g", point.speed) << cell("%.5f", reference.value)
      << cell("%.0e", reference.error) << cell("%.6f", value.value) << cell("%.1e", value.error)
      << cell("%.1e", std::abs(value.value - reference.value)) << "\n";
}

void write_finite_elements(std::ostream& out, const std::vector<Point>& points, const Answers& answers) {
  out << text::finite_elements;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].finite_elements) write_finite_element_point(out, points[i], answers[i]);
  }
}

/// Whether the exact value 1 is within the error.
bool write_rod(std::ostream& out) {
  const stoss::Restitution rod =
      best(stoss::RefinableContact(stoss::rod()), 0.1, {.tolerance = tolerances[by_default], .absolute = 0.0});
  const stoss::Estimate& value = rod.restitution;
  const stoss::Estimate& time = rod.contact_time;
  const bool contained = std::abs(value.value - 1.0) <= value.error;
  out << text::rod << "|" << cell("%.0f", rod.finest.cutoff) << cell("%.6f", value.value) << cell("%.1e", value.error)
      << cell("%.6f", time.value) << cell("%.1e", time.error) << "\n\nIt does" << (contained ? ".\n" : " **not**.\n");
  return contained;
}

Judged judge(const Set& set) {
  Judged judged{set, set.read(), {}};
  const Contacts contacts = make_contacts(judged.points);
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    std::cerr << set.name << ", tolerance " << tolerances[i] << '\n';
    judged.answers[i] = answer(contacts, judged.points, tolerances[i]);
  }
  return judged;
}

/// Whether the errors of all are honest.
bool write_verdicts(std::ostream& out, const std::vector<Judged>& all) {
  out << text::verdict;
  bool all_honest = true;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    for (const Judged& judged : all) {
      write_verdict(out, judged, i);
      all_honest = all_honest && honest(tally(judged.points, judged.answers[i], lost_fraction));
    }
  }
  return all_honest;
}

}  // namespace

bool write_set(std::ostream& out, const Set& set) {
  const std::vector<Judged> alone{judge(set)};
  const bool is_honest = write_verdicts(out, alone);
  write_tallies(out, alone.front());
  write_points(out, alone.front());
  return is_honest;
}

bool write_report(std::ostream& out) {
  std::vector<Judged> all;
  for (const Set& set : sets()) all.push_back(judge(set));
  const Judged& wall = all.front();
  const JudgedOblique oblique = judge_oblique();
  const JudgedPlates plates = judge_plates();
  out << text::introduction;
  bool all_honest = write_verdicts(out, all);
  std::cerr << "processor time\n";
  write_times(out);
  write_oblique_times(out, oblique);
  write_plate_times(out, plates);
  for (const Judged& judged : all) write_tallies(out, judged);
  write_finite_elements(out, wall.points, wall.answers[by_default]);
  const bool rod = write_rod(out);
  all_honest = write_oblique(out, oblique) && all_honest;
  all_honest = write_plates(out, plates) && all_honest;
  all_honest = write_modal(out) && all_honest;
  for (const Judged& judged : all) write_points(out, judged);
  return all_honest && rod;
}

}  // namespace validate
