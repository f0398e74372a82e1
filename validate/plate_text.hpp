#pragma once

/// What docs/developer/validation.md says around its tables of balls on plates.
namespace validate::text {

inline constexpr const char* plate_tally = R"(
## Balls on plates

Balls on plates and disks on strips, judged in the same way at the default tolerance, 10⁻³ of 1 − ε²
or 10⁻⁶, by `validate/data/reference_plates.csv`, and the finite elements
[below](#finite-elements-of-balls-on-plates). A ball that stays is right where 1 − ε² of the
reference is within its error. Columns as [above](#errors-against-true-errors). They must meet
conditions 1 to 3. Nearly all have converged at the lowest three cutoffs.

| bodies | quantity | points | within | strictly | maximum | error / true error | blurred |
|---|---|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* unseen_plate_tally = R"(
To `validate/data/reference_plates_unseen.csv` no constant was fitted, and its references are finer.
The one force that is off by more than twice its error is that of a ball that stays on a thin plate,
whose peak no run below the cutoff 24 shows:

| bodies | quantity | points | within | strictly | maximum | error / true error | blurred |
|---|---|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* plate_times = R"(
## Times of balls on plates

At the default tolerance. Processor time of one call, where the modes are there: median, what nine
of ten do not exceed, longest; and of the first call, which makes them: median, longest.

| speed | converged | ms, median | ms, 90 % | ms, longest | first: ms, median | ms, longest |
|---|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* plate_points = R"(
All at the default tolerance. ν and η of the ball; of each layer of the plate, downwards, h:ν:E:ρ,
in units of the ball; η of the plate; *ratio* as [below](#all-points-at-the-default-tolerance);
cutoff over the time scale of the contact.

| body | ν | η | layers | η₂ | v | 1−ε², reference | uncertainty | 1−ε² | error | ratio | cutoff |
|---|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* unseen_plate_points = R"(
Those to which no constant was fitted:

| body | ν | η | layers | η₂ | v | 1−ε², reference | uncertainty | 1−ε² | error | ratio | cutoff |
|---|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|
)";

inline constexpr const char* plate_elements = R"(
### Finite elements of balls on plates

Of degree 6 and 8, with ball and plate both meshed and a plate wider than its waves get; made apart
from stoss (`tests/data/plate_restitution.csv`).

| body | ν | η | layers | η₂ | v | 1−ε², finite elements | uncertainty | 1−ε² | error | ratio | cutoff |
|---|---:|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|
)";

}  // namespace validate::text
