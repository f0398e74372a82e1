#pragma once

/// What docs/developer/validation.md says around its tables of oblique impacts.
namespace validate::text {

inline constexpr const char* oblique_tally = R"(
## Oblique impacts

`oblique_restitution` states the errors of s′, and of ε of the motion along the normal. They are
judged in the same way by `validate/data/reference_oblique.csv`: that of ε_t is that of s′ over |s|.
The tolerance is the error of s′ over the larger one of |s| and μ v. All together must meet
conditions 1 and 2, and with s′ condition 3 at 10⁻². At 10⁻³ the references of disks with little
friction blur; where they are sharp the true error is small, and the stated one that of the contact
points. ε of spheres follows from the normal impacts of s′, with the error of central ones.

| tolerance | bodies | quantity | points | within | strictly | maximum | error / true error | blurred |
|---:|---|---|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* oblique_times = R"(
## Times of oblique impacts

Processor time of one of the impacts [below](#oblique-impacts), modes made before. *90 %*: nine of
ten take no longer.

| tolerance | bodies | converged | cutoff, median | ms, median | ms, 90 % | ms, longest |
|---:|---|---:|---:|---:|---:|---:|
)";

inline constexpr const char* oblique_points = R"(
All oblique impacts at the tolerance 10⁻³. ν of the first body, x = s/μv, with Ω where the body
spins instead of moving along; uncertainty and error over the larger one of |s| and μ v, *ratio* as
[below](#all-points-at-the-default-tolerance).

| body | against | ν | v | μ | x | ε_t, reference | uncertainty | ε_t | error | ratio | ε, reference | ε | error | ratio | cutoff |
|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|
)";

}  // namespace validate::text
