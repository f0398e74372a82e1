"""Several bodies in one call: they broadcast with the speeds; what cannot be in one list."""

import numpy as np
import pytest

import stoss

BALL = stoss.Sphere(poisson=0.3)
STEEL = stoss.materials["structural steel"]


def test_several_spheres_broadcast_with_the_speeds(tmp_path, closed):
    balls = [[stoss.Sphere(poisson=nu)] for nu in (0.3, 0.0, 0.3)]
    many = stoss.restitution(balls, speed=[0.05, 0.2], tolerance=0.01)
    assert many.restitution.shape == (3, 2) and many.poisson[:, 0].tolist() == [0.3, 0.0, 0.3]
    assert many.body is None and many.bodies == (stoss.Sphere(poisson=0.3), stoss.Sphere(poisson=0.0))
    for i, j in np.ndindex(3, 2):
        alone = stoss.restitution(balls[i][0], speed=many.speed[i, j], tolerance=0.01)
        assert alone.restitution == many.restitution[i, j] and alone.max_force_error == many.max_force_error[i, j]
    assert repr(many).startswith("Restitution(6 values, 2 spheres, poisson=0 to 0.3, speed=0.05 to 0.2 c: ")
    many.to_csv(tmp_path / "many.csv")
    text = (tmp_path / "many.csv").read_text(encoding="utf-8")
    assert "max_force[mc^2/R]" in text and "# bodies: (Sphere(poisson=0.3), Sphere(poisson=0))" in text
    pairs = stoss.restitution(np.array(balls, dtype=object), speed=0.1, against="same", tolerance=0.01)
    assert pairs.restitution[2, 0] == pytest.approx(many.restitution[0, 0], abs=1e-11) and pairs.against == "same"
    sizes = stoss.restitution([stoss.Sphere(poisson=0.3, radius=r) for r in (1, 2)], speed=0.1, tolerance=0.01,
                              against=stoss.Sphere(poisson=0.3, radius=2))  # fmt: skip
    assert sizes.restitution[1] == pytest.approx(pairs.restitution[0, 0], abs=1e-11)
    assert abs(sizes.restitution[0] - sizes.restitution[1]) > 1e-3
    assert stoss.restitution([stoss.Disk(poisson=0.3)], speed=0.1).restitution.tolist() == [
        stoss.restitution(poisson=0.3, speed=0.1).restitution
    ]
    axes = many.plot()
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["ν = 0", "ν = 0.3"]


@pytest.mark.parametrize(
    "bodies, said",
    [
        ([], r"\[\], allowed one body, or a list"),
        ([BALL, stoss.Disk(poisson=0.3)], r"Disk\(poisson=0.3\), allowed one kind of bodies"),
        ([stoss.Rod()], r"Rod\(\), allowed a stoss.Disk or a stoss.Sphere"),
        ([[BALL], 3], "allowed a stoss.Disk or a stoss.Sphere"),
        (np.array([0.3]), "0.3, allowed a stoss.Disk or a stoss.Sphere"),
        ([stoss.Sphere(radius=0.01, material=STEEL)], "allowed bodies without a material in a list"),
    ],
)
def test_refusals_of_several(bodies, said):
    with pytest.raises(stoss.InvalidInput, match=f"^body: got .*{said}"):
        stoss.restitution(bodies, speed=0.1)
