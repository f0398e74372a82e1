#include "judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "restitution/ordered_jobs.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/bodies/half_space.hpp"
#include "stoss/bodies/hollow_sphere.hpp"
#include "stoss/bodies/sphere.hpp"

namespace validate {
namespace {

Answer answer_at(const stoss::RefinableContact& body, const Point& point, double tolerance) {
  stoss::RestitutionOptions options{.tolerance = tolerance, .absolute = least_error(point)};
  if (point.temperature > 0.0) {
    constexpr double none = 1e-15;
    options = {.tolerance = none, .absolute = tolerance, .vibration = vibration_of(point, body)};
  }
  const stoss::Restitution result = best(body, point.speed, options);
  return {{result.lost_fraction, result.restitution, result.contact_time, result.impulse_time, result.max_force,
           result.max_compression},
          result.converged,
          result.finest.cutoff};
}

stoss::RefinableContact alone_or_paired(const Point& point) {
  const stoss::Disk disk{.poisson = point.poisson, .loss_time = point.loss_time};
  const auto maker = [&point](const stoss::Disk& its) {
    if (!point.sphere) return stoss::disk(its);
    return stoss::sphere(stoss::Sphere{its.poisson, its.radius, its.young, its.density, its.loss_time});
  };
  const stoss::BodyMaker first = relaxing(maker(disk), point.relaxation);
  if (!point.against) return stoss::RefinableContact(first);
  return stoss::RefinableContact(first, relaxing(maker(*point.against), point.against_relaxation));
}

}  // namespace

Makers makers_of(const Point& point) {
  const stoss::Disk& solid = *point.against;
  const stoss::BodyMaker body = point.sphere ? stoss::sphere(point.poisson) : stoss::disk(point.poisson);
  const stoss::BodyMaker met = point.sphere
                                   ? stoss::half_space(stoss::HalfSpace{solid.poisson, solid.young, solid.density})
                                   : stoss::half_plane(stoss::HalfPlane{solid.poisson, solid.young, solid.density});
  return {point.rigid ? stoss::rigid(body) : relaxing(body, point.relaxation), relaxing(met, point.against_relaxation)};
}

Contacts make_contacts(const std::vector<Point>& points) {
  std::map<double, stoss::RefinableContact> at_wall, spheres_at_wall;
  Contacts contacts;
  for (const Point& point : points) {
    if (point.encounter) {
      contacts.push_back(stoss::refinable(*point.encounter));
    } else if (point.half_space) {
      const Makers makers = makers_of(point);
      contacts.emplace_back(makers.first, makers.second);
    } else if (point.loss_time > 0.0 || !point.relaxation.terms.empty() || point.temperature > 0.0) {
      contacts.push_back(alone_or_paired(point));
    } else if (point.against) {
      contacts.emplace_back(stoss::disk(point.poisson), stoss::disk(*point.against));
    } else if (point.inner > 0.0) {
      contacts.emplace_back(stoss::hollow_sphere({.poisson = point.poisson, .inner = point.inner}));
    } else if (point.sphere) {
      contacts.push_back(spheres_at_wall.try_emplace(point.poisson, stoss::sphere(point.poisson)).first->second);
    } else {
      contacts.push_back(at_wall.try_emplace(point.poisson, stoss::disk(point.poisson)).first->second);
    }
  }
  return contacts;
}

double least_error(const Point& point) {
  constexpr double hardly_any = 1e-9;  // asperities leave nothing of the ringing
  return point.encounter ? hardly_any : 0.0;
}

std::vector<Answer> answer(const Contacts& contacts, const std::vector<Point>& points, double tolerance) {
  constexpr int threads = 2;
  std::vector<Answer> answers;
  answers.reserve(points.size());
  stoss::run_in_order<Answer>(
      points.size(), threads,
      [&](std::size_t i, const stoss::Poll&) { return answer_at(contacts[i], points[i], tolerance); },
      [&](std::size_t, Answer&& answer) { answers.push_back(answer); }, {});
  return answers;
}

stoss::Restitution best(const stoss::RefinableContact& body, double speed, const stoss::RestitutionOptions& options) {
  try {
    return stoss::restitution(body, speed, options);
  } catch (const stoss::RestitutionNotConverged& failure) {
    return failure.best;
  }
}

Deviation deviation(const stoss::Estimate& answer, const stoss::Estimate& reference) {
  constexpr double sharp = 0.1;
  const double difference = std::abs(answer.value - reference.value);
  const bool within = difference <= answer.error;
  if (reference.error > sharp * answer.error) {
    return {std::max(0.0, difference - reference.error) / answer.error, within, std::nullopt};
  }
  return {difference / answer.error, within, answer.error / difference};
}

Tally tally(const std::vector<Comparison>& all) {
  Tally result;
  std::vector<double> paddings;
  for (const auto& [answer, reference] : all) {
    const Deviation off = deviation(answer, reference);
    ++result.points;
    if (off.ratio <= 1.0) ++result.within;
    if (off.strictly_within) ++result.strictly_within;
    if (off.padding) {
      paddings.push_back(*off.padding);
    } else {
      ++result.blurred;
    }
    result.greatest = std::max(result.greatest, off.ratio);
  }
  result.padding = median(paddings);
  return result;
}

Tally tally(const std::vector<Point>& points, const std::vector<Answer>& answers, Quantity quantity) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<stoss::Estimate>& reference = points[i].reference[quantity];
    if (reference) all.push_back({answers[i].value[quantity], *reference});
  }
  return tally(all);
}

bool honest(const Tally& tally) {
  return tally.within >= 0.95 * tally.points && tally.greatest <= 3.0 && tally.padding <= 10.0;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) - 1];
}

}  // namespace validate
