#pragma once

#include "cases.hpp"
#include "half_disk_mesh.hpp"

namespace bench {

/// The cheapest mesh for finite elements that reaches a relative tolerance of 1 − ε² at a speed, found with the true
/// value known. As errors of single meshes change their sign, it counts only if it, its like with the grading ± 0.05,
/// and the same three with an element more across (and perhaps a ring more) are all within the tolerance.
struct ElementCase {
  HardWallCase at;
  double tolerance;
  MeshSize mesh;
};
inline constexpr ElementCase element_cases[] = {
    // signed relative errors of the three, by grading                         with an element more
    {hard_wall_cases[1], 1e-2, {4, 2, 0.50}},   // +6.9e-3, +2.4e-3, -7.2e-3; +4.4e-3, +9.1e-3, +5.7e-3
    {hard_wall_cases[2], 1e-2, {2, 1, 0.25}},   // +1.3e-3, +1.3e-3, +9.9e-4; -1.5e-3, -8.0e-4, -1.4e-3
    {hard_wall_cases[3], 1e-2, {1, 1, 0.25}},   // +2.3e-3, +5.5e-3, +5.2e-3; -1.7e-4, -9.4e-3, +2.7e-4
    {hard_wall_cases[1], 1e-3, {10, 3, 0.45}},  // +6.8e-4, +8.6e-4, +7.5e-4; -2.7e-4, +3.5e-4, +7.1e-4
    {hard_wall_cases[2], 1e-3, {5, 2, 0.15}},   // +9.5e-4, -5.3e-4, -7.3e-4; -4.4e-4, +3.1e-4, +7.3e-4
    {hard_wall_cases[3], 1e-3, {5, 2, 0.10}},   // -9.4e-4, +2.1e-4, -9.2e-4; -1.5e-4, -7.8e-4, -7.1e-4
};

}  // namespace bench
