#pragma once

/// What docs/developer/validation.md says around its tables of bodies by their modes at a point.
namespace validate::text {

inline constexpr const char* modal_tally = R"(
## Bodies by their modes at a point

Spheres given by their modes at a point ([theory](derivations/any_body.md)), judged at the default
tolerance by the spheres themselves, `validate/data/reference_modal.csv`. Columns as
[above](#errors-against-true-errors). The error of such a body holds what its numbers do not tell:
where they have errors, and where its surface departs from the sphere of its curvature, the true
error comes from there, and of *exact* numbers *of true spheres* from the runs alone. All together
must meet conditions 1 to 3.

| bodies | quantity | points | within | strictly | maximum | error / true error | blurred |
|---|---|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* modal_points = R"(
All at the default tolerance. ω up to which modes are given, whether with χ; by how much the surface
is flatter, in H³r⁴; whether the numbers have errors; what is met, its radius or thickness; *ratio*
as [below](#all-points-at-the-default-tolerance); cutoff in c/R.

| ν | ω | | flatter | errors | against | size | v | 1−ε², reference | uncertainty | 1−ε² | error | ratio | cutoff |
|---:|---:|---|---:|---|---|---:|---:|---:|---:|---:|---:|---:|---:|
)";

}  // namespace validate::text
