// Reference values for pairs of unequal disks.
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "reference.hpp"
#include "runs.hpp"
#include "stoss/bodies/disk.hpp"
#include "stoss/restitution/ladder.hpp"

namespace validate {
namespace {

constexpr int pairs = 48;

/// In units of 1/time_scale, as the ladder of restitution().
constexpr Finenesses finenesses{Fineness{100.0, 0.2, 1.8}, Fineness{141.0, 0.35, 1.1}, Fineness{200.0, 0.3, 1.3}};

/// Point i of an additive sequence in six dimensions, with the generalised golden ratio.
double spread(int i, int dimension) {
  constexpr double ratio = 1.1127756842787055;  // x⁷ = x + 1
  const double step = 0.5 + (i + 1) * std::pow(ratio, -(dimension + 1));
  return step - std::floor(step);
}

/// ν from −0.6 to 0.9, radii within a factor of 4, moduli and densities within 2, speeds from 1e-5 to 0.4.
std::vector<ReferencePoint> design() {
  std::vector<ReferencePoint> points;
  const auto poisson = [](double x) { return rounded("%.2f", -0.6 + 1.5 * x); };
  const auto factor = [](double x, double greatest) { return rounded("%.3g", std::pow(greatest, 2.0 * x - 1.0)); };
  for (int i = 0; i < pairs; ++i) {
    const stoss::Disk against{poisson(spread(i, 1)), factor(spread(i, 2), 4.0), factor(spread(i, 3), 2.0),
                              factor(spread(i, 4), 2.0)};
    const double nu = poisson(spread(i, 0)), speed = rounded("%.3e", 0.4 * std::pow(2.5e-5, spread(i, 5)));
    std::ostringstream place;
    place << nu << ',' << against.poisson << ',' << against.radius << ',' << against.young << ',' << against.density
          << ',' << speed;
    points.push_back({place.str(), speed, [nu, against](double cutoff) {
                        const stoss::BodyMaker first = stoss::disk(nu), second = stoss::disk(against);
                        const double unit = 1.0 / stoss::time_scale(stoss::RefinableContact(first, second).at(0));
                        return stoss::contact(first, second, unit * cutoff);
                      }});
  }
  return points;
}

std::string header() {
  return "# Pairs of unequal disks in units of the first (docs/theory/pairs.md), more finely resolved than those of\n"
         "# restitution(). Made by: stoss_validate --make-pair-reference FILE\n"
         "# Three runs at each point, with cutoffs 100, 141, 200 over the time scale of the pair, steps and nodes as "
         "in\n"
         "# reference.csv. Value: that of the last run; uncertainty: spread of the three.\n"
         "poisson,against_poisson,against_radius,against_young,against_density,speed," +
         quantity_columns + '\n';
}

}  // namespace

void make_pair_reference(const std::string& path) { write_reference(path, header(), design(), finenesses); }

}  // namespace validate
