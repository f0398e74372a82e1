#include "contact/residual/residual_part.hpp"

#include <functional>
#include <utility>

#include "contact/faces/projected_areas.hpp"
#include "contact/group_loss.hpp"
#include "contact/unit_ratios.hpp"
#include "numeric/damped_oscillator.hpp"
#include "numeric/dense.hpp"
#include "relaxation/oscillator.hpp"
#include "stoss/contact/grid.hpp"
#include "stoss/errors.hpp"

namespace stoss {

Creep creep_of(const Body& body, double unit) {
  if (body.loss_time > 0.0) return kelvin_voigt_creep(body.loss_time * unit);
  return creep(Rates(in_time(body.relaxation, unit)));
}

namespace {

std::vector<double> times(double scale, std::vector<double> values) {
  for (double& each : values) each *= scale;
  return values;
}

/// Changes the sign of the second component, where there is one.
void turn_around(std::size_t points, std::size_t values, std::vector<double>& matrix) {
  for (std::size_t i = 0; i < values; ++i) {
    for (std::size_t j = 0; j < values; ++j) {
      if ((i < points) != (j < points)) matrix[i * values + j] = -matrix[i * values + j];
    }
  }
}

ResidualPart first_part(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const Body& body = *contact.first;
  return {residual_of(contact, grid, 0, &Body::residual_compliance, poll),
          [&contact, &grid, poll] { return residual_of(contact, grid, 0, &Body::residual_second_moment, poll); },
          body.surface(grid.points).impedance, kept_cutoff(body), creep_of(body, 1.0)};
}

ResidualPart second_part(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  const Body& body = *contact.second;
  const UnitRatios units = units_of(contact, 1);
  return {times(units.compliance, residual_of(contact, grid, 1, &Body::residual_compliance, poll)),
          [&contact, &grid, poll, units] {
            return times(units.second_moment, residual_of(contact, grid, 1, &Body::residual_second_moment, poll));
          },
          times(units.impedance, body.surface(seen_by(grid.points, units)).impedance),
          kept_cutoff(body) / units.time,
          creep_of(body, units.time),
          1};
}

/// Braces would copy its matrix.
std::vector<ResidualPart> alone(ResidualPart part) {
  std::vector<ResidualPart> parts;
  parts.push_back(std::move(part));
  return parts;
}

}  // namespace

std::vector<double> residual_of(const Contact& contact, const ContactGrid& grid, int number, Residual residual,
                                const Poll& poll) {
  const Body& body = *body_of(contact, number);
  const ContactPoints points = seen_by(grid.points, units_of(contact, number));
  std::vector<double> matrix = (body.*residual)(points, poll);
  const std::size_t values = body.components * points.count;
  if (matrix.size() == values * values) {
    if (number == 1) turn_around(points.count, values, matrix);
    return matrix;
  }
  throw InvalidInput::out_of_range("body", "a residual of '" + body.name + "' of another size",
                                   "points x points values");
}

std::vector<ResidualPart> residual_parts(const Contact& contact, const ContactGrid& grid, const Poll& poll) {
  if (loses(contact)) {
    if (body_of(contact, 1) == nullptr) return alone(first_part(contact, grid, poll));
    if (contact.first->softness == 0.0) return alone(second_part(contact, grid, poll));
    if (contact.second->softness == 0.0) return alone(first_part(contact, grid, poll));
    std::vector<ResidualPart> both = alone(first_part(contact, grid, poll));
    both.push_back(second_part(contact, grid, poll));
    return both;
  }
  return alone({residual_compliance(contact, grid, poll),
                [&contact, &grid, poll] { return residual_second_moment(contact, grid, poll); }, grid.impedance,
                contact.cutoff});
}

std::vector<ResidualPart> coats(const Contact& contact, const ContactGrid& grid) {
  std::vector<ResidualPart> parts;
  for (int number = 0; number < 2; ++number) {
    const auto body = body_of(contact, number);
    if (body == nullptr || body->coat.compliance == 0.0) continue;
    const UnitRatios units = units_of(contact, number);
    const std::vector<double> area = projected_areas(contact, grid.points);
    const std::size_t values = grid.recess.size(), points = area.size();
    ResidualPart part;
    part.compliance.resize(values * values);
    for (std::size_t i = 0; i < values; ++i) {
      const double its = i < points ? body->coat.compliance : body->coat.along;
      part.compliance[i * values + i] = its * units.length / (units.stress * area[i % points]);
    }
    part.creep = creep(Rates(in_time(body->coat.relaxation, units.time)));
    part.body = static_cast<std::size_t>(number);
    parts.push_back(std::move(part));
  }
  return parts;
}

namespace dense = numeric::dense;

using Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

namespace {

/// The displacement of the modes of a group per force that kicks leave out.
class BesideKicks {
 public:
  BesideKicks(const Contact& contact, std::size_t group, double step)
      : step_(step), mass_(contact.mass), weaker_(longest_loss_time(contact) > 0.0), loss_(contact, group) {}

  [[nodiscard]] double of(std::size_t index, double omega) const {
    if (weaker_) {
      const auto [gamma, frequency] = loss_.dashpot(index, step_);
      return numeric::stable_kicks(frequency, gamma, step_).at_once / (frequency * frequency * mass_);
    }
    if (loss_.relaxes()) return relaxing_oscillator(omega, loss_.rates(index)).missing_beside_kicks(step_) / mass_;
    return numeric::share_beside_kicks(omega, 0.0, step_) / (omega * omega * mass_);
  }

 private:
  double step_, mass_;
  bool weaker_;
  GroupLoss loss_;
};

}  // namespace

void add_kick_compliance(const Contact& contact, const ContactGrid& grid, double step, const Poll& poll,
                         Eigen::Ref<Eigen::MatrixXd> compliance) {
  if (contact.groups.empty()) return;
  const auto n = compliance.rows();
  const Eigen::Map<const RowMajor> shape(grid.shape.data(), static_cast<Index>(grid.shape.size()) / n, n);
  RowMajor response = RowMajor::Zero(shape.rows(), n);  // of each shape to forces on the nodes
  for (std::size_t g = 0; g < contact.groups.size(); ++g) {
    const ModeGroup& group = contact.groups[g];
    const BesideKicks beside(contact, g, step);
    double upper = 0.0, mixed = 0.0, lower = 0.0;
    for (std::size_t l = 0; l < group.omega.size(); ++l) {
      const double missing = beside.of(l, group.omega[l]);
      upper += missing * group.upper[l] * group.upper[l];
      mixed += missing * group.upper[l] * group.lower[l];
      lower += missing * group.lower[l] * group.lower[l];
    }
    const auto u = static_cast<Index>(group.upper_row), l = static_cast<Index>(group.lower_row);
    response.row(u) += upper * shape.row(u) + mixed * shape.row(l);
    response.row(l) += mixed * shape.row(u) + lower * shape.row(l);
  }
  dense::by_columns(n, poll, [&](Index first, Index count) {
    compliance.middleCols(first, count).noalias() += shape.transpose() * response.middleCols(first, count);
  });
}

}  // namespace stoss
