#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <ostream>
#include <string>

#include "judgement.hpp"
#include "stoss/bodies/rod.hpp"
#include "text.hpp"
#include "times.hpp"

namespace validate {
namespace {

constexpr std::array tolerances{1e-2, 1e-3, 1e-4};
constexpr std::size_t by_default = 1;

using Answers = std::vector<Answer>;
using AllAnswers = std::array<Answers, tolerances.size()>;

std::string number(const char* format, double value) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string cell(const char* format, double value) {
  std::string text = " ";
  text += number(format, value);
  return text += " |";
}

double percent(int part, int all) { return 100.0 * part / all; }

void write_verdict(std::ostream& out, const std::string& what, const Tally& judged) {
  out << "\n1 − ε² of " << what << " at the tolerance " << number("%g", tolerances[by_default]) << ", " << judged.points
      << " points:\n"
      << number("%.1f %%", percent(judged.within, judged.points)) << " within the error, the greatest at"
      << number(" %.2f", judged.greatest) << " times the error,\nmedian of error / true error"
      << number(" %.1f", judged.padding) << ". The conditions are " << (honest(judged) ? "met.\n" : "**not met**.\n");
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

void write_tally(std::ostream& out, double tolerance, Quantity quantity, const Tally& tally) {
  out << "|" << cell("%g", tolerance) << " " << quantity_names[quantity] << " | " << tally.points << " |"
      << cell("%.1f %%", percent(tally.within, tally.points))
      << cell("%.1f %%", percent(tally.strictly_within, tally.points)) << cell("%.2f", tally.greatest)
      << (std::isfinite(tally.padding) ? cell("%.1f", tally.padding) : " – |") << " " << tally.blurred << " |\n";
}

void write_times(std::ostream& out) {
  out << text::speed;
  const std::vector<Times> all = measure_times({tolerances.begin(), tolerances.end()});
  for (std::size_t i = 0; i < tolerances.size(); ++i) write_time(out, tolerances[i], all[i]);
}

void write_tallies(std::ostream& out, const std::vector<Point>& points, const AllAnswers& answers) {
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    for (std::size_t quantity = 0; quantity < quantities; ++quantity) {
      const auto which = static_cast<Quantity>(quantity);
      write_tally(out, tolerances[i], which, tally(points, answers[i], which));
    }
  }
}

void write_point(std::ostream& out, const Point& point, const Answer& answer) {
  const stoss::Estimate& reference = *point.reference[lost_fraction];
  const stoss::Estimate& value = answer.value[lost_fraction];
  const Deviation off = deviation(value, reference);
  out << "|" << cell("%g", point.poisson);
  if (point.against) {
    out << cell("%g", point.against->poisson) << cell("%g", point.against->radius) << cell("%g", point.against->young)
        << cell("%g", point.against->density);
  }
  out << cell("%.4g", point.speed) << cell("%.8f", reference.value) << cell("%.1e", reference.error)
      << cell("%.8f", value.value) << cell("%.1e", value.error) << cell(off.padding ? "%.2f" : "%.2f u", off.ratio)
      << cell("%.0f", answer.cutoff) << "\n";
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
  const stoss::Restitution rod = best(stoss::RefinableContact(stoss::rod()), 0.1, tolerances[by_default]);
  const stoss::Estimate& value = rod.restitution;
  const stoss::Estimate& time = rod.contact_time;
  const bool contained = std::abs(value.value - 1.0) <= value.error;
  out << text::rod << "|" << cell("%.0f", rod.finest.cutoff) << cell("%.6f", value.value) << cell("%.1e", value.error)
      << cell("%.6f", time.value) << cell("%.1e", time.error) << "\n\nIt does" << (contained ? ".\n" : " **not**.\n");
  return contained;
}

void write_points(std::ostream& out, const std::vector<Point>& points, const Answers& answers) {
  for (std::size_t i = 0; i < points.size(); ++i) write_point(out, points[i], answers[i]);
}

AllAnswers answer_all(const char* what, const std::vector<Point>& points) {
  const Contacts contacts = make_contacts(points);
  AllAnswers answers;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    std::cerr << points.size() << ' ' << what << ", tolerance " << tolerances[i] << '\n';
    answers[i] = answer(contacts, points, tolerances[i]);
  }
  return answers;
}

}  // namespace

bool write_report(std::ostream& out) {
  const std::vector<Point> points = read_points(), pairs = read_pairs();
  const AllAnswers answers = answer_all("points at the wall", points), of_pairs = answer_all("pairs", pairs);
  const Tally judged = tally(points, answers[by_default], lost_fraction);
  const Tally pairs_judged = tally(pairs, of_pairs[by_default], lost_fraction);
  out << text::introduction << "\n## Result\n";
  write_verdict(out, "disks at a hard wall", judged);
  write_verdict(out, "pairs of unequal disks", pairs_judged);
  std::cerr << "processor time\n";
  write_times(out);
  out << text::tally;
  write_tallies(out, points, answers);
  out << text::pair_tally;
  write_tallies(out, pairs, of_pairs);
  write_finite_elements(out, points, answers[by_default]);
  const bool rod = write_rod(out);
  out << text::points;
  write_points(out, points, answers[by_default]);
  out << text::pairs;
  write_points(out, pairs, of_pairs[by_default]);
  return honest(judged) && honest(pairs_judged) && rod;
}

}  // namespace validate
