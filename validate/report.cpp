#include "report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <ostream>
#include <string>

#include "introduction.hpp"
#include "judgement.hpp"
#include "modal_report.hpp"
#include "oblique_report.hpp"
#include "plate_report.hpp"
#include "relaxing_report.hpp"
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

/// Points, and what restitution() said of them at each tolerance.
struct Judged {
  const char* what;
  std::vector<Point> points;
  AllAnswers answers;
};

void write_verdict(std::ostream& out, const Judged& judged, std::size_t at) {
  const Tally all = tally(judged.points, judged.answers[at], lost_fraction);
  const auto converged = std::count_if(judged.answers[at].begin(), judged.answers[at].end(),
                                       [](const Answer& answer) { return answer.converged; });
  out << "|" << cell("%g", tolerances[at]) << " " << judged.what << " | " << converged << " of " << judged.points.size()
      << " |" << cell("%.1f %%", percent(all.within, all.points)) << cell("%.2f", all.greatest)
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
  out << "|";
  if (point.half_space) out << (point.rigid ? " rigid" : "") << (point.sphere ? " sphere |" : " disk |");
  if (point.loss_time > 0.0) out << (point.sphere ? " sphere |" : " disk |") << cell("%g", point.loss_time);
  if (point.temperature > 0.0) out << (point.sphere ? " sphere |" : " disk |");
  out << cell("%g", point.poisson);
  if (point.loss_time > 0.0) {
    if (point.against) {
      out << cell("%g", point.against->loss_time) << cell("%g", point.against->poisson)
          << cell("%g", point.against->radius);
    } else {
      out << " | | |";
    }
  } else if (point.half_space) {
    out << cell("%g", point.against->poisson) << cell("%g", point.against->young) << cell("%g", point.against->density);
  } else if (point.temperature > 0.0) {
    if (point.against) {
      out << cell("%g", point.against->poisson) << cell("%g", point.against->radius)
          << cell("%g", point.against->young);
    } else {
      out << " | | |";
    }
  } else if (point.against) {
    out << cell("%g", point.against->poisson) << cell("%g", point.against->radius) << cell("%g", point.against->young)
        << cell("%g", point.against->density);
  }
  out << cell("%.4g", point.speed);
  if (point.temperature > 0.0) out << cell("%g", point.temperature) << cell("%g", point.highest);
  out << cell("%.8f", reference.value) << cell("%.1e", reference.error) << cell("%.8f", value.value)
      << cell("%.1e", value.error) << cell(off.padding ? "%.2f" : "%.2f u", off.ratio) << cell("%.0f", answer.cutoff)
      << "\n";
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

void write_points(std::ostream& out, const std::vector<Point>& points, const Answers& answers) {
  for (std::size_t i = 0; i < points.size(); ++i) write_point(out, points[i], answers[i]);
}

Judged judge(const char* what, const std::vector<Point>& points) {
  const Contacts contacts = make_contacts(points);
  Judged judged{what, points, {}};
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    std::cerr << what << ", tolerance " << tolerances[i] << '\n';
    judged.answers[i] = answer(contacts, points, tolerances[i]);
  }
  return judged;
}

}  // namespace

bool write_relaxing(std::ostream& out) {
  const Judged relaxing = judge("relaxing", read_relaxing());
  out << text::verdict;
  bool all_honest = true;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    write_verdict(out, relaxing, i);
    all_honest = all_honest && honest(tally(relaxing.points, relaxing.answers[i], lost_fraction));
  }
  out << text::relaxing_tally;
  write_tallies(out, relaxing.points, relaxing.answers);
  out << text::relaxing_points;
  write_relaxing_points(out, relaxing.points, relaxing.answers[by_default]);
  return all_honest;
}

bool write_report(std::ostream& out) {
  const Judged wall = judge("wall", read_points()), unseen = judge("wall, unseen", read_unseen_points()),
               pairs = judge("pairs", read_pairs()), spheres = judge("spheres", read_spheres()),
               half_spaces = judge("half-spaces", read_half_spaces()), lossy = judge("lossy", read_lossy()),
               relaxing = judge("relaxing", read_relaxing()), vibrating = judge("vibrating", read_vibrating());
  const JudgedOblique oblique = judge_oblique();
  const JudgedPlates plates = judge_plates();
  out << text::introduction << text::verdict;
  bool all_honest = true;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    for (const Judged* judged : {&wall, &unseen, &pairs, &spheres, &half_spaces, &lossy, &relaxing, &vibrating}) {
      write_verdict(out, *judged, i);
      all_honest = all_honest && honest(tally(judged->points, judged->answers[i], lost_fraction));
    }
  }
  std::cerr << "processor time\n";
  write_times(out);
  write_oblique_times(out, oblique);
  write_plate_times(out, plates);
  out << text::tally;
  write_tallies(out, wall.points, wall.answers);
  out << text::unseen_tally;
  write_tallies(out, unseen.points, unseen.answers);
  out << text::pair_tally;
  write_tallies(out, pairs.points, pairs.answers);
  out << text::sphere_tally;
  write_tallies(out, spheres.points, spheres.answers);
  out << text::half_space_tally;
  write_tallies(out, half_spaces.points, half_spaces.answers);
  out << text::lossy_tally;
  write_tallies(out, lossy.points, lossy.answers);
  out << text::relaxing_tally;
  write_tallies(out, relaxing.points, relaxing.answers);
  out << text::vibrating_tally;
  write_tallies(out, vibrating.points, vibrating.answers);
  write_finite_elements(out, wall.points, wall.answers[by_default]);
  const bool rod = write_rod(out);
  all_honest = write_oblique(out, oblique) && all_honest;
  all_honest = write_plates(out, plates) && all_honest;
  all_honest = write_modal(out) && all_honest;
  out << text::points;
  write_points(out, wall.points, wall.answers[by_default]);
  out << text::unseen_points;
  write_points(out, unseen.points, unseen.answers[by_default]);
  out << text::pairs;
  write_points(out, pairs.points, pairs.answers[by_default]);
  out << text::sphere_points;
  write_points(out, spheres.points, spheres.answers[by_default]);
  out << text::half_space_points;
  write_points(out, half_spaces.points, half_spaces.answers[by_default]);
  out << text::lossy_points;
  write_points(out, lossy.points, lossy.answers[by_default]);
  out << text::relaxing_points;
  write_relaxing_points(out, relaxing.points, relaxing.answers[by_default]);
  out << text::vibrating_points;
  write_points(out, vibrating.points, vibrating.answers[by_default]);
  return all_honest && rod;
}

}  // namespace validate
