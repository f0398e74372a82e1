#include "contact/residual_part.hpp"

#include <functional>
#include <utility>

#include "contact/units.hpp"
#include "stoss/errors.hpp"

namespace stoss {
namespace {

using Residual = std::function<std::vector<double>(const ContactPoints&, const Poll&)>;

std::vector<double> residual_matrix(const Body& body, const Residual& residual, const ContactPoints& points,
                                    const Poll& poll) {
  std::vector<double> matrix = residual(points, poll);
  if (matrix.size() == points.count * points.count) return matrix;
  throw InvalidInput("body: got a residual of '" + body.name + "' of another size, allowed points x points values");
}

/// One residual matrix of the second body, in its own units.
std::vector<double> of_second(const Contact& contact, const ContactGrid& grid, Residual Body::*residual,
                              const Poll& poll) {
  const Units units(*contact.second, *contact.first);
  return residual_matrix(*contact.second, (*contact.second).*residual, seen_by_second(grid.points, units), poll);
}

/// The sum of one residual matrix of both bodies.
std::vector<double> residual_sum(const Contact& contact, const ContactGrid& grid, Residual Body::*residual,
                                 double Units::*unit, const Poll& poll) {
  std::vector<double> sum = residual_matrix(*contact.first, (*contact.first).*residual, grid.points, poll);
  if (contact.second == nullptr) return sum;
  const double scale = Units(*contact.second, *contact.first).*unit;
  const std::vector<double> second = of_second(contact, grid, residual, poll);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += scale * second[i];
  return sum;
}

std::vector<double> times(double scale, std::vector<double> values) {
  for (double& each : values) each *= scale;
  return values;
}

ResidualPart first_part(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const Body& body = *contact.first;
  return {residual_matrix(body, body.residual_compliance, grid.points, poll),
          [&body, &grid, poll] { return residual_matrix(body, body.residual_second_moment, grid.points, poll); },
          body.surface(grid.points).impedance, kept_cutoff(body), body.loss_time};
}

ResidualPart second_part(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const Body& body = *contact.second;
  const Units units(body, *contact.first);
  return {times(units.compliance, of_second(contact, grid, &Body::residual_compliance, poll)),
          [&contact, &grid, poll, units] {
            return times(units.second_moment, of_second(contact, grid, &Body::residual_second_moment, poll));
          },
          times(units.impedance, body.surface(seen_by_second(grid.points, units)).impedance),
          kept_cutoff(body) / units.time,
          body.loss_time * units.time,
          1};
}

}  // namespace

std::vector<ResidualPart> residual_parts(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const double loss_time = longest_loss_time(contact);
  if (contact.second != nullptr && loss_time > 0.0) {
    if (contact.first->softness == 0.0) return {second_part(contact, grid, poll)};
    if (contact.second->softness == 0.0) return {first_part(contact, grid, poll)};
    return {first_part(contact, grid, poll), second_part(contact, grid, poll)};
  }
  return {{residual_compliance(contact, grid, poll),
           [&contact, &grid, poll] { return residual_second_moment(contact, grid, poll); }, grid.impedance,
           kept_cutoff(contact.cutoff, loss_time), loss_time}};
}

std::vector<double> residual_compliance(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  return residual_sum(contact, grid, &Body::residual_compliance, &Units::compliance, poll);
}

std::vector<double> residual_second_moment(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  return residual_sum(contact, grid, &Body::residual_second_moment, &Units::second_moment, poll);
}

}  // namespace stoss
