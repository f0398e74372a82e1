"""Several bodies in one call: they broadcast with the speeds, and what they meet is like each of them."""

import numpy as np
import pytest
import stoss

BALL = stoss.Sphere(poisson=0.3)


@pytest.mark.parametrize("first, made, against", [
    (stoss.Disk, stoss.HalfPlane, stoss.HalfPlane(young=2.0)), (stoss.Sphere, stoss.HalfSpace, stoss.HalfSpace(young=2.0)),
])  # fmt: skip
def test_what_they_meet_has_the_poisson_number_of_each(first, made, against):
    bodies = [first(poisson=poisson) for poisson in (0.2, 0.3)]
    curve = stoss.restitution(bodies, against=against, speed=0.1, tolerance=0.01)
    assert curve.against == against
    for body, lost in zip(bodies, curve.lost_fraction):
        one = stoss.restitution(body, against=made(poisson=body.poisson, young=2.0), speed=0.1, tolerance=0.01)
        assert one.lost_fraction == lost


def test_same_of_many_poisson_numbers():
    many = stoss.restitution(poisson=[[0.2], [0.5]], against="same", speed=[0.1, 0.2], tolerance=1e-2)
    assert many.against == "same" and many.body is None and "against 'same'" in repr(many)
    for i, nu in enumerate((0.2, 0.5)):
        disk = stoss.Disk(poisson=nu)
        alone = stoss.restitution(disk, against=disk, speed=0.2, tolerance=1e-2)
        assert many.restitution[i, 1] == alone.restitution and alone.against == disk


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


def test_absolute_is_the_companion_of_tolerance():
    coarse, fine = (stoss.restitution(BALL, speed=1e-3, absolute=each) for each in (1e-4, 0.0))
    assert (coarse.absolute, fine.absolute, stoss.restitution(BALL, speed=0.1).absolute) == (1e-4, 0.0, 1e-6)
    assert coarse.converged and coarse.lost_fraction_error <= 1e-4 and coarse.cutoff < fine.cutoff
    assert fine.lost_fraction_error <= 1e-3 * fine.lost_fraction
    assert fine.to_dict()["absolute"] == 0.0 and "absolute" in fine._inputs()
