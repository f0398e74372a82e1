#include "stoss/body.hpp"

#include <algorithm>
#include <cmath>

#include "stoss/errors.hpp"

namespace stoss {
namespace {

void require(const Body& body, bool condition, const std::string& rule) {
  if (!condition) throw InvalidInput("body: got '" + body.name + "', allowed only a body with " + rule);
}

bool positive(double x) { return std::isfinite(x) && x > 0.0; }

bool finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

void validate(const Body& body) {
  require(body, positive(body.mass) && positive(body.extent) && positive(body.cutoff),
          "a positive finite mass, extent and cutoff");
  require(body, body.stable_step > 0.0, "a positive stable_step");
  require(body, std::isfinite(body.max_half_width) && body.max_half_width >= 0.0, "max_half_width >= 0");
  for (const ModeGroup& group : body.groups) {
    require(body, group.radial.size() == group.omega.size() && group.tangential.size() == group.omega.size(),
            "omega, radial and tangential of one length in each group");
    require(body, finite(group.radial) && finite(group.tangential), "finite amplitudes");
    require(body,
            std::all_of(group.omega.begin(), group.omega.end(),
                        [&body](double omega) { return omega > 0.0 && omega <= body.cutoff; }),
            "frequencies above 0 and up to its cutoff");
  }
  require(body, body.expected_half_width && body.grid && body.residual_compliance && body.residual_second_moment,
          "all four functions set");
}

std::size_t mode_count(const Body& body) {
  std::size_t count = 0;
  for (const auto& group : body.groups) count += group.omega.size();
  return count;
}

}  // namespace stoss
