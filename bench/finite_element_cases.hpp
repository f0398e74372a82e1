#pragma once

#include "block_mesh.hpp"
#include "cases.hpp"
#include "half_disk_mesh.hpp"

namespace bench {

/// The cheapest mesh for finite elements that reaches a relative tolerance of 1 − ε² at a speed, found with the true
/// value known. As errors of single meshes change their sign, it counts only if it, its like with the grading ± 0.05,
/// and the same three with an element more across (and perhaps a ring more) are all within the tolerance.
struct ElementCase {
  ConvergedCase at;
  double tolerance;
  MeshSize mesh;
};
inline constexpr ElementCase disk_element_cases[] = {
    // signed relative errors of the three, by grading                         with an element more
    {hard_wall_cases[1], 1e-2, {4, 2, 0.50}},   // +6.9e-3, +2.4e-3, -7.2e-3; +4.4e-3, +9.1e-3, +5.7e-3
    {hard_wall_cases[2], 1e-2, {2, 1, 0.25}},   // +1.3e-3, +1.3e-3, +9.9e-4; -1.5e-3, -8.0e-4, -1.4e-3
    {hard_wall_cases[3], 1e-2, {1, 1, 0.25}},   // +2.3e-3, +5.5e-3, +5.2e-3; -1.7e-4, -9.4e-3, +2.7e-4
    {hard_wall_cases[1], 1e-3, {10, 3, 0.45}},  // +6.8e-4, +8.6e-4, +7.5e-4; -2.7e-4, +3.5e-4, +7.1e-4
    {hard_wall_cases[2], 1e-3, {5, 2, 0.15}},   // +9.5e-4, -5.3e-4, -7.3e-4; -4.4e-4, +3.1e-4, +7.3e-4
    {hard_wall_cases[3], 1e-3, {5, 2, 0.10}},   // -9.4e-4, +2.1e-4, -9.2e-4; -1.5e-4, -7.8e-4, -7.1e-4
};
inline constexpr ElementCase sphere_element_cases[] = {
    {sphere_cases[3], 1e-2, {9, 3, 0.75}},   // +2.6e-3, +9.5e-4, +2.8e-3; +7.1e-3, +6.5e-4, +7.1e-5
    {sphere_cases[1], 1e-2, {4, 1, 0.55}},   // +6.5e-4, +1.9e-3, +8.5e-3; +6.6e-3, +6.6e-3, +5.9e-3
    {sphere_cases[0], 1e-2, {5, 2, 0.45}},   // +6.1e-3, +2.4e-3, -7.9e-3; +3.1e-3, +5.7e-3, +3.1e-3
    {sphere_cases[1], 1e-3, {16, 4, 0.55}},  // +6.9e-4, +5.2e-4, -2.6e-4; +8.4e-4, +7.6e-5, +7.3e-4
    {sphere_cases[0], 1e-3, {16, 5, 0.45}},  // +1.3e-4, +6.6e-4, +9.2e-4; +4.2e-4, -3.3e-5, +1.7e-4
};

/// The same for a ball on a half-space.
struct BlockElementCase {
  ConvergedCase at;
  double tolerance;
  MeshSize mesh;
  BlockSize block;
};
inline constexpr BlockElementCase block_element_cases[] = {
    {half_space_cases[1], 1e-2, {2, 1, 0.60}, {0.25, 8.0}},  // +7.7e-3, +8.2e-3, +8.0e-3; +4.2e-3, +4.1e-3, +2.5e-3
    {half_space_cases[0], 1e-2, {2, 1, 0.15}, {0.55, 5.5}},  // +4.0e-3, +7.4e-3, +3.5e-3; +9.1e-4, +2.1e-3, +1.8e-3
    {half_space_cases[1], 1e-3, {7, 2, 0.50}, {0.25, 8.0}},  // +7.1e-4, +6.3e-4, +5.8e-4; +4.6e-4, +7.6e-4, +9.5e-4
    {half_space_cases[0], 1e-3, {4, 1, 0.25}, {0.55, 5.5}},  // +7.1e-4, +6.2e-4, +1.8e-4; +4.6e-4, +6.9e-4, +6.2e-4
};

}  // namespace bench
