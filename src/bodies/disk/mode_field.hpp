#pragma once

#include <span>
#include <vector>

#include "bodies/disk/static_field.hpp"
#include "stoss/bodies/disk/modes.hpp"

namespace stoss::bodies::disk {

/// Displacement and stress of a free vibration inside the disk. With the potentials β = A J_n(κr), β′ = B J_n(κ′r),
/// their slopes α = rβ_r = nβ − γ (paper eq. (19)), M = n(n−1) and y = κ′²r²/2,
///
///   r u_r = n(β + β′) − γ             (1+ν) r² σ_rr  =  M(β + β′) − yβ + γ − nγ′
///   r u_φ = γ′ − n(β + β′)            (1+ν) r² σ_rφ  = −M(β + β′) + yβ′ + nγ − γ′
///                                     (1+ν) r² σ_φφ  = −M(β + β′) − νyβ − γ + nγ′
///
/// where σ_rr + σ_φφ = div u/(1−ν), div u = −κ²β. The tractions are those of EdgeProblem with κr for κ. In this form
/// what is large for n ≫ κ′r occurs only in the one sum β + β′, and every term vanishes at the centre as the whole
/// does.
/// @param radii 0 … 1; the centre by its limit
/// @throws InvalidInput for a Poisson's ratio, a mode or a radius out of range
[[nodiscard]] std::vector<RadialField> mode_field(double poisson, const Mode& mode, std::span<const double> radii,
                                                  const Poll& poll);

}  // namespace stoss::bodies::disk
