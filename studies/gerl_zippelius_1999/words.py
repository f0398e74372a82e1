"""The text of the report around its items: introduction, method, verdict, errata, references.

Text in HTML.
"""

from __future__ import annotations

from gerl_zippelius_1999 import equations

PAPER = (
    "F. Gerl and A. Zippelius, <cite>Coefficient of restitution for elastic disks</cite>, Phys. Rev. E <b>59</b>, 2361 "
    "(1999)"
)
DOI = "https://doi.org/10.1103/PhysRevE.59.2361"

INTRODUCTION = """
<p>How much of its speed does an elastic disk keep when it hits a wall? Gerl and Zippelius computed it from first
principles: nothing is lost to friction or plastic flow, but part of the energy of translation stays behind as
vibration. This report computes their paper again, figure by figure, with <b>stoss</b>. It does not show the original
figures; what each of them contains is taken from its caption and from the text.</p>
<p>Every table has the same four columns. <b>Paper</b> is what the text prints, in quotation marks if it is words, and
with a note if it only follows from a formula or a table of the paper. <b>Protocol</b> is what the procedure of the
paper gives when carried out, with the slips in its equations of motion corrected and its law of compression as printed;
where the text leaves a choice open, the caption says what is taken. <b>Converged</b> is the
answer of the model itself, with all modes and, unless the quantity belongs to a soft wall, a hard wall. The estimated
error follows ±; for <i>ε</i> and 1 − <i>ε</i>² it covers the truth in 95 % of all cases. Where the three columns differ, none
has been adjusted to another. A dash means that there is no such number. Equations of the paper are cited
by their printed number, counted in its source.</p>
<p>Lengths are in units of the radius <i>R</i>, speeds in units of <i>c</i> = √(<i>E</i>/<i>ρ</i>), times in
<i>R</i>/<i>c</i>, forces in <i>πRE</i> = <i>mc</i>²/<i>R</i>. The speed <i>v</i> is that of one disk against a wall;
two equal disks that each move at <i>v</i> towards each other are the same problem.</p>
"""

METHOD = f"""
<p>The disk is a set of independent oscillators, its eigenmodes (<i>n</i>, <i>l</i>) with frequencies <i>ω</i> and
amplitudes <i>C</i> (radial) and <i>S</i> (tangential) at the edge. A point of the edge is at</p>
{equations.POSITION}
<p>(eq. 39), and the paper lets a wall at <i>x</i> = 0 repel it by an exponential potential (eq. 40, with the ½ that
missing there),</p>
{equations.HAMILTONIAN}
<p>which becomes hard as <i>α</i> → ∞. stoss solves the hard wall directly: the edge is never beyond the wall, the
pressure <i>p</i> never pulls, and one of the two is zero everywhere,</p>
{equations.HARD_WALL}
<p>with the modes above a cutoff represented by their exact static compliance and their radiation. After the
impact, the lost energy is that of the modes,</p>
{equations.LEDGER}
<p>The paper reaches the same limit by two extrapolations, in the hardness of the wall and in the number of modes:</p>
{equations.EXTRAPOLATIONS}
<p>The second converges slowly, because the contact is too stiff without the modes left out. For slow
impacts the force follows from the compression as in a contact at rest. For the approach of the centre of mass, which
the equation of motion needs, the law is</p>
{equations.CENTRE}
<p>whereas the paper prints, and uses, its eq. (56),</p>
{equations.PRINTED}
"""

VERDICT = """
<ul>
<li><b>Agrees:</b> the two limits of the paper lead to the converged loss (figure 8). Frequencies of the modes
(figures 2, 3), lines in 1/<i>α</i> (7), the quadrupole as the strongest mode (6) and contact times of slow impacts (11)
are confirmed.</li>
<li><b>Misprint or slip:</b> factors and signs in equations (E1–E7, E9, E10); the law for the diameter used for the
centre of mass (E8). The falling loss, “presumably unphysical”, is real (E11).</li>
<li><b>Open:</b> <i>ε</i> ≈ 0.65, where modes and finite elements give 0.7477 (E12); the energies of Table 1 (E13); the
75 % of modes with <i>n</i> = 0; the agreement at small compressions in figure 10.</li>
</ul>
"""

# Paper; correct; section of docs/developer/derivations/errata.md and its anchor there.
ERRATA = (
    ("The energy of a mode is written with <i>mω</i>²<i>Q</i>² (eqs. 40 and 61, the energy with a wall).",
     "½ <i>mω</i>²<i>Q</i>², as in the paper’s own eq. (34), the energy of a free disk.",
     "E1 Energy of a mode", "e1-energy-of-a-mode"),
    ("The force on a mode is <i>mωQ</i> + … (eqs. 41 and 63).",
     "<i>mω</i>²<i>Q</i> + …; <i>mωQ</i> is not a force.", "E2 Energy of a mode", "e1-energy-of-a-mode"),
    ("The energy left in the modes is (<i>m</i>/2) Σ&nbsp;<i>ω</i>|<i>q</i>|&NoBreak;² (eq. 67).",
     "(<i>m</i>/2) Σ <i>ω</i>²|<i>q</i>|².", "E3 Energy of a mode", "e1-energy-of-a-mode"),
    ("In eq. (26), the normalised displacement, <i>u<sub>φ</sub></i> has <i>κ</i> and <i>κ</i>′ exchanged.",
     "As in eq. (19), the displacement of a mode; with the exchange the modes are not orthogonal (figure 2).",
     "E4 Edge field", "e4-edge-field"),
    ("<i>σ<sub>rφ</sub></i> = <i>E</i>/(2(1+<i>ν</i>)) <i>ε<sub>rφ</sub></i> (eq. 16).",
     "<i>E</i>/(1+<i>ν</i>) with the paper’s <i>ε<sub>rφ</sub></i>, which is half of the shear angle.",
     "E5 Shear stress", "e5-shear-stress"),
    ("The motion of the complex amplitudes <i>q</i> has a sign reversed (eqs. 42, 43 and 64).",
     "With the printed sign the wall attracts the edge and an impact diverges.", "E6 Interaction picture",
     "e6-interaction-picture"),
    ("The compression of a heavy disk has −1 − <i>ν</i> in the bracket (eq. 56).",
     "The Poisson terms cancel: −1, for the shortening of the whole diameter.", "E7 Shortening of the diameter",
     "e7-shortening-of-the-diameter"),
    ("This shortening of the diameter is used in the equation of motion.",
     "The centre of mass approaches by another law, given above; the printed one is 8 % off in the compression at "
     "<i>δ</i> = 0.03 <i>R</i> for <i>ν</i> = 0.33, and 13 % for <i>ν</i> = 0.",
     "E8 Approach of the centre of mass", "e8-approach-of-the-centre-of-mass"),
    ("d<i>δ</i>/d<i>t</i> = −<i>v</i> (eq. 66); a tension <i>ρgR</i>; the sign of the dilatation <i>η</i> (eq. 17).",
     "+<i>v</i>; ½<i>ρgR</i>; −. None of them has consequences.", "E9–E10 Slips without consequence",
     "e9-slips-without-consequence"),
    ("“… the decreasing vibrational energy for <i>v</i><sub>i</sub> &gt; 10⁻² <i>c</i> is presumably unphysical.”",
     "A decrease is physical: 1 − <i>ε</i>² has a maximum near 0.003 <i>c</i> and a minimum near 0.017 <i>c</i> at "
     "<i>ν</i> = 0.33, a resonance between the contact time and the period of the quadrupole mode. First order "
     "misplaces it: to 0.0018 … 0.013 <i>c</i> with eq. (56), 0.007 … 0.05 <i>c</i> with eq. (57), its limit for "
     "small loads.",
     "E11 Minimum and maximum of the loss", "e11-minimum-and-maximum-of-the-loss"),
    ("<i>ε</i> ≈ 0.65 at <i>ν</i> = 0.9, <i>v</i> = 0.3 <i>c</i>.",
     "0.7477, by modes and by finite elements. Truncation to a handful of modes gives values like the printed one.",
     "E12 The value 0.65", "e12-the-value-065"),
    ("Table 1: after the impact (2,0) holds 0.0514, (3,0) 0.0235, (0,0) 0.0089, (4,0) 0.0039 of the energy.",
     "0.0341, 0.0133, 0.0062 and 0.0158 for <i>αR</i> = 500 and all modes. The printed ten add up to "
     "what all modes hold, by chance: the ten hold 0.076.",
     "E13 Table 1", "e13-table-1"),
)  # fmt: skip

REFERENCES = (
    f'{PAPER}. <a href="{DOI}">doi:10.1103/PhysRevE.59.2361</a>',
    "H. Hertz, <cite>Über die Berührung fester elastischer Körper</cite>, J. reine angew. Math. <b>92</b>, 156 (1882)",
    "Lord Rayleigh, <cite>On the production of vibrations by forces of relatively long duration, with application to "
    "the theory of collisions</cite>, Phil. Mag. <b>11</b>, 283 (1906)",
    "J. H. Michell, <cite>Elementary distributions of plane stress</cite>, Proc. London Math. Soc. "
    "<b>32</b>, 35 (1900)",
    "A. E. H. Love, <cite>A Treatise on the Mathematical Theory of Elasticity</cite>, Cambridge University Press "
    "(1927)",
    "K. L. Johnson, <cite>Contact Mechanics</cite>, Cambridge University Press (1985), chapters 4 and 5",
    "W. H. Wittrick and F. W. Williams, <cite>A general algorithm for computing natural frequencies of elastic "
    'structures</cite>, Q. J. Mech. Appl. Math. <b>24</b>, 263 (1971). '
    '<a href="https://doi.org/10.1093/qjmam/24.3.263">doi:10.1093/qjmam/24.3.263</a>',
)
