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
[[gnu::always_inline]] inline void differentiate(const Values& u, Values& r, Values& s) {
  for (std::size_t line = 0; line < side; ++line) {
    for (std::size_t i = 0; i < side; ++i) {
      Lanes along_r = derivative[i][0] * u[line];
      Lanes along_s = derivative[i][0] * u[line * side];
      for (std::size_t k = 1; k < side; ++k) {
        along_r += derivative[i][k] * u[k * side + line];
        along_s += derivative[i][k] * u[line * side + k];
      }
      r[i * side + line] = along_r;
      s[line * side + i] = along_s;
    }
  }
}

/// The transpose of `differentiate`.
[[gnu::always_inline]] inline void differentiate_transposed(const Values& r, const Values& s, Values& u) {
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      Lanes sum = derivative[0][row] * r[column] + derivative[0][column] * s[row * side];
      for (std::size_t k = 1; k < side; ++k) {
        sum += derivative[k][row] * r[k * side + column] + derivative[k][column] * s[row * side + k];
      }
      u[row * side + column] = sum;
    }
  }
}

}  // namespace

STOSS_MULTIVERSION
void add_forces(const ElementGroup* groups, std::size_t number, const Moduli& moduli, std::size_t count,
                const double* displacement, double* force) {
  const auto [normal, lateral, shear] = moduli;
  for (std::size_t g = 0; g < number; ++g) {
    const ElementGroup& group = groups[g];
    Values u, x_r, x_s, z_r, z_s;  // derivatives of the displacement, then what stress makes of them
    load(group, displacement, u);
    differentiate(u, x_r, x_s);
    load(group, displacement + count, u);
    differentiate(u, z_r, z_s);
    for (std::size_t node = 0; node < element_nodes; ++node) {
      const auto& [r_x, s_x, r_z, s_z] = group.slope[node];
      const Lanes xx = r_x * x_r[node] + s_x * x_s[node];
      const Lanes zz = r_z * z_r[node] + s_z * z_s[node];
      const Lanes twice_xz = r_z * x_r[node] + s_z * x_s[node] + r_x * z_r[node] + s_x * z_s[node];
      const Lanes stress_xx = normal * xx + lateral * zz;
      const Lanes stress_zz = lateral * xx + normal * zz;
      const Lanes stress_xz = shear * twice_xz;
      x_r[node] = r_x * stress_xx + r_z * stress_xz;
      x_s[node] = s_x * stress_xx + s_z * stress_xz;
      z_r[node] = r_x * stress_xz + r_z * stress_zz;
      z_s[node] = s_x * stress_xz + s_z * stress_zz;
    }
    differentiate_transposed(x_r, x_s, u);
    subtract(group, u, force);
    differentiate_transposed(z_r, z_s, u);
    subtract(group, u, force + count);
  }
}

}  // namespace bench
