#include "element_forces.hpp"

#include "numeric/multiversion.hpp"

namespace bench {
namespace {

constexpr std::size_t side = element_side;
constexpr std::size_t lanes = ElementGroup::lanes;
using Lanes = ElementGroup::Lanes;
using Neighbours [[gnu::vector_size(8 * lanes), gnu::aligned(8), gnu::may_alias]] = double;  // anywhere in memory
using Values = Lanes[element_nodes];

[[gnu::always_inline]] inline void load(const ElementGroup& group, const double* all, Values& values) {
  const double* inner = all + group.inner;
  for (std::size_t node = 0; node < element_nodes; ++node) {
    if (is_inner(node)) {
      values[node] = *reinterpret_cast<const Neighbours*>(inner);
      inner += lanes;
    } else {
      for (std::size_t i = 0; i < lanes; ++i) values[node][i] = all[group.rim[node][i]];
    }
  }
}

[[gnu::always_inline]] inline void subtract(const ElementGroup& group, const Values& values, double* all) {
  double* inner = all + group.inner;
  for (std::size_t node = 0; node < element_nodes; ++node) {
    if (is_inner(node)) {
      *reinterpret_cast<Neighbours*>(inner) = -values[node];
      inner += lanes;
    } else {
      for (std::size_t i = 0; i < lanes; ++i) all[group.rim[node][i]] -= values[node][i];
    }
  }
}

/// ∂/∂r, along columns, and ∂/∂s, along rows.
template <const SpectralRule& r_rule>
[[gnu::always_inline]] inline void differentiate(const Values& u, Values& r, Values& s) {
  for (std::size_t line = 0; line < side; ++line) {
    for (std::size_t i = 0; i < side; ++i) {
      Lanes along_r = r_rule.derivative[i][0] * u[line];
      Lanes along_s = lobatto.derivative[i][0] * u[line * side];
      for (std::size_t k = 1; k < side; ++k) {
        along_r += r_rule.derivative[i][k] * u[k * side + line];
        along_s += lobatto.derivative[i][k] * u[line * side + k];
      }
      r[i * side + line] = along_r;
      s[line * side + i] = along_s;
    }
  }
}

/// The transpose of `differentiate`.
template <const SpectralRule& r_rule>
[[gnu::always_inline]] inline void differentiate_transposed(const Values& r, const Values& s, Values& u) {
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      Lanes sum = r_rule.derivative[0][row] * r[column] + lobatto.derivative[0][column] * s[row * side];
      for (std::size_t k = 1; k < side; ++k) {
        sum += r_rule.derivative[k][row] * r[k * side + column] + lobatto.derivative[k][column] * s[row * side + k];
      }
      u[row * side + column] = sum;
    }
  }
}

enum class Kind { plane, beside_axis, at_axis };

/// @param hoop only about an axis
template <Kind kind>
[[gnu::always_inline]] inline void add_forces_of(const ElementGroup& group, const HoopGroup* hoop, const Moduli& moduli,
                                                 std::size_t count, const double* displacement, double* force) {
  constexpr const SpectralRule& r_rule = kind == Kind::at_axis ? lobatto_at_axis : lobatto;
  const auto [normal, lateral, shear] = moduli;
  Values x, z, x_r, x_s, z_r, z_s;  // displacement and its derivatives, then what stress makes of them
  load(group, displacement, x);
  differentiate<r_rule>(x, x_r, x_s);
  load(group, displacement + count, z);
  differentiate<r_rule>(z, z_r, z_s);
  for (std::size_t node = 0; node < element_nodes; ++node) {
    const bool on_axis = kind == Kind::at_axis && node < side;
    const auto& [r_x, s_x, r_z, s_z] = group.slope[node];
    const Lanes xx = r_x * x_r[node] + s_x * x_s[node];
    const Lanes zz = r_z * z_r[node] + s_z * z_s[node];
    const Lanes twice_xz = r_z * x_r[node] + s_z * x_s[node] + r_x * z_r[node] + s_x * z_s[node];
    Lanes stress_xx = normal * xx + lateral * zz;
    Lanes stress_zz = lateral * xx + normal * zz;
    const Lanes stress_xz = shear * twice_xz;
    if constexpr (kind != Kind::plane) {
      const Lanes around = on_axis ? xx : hoop->slope[node] * x[node];
      const Lanes stress_around = lateral * (xx + zz) + normal * around;
      stress_xx += lateral * around;
      stress_zz += lateral * around;
      if (on_axis) {
        stress_xx += stress_around;
      } else {
        x[node] = hoop->slope[node] * stress_around;
      }
    }
    x_r[node] = r_x * stress_xx + r_z * stress_xz;
    x_s[node] = s_x * stress_xx + s_z * stress_xz;
    z_r[node] = r_x * stress_xz + r_z * stress_zz;
    z_s[node] = s_x * stress_xz + s_z * stress_zz;
  }
  Values sum;
  differentiate_transposed<r_rule>(x_r, x_s, sum);
  if constexpr (kind != Kind::plane) {
    for (std::size_t node = kind == Kind::at_axis ? side : 0; node < element_nodes; ++node) sum[node] += x[node];
  }
  subtract(group, sum, force);
  differentiate_transposed<r_rule>(z_r, z_s, sum);
  subtract(group, sum, force + count);
}

}  // namespace

STOSS_MULTIVERSION
void add_forces(const Groups& groups, const Moduli& moduli, std::size_t count, const double* displacement,
                double* force) {
  const std::size_t number = groups.all.size();
  if (groups.hoops.empty()) {
    for (std::size_t g = 0; g < number; ++g)
      add_forces_of<Kind::plane>(groups.all[g], nullptr, moduli, count, displacement, force);
    return;
  }
  for (std::size_t g = 0; g < groups.at_axis; ++g)
    add_forces_of<Kind::at_axis>(groups.all[g], &groups.hoops[g], moduli, count, displacement, force);
  for (std::size_t g = groups.at_axis; g < number; ++g)
    add_forces_of<Kind::beside_axis>(groups.all[g], &groups.hoops[g], moduli, count, displacement, force);
}

}  // namespace bench
