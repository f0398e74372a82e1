#include "plate_report.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <ostream>
#include <string>

#include "plate_text.hpp"
#include "restitution/ordered_jobs.hpp"
#include "tally_rows.hpp"

namespace validate {
namespace {

using Which = std::function<bool(const PlateCase&)>;

struct Share {
  const char* name;
  Which is;
};

const std::vector<Share>& shares() {
  static const std::vector<Share> all{
      {"all", [](const PlateCase&) { return true; }},
      {"spheres", [](const PlateCase& its) { return !its.strip; }},
      {"on layers", [](const PlateCase& its) { return its.layers.size() > 1; }},
      {"disks", [](const PlateCase& its) { return its.strip; }},
      {"rigid", [](const PlateCase& its) { return its.rigid; }},
      {"lossy", [](const PlateCase& its) { return its.plate_loss_time > 0.0; }},
  };
  return all;
}

double processor_time() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Answer answer_of(const stoss::RefinableContact& contact, double speed) {
  try {
    const stoss::Restitution result = best(contact, speed, {});
    return {{result.lost_fraction, result.restitution, result.contact_time, result.impulse_time, result.max_force,
             result.max_compression},
            result.converged,
            result.finest.cutoff * stoss::time_scale(contact.at(0))};
  } catch (const std::exception& error) {
    std::cerr << contact.at(0).second->name << ": " << error.what() << '\n';
    Answer none;
    none.value.fill({0.0, std::numeric_limits<double>::infinity()});
    return none;
  }
}

PlateAnswer answer_to(const PlateCase& its) {
  const double begin = processor_time();
  const stoss::RefinableContact contact = contact_of(its);
  PlateAnswer answer{answer_of(contact, its.speed)};
  answer.first_seconds = processor_time() - begin;
  const double middle = processor_time();
  (void)answer_of(contact, its.speed);
  answer.seconds = processor_time() - middle;
  return answer;
}

std::vector<PlateAnswer> answers_to(const std::vector<PlatePoint>& points) {
  constexpr int threads = 2;
  std::vector<PlateAnswer> answers;
  stoss::run_in_order<PlateAnswer>(
      points.size(), threads, [&](std::size_t i, const stoss::Poll&) { return answer_to(points[i].its); },
      [&](std::size_t, PlateAnswer&& answer) { answers.push_back(answer); }, {});
  return answers;
}

Tally tally_of(const std::vector<PlatePoint>& points, const std::vector<PlateAnswer>& answers, const Which& is,
               Quantity quantity) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<stoss::Estimate>& reference = points[i].reference[quantity];
    if (is(points[i].its) && reference) all.push_back({answers[i].its.value[quantity], *reference});
  }
  return tally(all);
}

void write_times(std::ostream& out, const JudgedPlates& judged, const char* name, bool slow) {
  constexpr double least = 1e-3;
  std::vector<double> seconds, first;
  int converged = 0;
  for (std::size_t i = 0; i < judged.points.size(); ++i) {
    if ((judged.points[i].its.speed < least) != slow) continue;
    seconds.push_back(1e3 * judged.answers[i].seconds);
    first.push_back(1e3 * judged.answers[i].first_seconds);
    converged += judged.answers[i].its.converged ? 1 : 0;
  }
  out << "| " << name << " | " << converged << " of " << seconds.size() << " |" << cell("%.0f", median(seconds))
      << cell("%.0f", quantile(seconds, 0.9)) << cell("%.0f", quantile(seconds, 1.0)) << cell("%.0f", median(first))
      << cell("%.0f", quantile(first, 1.0)) << '\n';
}

void write_point(std::ostream& out, const PlatePoint& point, const PlateAnswer& answer) {
  const PlateCase& its = point.its;
  const stoss::Estimate& reference = *point.reference[lost_fraction];
  const stoss::Estimate& value = answer.its.value[lost_fraction];
  const Deviation off = deviation(value, reference);
  out << "| " << (its.rigid ? "rigid " : "") << (its.strip ? "disk |" : "sphere |") << cell("%g", its.poisson)
      << cell("%g", its.loss_time) << ' ' << text_of(its.layers) << " |" << cell("%g", its.plate_loss_time)
      << cell("%.4g", its.speed) << cell("%.8f", reference.value) << cell("%.1e", reference.error)
      << cell("%.8f", value.value) << cell("%.1e", value.error) << cell(off.padding ? "%.2f" : "%.2f u", off.ratio)
      << cell("%.1f", answer.its.cutoff) << '\n';
}

}  // namespace

JudgedPlates judge_plates() {
  std::cerr << "plates\n";
  JudgedPlates judged{read_plates(), read_unseen_plates(), read_plates_of_elements(), {}, {}, {}};
  judged.answers = answers_to(judged.points);
  judged.at_unseen = answers_to(judged.unseen);
  judged.at_elements = answers_to(judged.elements);
  return judged;
}

void write_plate_times(std::ostream& out, const JudgedPlates& judged) {
  out << text::plate_times;
  write_times(out, judged, "v ≥ 10⁻³", false);
  write_times(out, judged, "v < 10⁻³", true);
}

bool write_plates(std::ostream& out, const JudgedPlates& judged) {
  const auto& [points, unseen, elements, answers, at_unseen, at_elements] = judged;
  out << text::plate_tally;
  const auto write_all = [&out](const std::vector<PlatePoint>& its, const std::vector<PlateAnswer>& said) {
    for (const Share& share : shares()) {
      write_tally(out, share.name, quantity_names[lost_fraction], tally_of(its, said, share.is, lost_fraction));
    }
    for (std::size_t quantity = restitution_coefficient; quantity < quantities; ++quantity) {
      write_tally(out, "all", quantity_names[quantity],
                  tally_of(its, said, shares().front().is, static_cast<Quantity>(quantity)));
    }
    return honest(tally_of(its, said, shares().front().is, lost_fraction));
  };
  bool all_honest = write_all(points, answers);
  const Tally by_elements = tally_of(elements, at_elements, shares().front().is, lost_fraction);
  write_tally(out, "finite elements", quantity_names[lost_fraction], by_elements);
  all_honest = honest(by_elements) && all_honest;
  out << text::unseen_plate_tally;
  all_honest = write_all(unseen, at_unseen) && all_honest;
  out << "\nThe conditions are" << (all_honest ? " met.\n" : " **not met**.\n") << text::plate_points;
  for (std::size_t i = 0; i < points.size(); ++i) write_point(out, points[i], answers[i]);
  out << text::unseen_plate_points;
  for (std::size_t i = 0; i < unseen.size(); ++i) write_point(out, unseen[i], at_unseen[i]);
  out << text::plate_elements;
  for (std::size_t i = 0; i < elements.size(); ++i) write_point(out, elements[i], at_elements[i]);
  return all_honest;
}

}  // namespace validate
