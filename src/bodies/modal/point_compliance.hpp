#pragma once

namespace stoss::bodies::modal {

/// c₀ of a sphere of radius and modulus 1, as ModalBody::compliance: what is left at its pole of its static response to
/// a force there, without that of a half-space and the logarithm. Summed over the degrees to 1e-10.
///
/// ν = 0: −0.66; 0.3: −0.51 (docs/theory/any_body.md)
[[nodiscard]] double sphere_constant(double poisson);

/// g = (1 − 2ν)²/(2(1 − ν)) of the logarithm.
[[nodiscard]] double logarithm_share(double poisson);

/// c_t of a sphere of radius and modulus 1, as PointTangent::compliance, in the same way.
[[nodiscard]] double sphere_constant_along(double poisson);

/// g_t = (3 − 2ν + 4ν²)/(2(2 − ν)) of its logarithm.
[[nodiscard]] double logarithm_share_along(double poisson);

}  // namespace stoss::bodies::modal
