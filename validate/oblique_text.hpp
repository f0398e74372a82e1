#pragma once

/// What docs/validation.md says around its tables of oblique impacts.
namespace validate::text {

inline constexpr const char* oblique_tally = R"(
## Oblique impacts

`oblique_restitution` states the errors of s′, and of ε of the motion along the normal. They are
judged in the same way by `validate/data/reference_oblique.csv`: that of ε_t is that of s′ over |s|.
The tolerance is the error of s′ over the larger one of |s| and μ v.

| tolerance | bodies | quantity | points | within | strictly | maximum | error / true error | blurred | conditions 1 to 3 |
|---:|---|---|---:|---:|---:|---:|---:|---:|---|
)";

inline constexpr const char* oblique_times = R"(
Processor time of one value, modes cached. *90 %*: nine of ten take no longer.

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
