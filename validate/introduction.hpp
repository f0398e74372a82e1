#pragma once

/// What docs/developer/validation.md says of its references and of what is promised.
namespace validate::text {

inline constexpr const char* introduction = R"(# Validation: do the errors hold?

Written by `make validate`; do not edit by hand, edit `validate/introduction.hpp` and
`validate/text.hpp`. For users, [one page](../understand/accuracy.md) sums it up; its picture and
its CSV file follow from the tables below (`validate/scatter.py`).

`restitution` gives every value with an estimated error ([numerics.md](numerics.md) §5). Three
conditions are tested for the error of 1 − ε²:

1. in at least 95 % of all points the true error is within the estimated one,
2. in all points it is within three times the estimated one,
3. the estimated error is not padded: in the median it is at most ten times the true one.

The program exits with code 1 if one of the three fails at any tolerance on any of the sets.
`tests/restitution/test_validation_sample.cpp` repeats it on a sample.

## The references

`validate/data/reference.csv`: 90 points, ten Poisson's ratios from −0.9 to 0.98, nine speeds each,
all speeds different and evenly spaced from 10⁻⁶ c to 0.5 c on the logarithmic scale. At each point
three impacts with cutoffs 200, 283 and 400 (`restitution` typically ends at the cutoffs in the
table of times), whose step and node spacing differ by other ratios than the cutoff. The reference
is the last; its uncertainty is the spread of the three: for 1 − ε² in the median 2·10⁻⁶ of the
value and at most 4·10⁻⁵, except for one point (ν = 0.07, v = 0.5) with 2·10⁻⁴. `stoss_validate
--make-reference FILE` makes the file anew. The constants of the error were chosen on these points.

`validate/data/reference_unseen.csv`: 64 points with references of the same kind, spread by a
quasi-random sequence over −0.93 < ν < 0.99 and 10⁻⁶ < v < 0.5. No constant was fitted to them; but
their results were visible while the constants of the other quantities and of fast impacts were
chosen on other points. Once all constants were fixed, 64 others of the same range were drawn and
judged once, by single impacts at the cutoff 320: 100, 100 and 98 % lay within the error at 10⁻²,
10⁻³ and 10⁻⁴, the worst at 1.7 times its error. `stoss_validate --make-unseen-reference FILE` makes
the file anew.

`tests/data/restitution_hard_wall.csv`: 15 points from cutoffs up to 100 and a coarser scheme in
time, with uncertainties of 2·10⁻⁵ and more.

`validate/data/reference_pairs.csv`: 48 pairs of unequal disks, spread by a quasi-random sequence:
Poisson's ratios from −0.6 to 0.9, radii within a factor of 4, moduli and densities within 2,
relative speeds from 10⁻⁵ c to 0.4 c. Three impacts as above, with cutoffs 100, 141 and 200 over the
time scale of the pair. `stoss_validate --make-pair-reference FILE` makes the file anew.

`validate/data/reference_spheres.csv`: 64 spheres, spread by a quasi-random sequence over −0.5 < ν <
0.49 and 10⁻⁶ < v < 0.5. Three impacts as above, with cutoffs 80, 113 and 160. They are judged with
`absolute` = 0: by default an error of 10⁻⁶ suffices for the 1 − ε² of a sphere. `stoss_validate
--make-sphere-reference FILE` makes the file anew.

`validate/data/reference_hollow.csv`: 48 hollow spheres, spread by a quasi-random sequence over
shells of 0.5 to 0.03 R, 0 < ν < 0.47 and 10⁻⁵ < v < 0.05. Three impacts as above, with cutoffs 113,
160 and 226. Judged with `absolute` = 0; no constant was fitted to them. `stoss_validate
--make-hollow-reference FILE` makes the file anew.

`validate/data/reference_half_spaces.csv`: 48 impacts of spheres on half-spaces and, every fourth,
of disks on half-planes, every fifth with a rigid body, spread by a quasi-random sequence: Poisson's
ratios from −0.4 to 0.48, modulus and density of the half-space from 0.01 to 100 and from 0.1 to 10,
speeds from 10⁻⁶ to 0.5 in c of the body or of the half-space, whichever is less. Three impacts as
above, with cutoffs 12, 17 and 24 over the time scale of the contact, and half-spaces for contacts a
fifth longer than those of `restitution`. `stoss_validate --make-half-space-reference FILE` makes
the file anew.

`validate/data/reference_lossy.csv`: 48 impacts of lossy spheres and disks, every third one at
another lossy body with a loss time of its own, spread by a quasi-random sequence: loss times from
10⁻⁴ to 100 R/c, speeds from 10⁻⁸ c to 0.3 c, Poisson's ratios from −0.4 to 0.48, radii within a
factor of 3. Three impacts as above, with cutoffs 80, 113 and 160, from 128 nodes to 2.4 times those
of `restitution`. Judged with `absolute` = 0. `stoss_validate --make-lossy-reference FILE` makes the
file anew.

`validate/data/reference_relaxing.csv`: 72 impacts of spheres and disks of materials that relax, at
the wall, every third one at another body and every fourth on a half-space, of which two in three
relax too, spread by a quasi-random sequence: one to five terms with 10⁻⁴ to 95 % of the modulus in
sum, times from 10⁻³ to 10³ R/c, Poisson's ratios from −0.4 to 0.48, speeds from 10⁻⁷ c to 0.3 c.
Three impacts as above, with cutoffs 80, 113 and 160, on half-spaces 12, 17 and 24, from 128 nodes
to 2.4 times those of `restitution`. Judged with `absolute` = 0. Two constants of the error were
chosen on nine other spectra; of the shares that stay, one was then lowered so that errors are not
padded. `stoss_validate --make-relaxing-reference FILE` makes the file anew.

`validate/data/reference_faces.csv`: 80 impacts of spheres and disks with rough or coated faces, in
turn at the wall, on half-spaces, at an equal body, at another and at an exponential wall, spread by
a quasi-random sequence: u₀ from 10⁻³ to 3 of the compression of smooth faces; coats of 5 to 30 % of
the half-width, which give way as the bodies do over 0.03 to 10 half-widths, half of them with a
quality from 6 to 200; 40 rough, 16 coated, 24 both. Every seventh body relaxes, every fourteenth is
lossy; Poisson's ratios from −0.2 to 0.48, speeds from 10⁻⁶ c to 0.3 c. Three impacts as above, with
cutoffs 80, 113 and 160, on half-spaces 12, 17 and 24, and less in proportion where asperities are
longer than the way in two units of time, from 128 nodes to 2.4 times those of `restitution`. Judged
with `absolute` = 10⁻⁹: long asperities leave nothing of the ringing. No constant was fitted to
them. `stoss_validate --make-face-reference FILE` makes the file anew.

`validate/data/reference_vibrating.csv`: 112 impacts of disks and spheres that vibrate, in turn at
the wall and in pairs, spread by a quasi-random sequence: Poisson's ratios from −0.5 to 0.9 and from
0 to 0.45, speeds from 10⁻³ c to 0.3 c, radii and moduli within a factor of 2; temperatures from
10⁻³ to 1, up to frequencies from 4 to 20 c/R: together the modes have 0.01 to 400 times the energy
of the translation. Each is one sample of its ensemble. Three impacts as above, with cutoffs 80, 113
and 160 over the time scale of the contact. Here the tolerance is the error of 1 − ε² itself, which
may be 0 when bodies vibrate. No constant was fitted to them. `stoss_validate
--make-vibrating-reference FILE` makes the file anew.

`validate/data/reference_oblique.csv`: 70 oblique impacts with friction, ten each of disks at the
wall, unequal and equal disks, disks on half-planes, spheres at the wall, unequal spheres, and
spheres on half-spaces, spread by a quasi-random sequence: Poisson's ratios from −0.4 to 0.8 and
from −0.2 to 0.45, v from 10⁻⁴ to 0.3, μ from 0.02 to 2 or 0.7 of the bound above which sliding is
unstable, x = s/μv from 0.1 to 8, radius and modulus of the second body within a factor of 3; every
third slides by its spin, every eighth is lossy. Three impacts as above, with cutoffs up to 181 at
the wall, 128 of pairs, 48 on half-planes and 64 and 16 of spheres over the time scale of the
contact, and up to 96 points, of spheres 144. Their spread is in the median 2·10⁻⁵ of the larger one
of |s| and μ v, and at most 4·10⁻³. No constant was fitted to them: those of the errors come from
111 other impacts; but the results of these were visible while the last ones were chosen there. Once
all were fixed, 60 others were drawn at random (disks and spheres at walls and in unequal pairs,
disks on half-planes, disks with at most half of the friction that slides stably) and judged once,
by two finer impacts each: s′ lay within its error in all, at both tolerances, at most 0.7 times it
off and in the median a fifth of it; ε in 97 and 100 %, but one at 10⁻², a fast disk (v = 0.22), was
off by 7 times its error. The errors of ε of disks are larger by 1.4 or more than they were then.
`stoss_validate --make-oblique-reference FILE` makes the file anew.

`validate/data/reference_plates.csv`: 48 impacts of spheres on plates and, every fifth, of disks on
strips, every third with a rigid ball, spread by a quasi-random sequence: thickness from 0.05 to 50
R, Poisson's ratios of both from −0.2 to 0.49, modulus and density of the plate from 0.1 to 10,
speeds from 10⁻⁶ to 0.3 in c of the ball or of the plate, whichever is less; some plates of two or
three layers, some impacts lossy. Three impacts as above, with cutoffs 12, 17 and 24 over the time
scale of the contact, or less where a plate has more waves than are computed, and plates for
contacts 1.5, 1.2 and 1.35 times as long as those of `restitution`. Two more, disks that stay on
thin strips for longer than is computed, have no reference. No constant was fitted to them; but that
energy above the cutoff is no doubt about a body that stays was seen on them. After that 48 others
of the same range were drawn. Five disks on thin strips have no reference, nor has one rigid ball on
a very thin lossy plate (h = 0.06 R, v = 0.08), whose impacts take minutes; at the 42 others all
values lie within their errors, at most 0.76 times off. `stoss_validate --make-plate-reference FILE`
makes the file anew. Two constants of the error were then chosen on 60 others
([numerics.md](numerics.md) §14).

`validate/data/reference_plates_unseen.csv`: 96 more, drawn at random with a seed: every fifth a
disk on a strip, four of ten bodies rigid, three of ten plates with two or three layers, from 0.1 to
30 R, every fifth impact lossy, speeds as above. No constant was fitted to them: they were drawn and
judged once when all constants were fixed; those of the force had been chosen on the 46 above and on
129 others. Three impacts with cutoffs 24, 34 and 48, or 24 and 34 where the last takes long, and
plates for 1.2, 1.35 and 1.1 times as long a contact. Left out are those that stay for longer than
is computed, and those of more than three seconds of processor time. `stoss_validate
--make-unseen-plate-reference FILE` makes the file anew.

`validate/data/reference_modal.csv`: spheres that are given by their modes at a point, 64 spread by
a quasi-random sequence: Poisson's ratios from 0 to 0.47, speeds from 10⁻⁶ to 0.03, modes up to 4 to
20 c/R, of every third without χ; at the wall, at spheres, on half-spaces and plates, and at their
like, moduli and densities of these within a factor of 10. Half are ground near the point, flatter
or steeper by −⅛ to ¼ of H³r⁴, which nothing that is given tells; four of ten are given with errors
as finite elements have them, and are off by any part of them. Reference: the sphere itself, to 10⁻⁴
of 1 − ε². No constant was fitted to them. `stoss_validate --make-modal-reference FILE` makes the
file anew. Of another 300 impacts of true spheres with exact numbers, each with up to eight numbers
of modes, 98.6 % at walls, 98.3 % in pairs and 98.8 % on half-spaces lie within the error of 1 − ε²,
which is 7 to 9 times the true one in the median; the others are off by up to 2.1 times their error.

The references of disks were computed twice, before and after the contact law of
[numerics.md](numerics.md) §3 took the place of plain complementarity, with other numbers of nodes,
another phase of the first touch and without any correction. 1 − ε² agrees to 2·10⁻⁶ in the median
at the wall and to 7·10⁻⁷ for pairs, and within the sum of both uncertainties at 84 of the 90 and 48
of the 48 points; the other six are off by at most 3.3 times that sum, 8·10⁻⁶ of the value.

These references share the equations and the modes with the values that they judge: they show the
effect of limited resolution. The finite elements and the rod below show that the method has the
right limit.
)";

}  // namespace validate::text
