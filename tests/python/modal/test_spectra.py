"""Modes of two meshes as one list."""

import numpy as np
import pytest

from stoss.modal._spectra import combined, groups, merged


def modes(f, moved, bent=None):
    bent = np.zeros(len(f)) if bent is None else np.array(bent)
    return {
        "frequency": np.array(f),
        "displacement": np.array(moved),
        "displacement_curvature": bent,
    }


def test_a_degenerate_pair_is_one_mode():
    """However a pair is turned, it moves the point by the same amount."""
    for angle in (0.0, 0.7, 2.0):
        share = np.array([np.cos(angle), np.sin(angle)])
        turned = modes([2.0, 2.0], 3 * share, 5 * share)
        one = combined(turned, [slice(0, 2)])
        assert one["frequency"] == pytest.approx([2.0])
        assert one["displacement"] == pytest.approx([3.0])
        assert one["displacement_curvature"] == pytest.approx([5.0])


def both_ways(f, moved, aside):
    still = np.zeros(len(f))
    along = {"tangential_displacement": np.array(aside), "tangential_displacement_curvature": still}
    return modes(f, moved) | along


@pytest.mark.parametrize("size, aside", [(3.0, 2.0), (2.0, 3.0), (1e-9, 2.0), (2.0, 1e-9)])
def test_with_a_tangent_a_degenerate_set_is_two_modes(size, aside):
    """However it is turned, one moves the point along the normal and the other along the tangent."""
    rng = np.random.default_rng(2)
    for _ in range(5):
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        two = combined(both_ways([2.0] * 3, size * turn[0], aside * turn[1]), [slice(0, 3)])
        assert two["cluster"].tolist() == [0, 0]
        assert two["frequency"] == pytest.approx([2.0, 2.0])
        assert np.abs(two["displacement"]) == pytest.approx([size, 0.0], abs=1e-12)
        assert np.abs(two["tangential_displacement"]) == pytest.approx([0.0, aside], abs=1e-12)


def test_motions_that_belong_together_stay_so():
    """What a set moves along both, and their product, are those of its combinations."""
    moved, aside = np.array([1.0, 2.0, 0.5]), np.array([0.7, -0.1, 0.4])
    two = combined(both_ways([2.0] * 3, moved, aside), [slice(0, 3)])
    normal, along = two["displacement"], two["tangential_displacement"]
    assert [normal @ normal, along @ along, normal @ along] == pytest.approx(
        [moved @ moved, aside @ aside, moved @ aside]
    )


def test_two_modes_of_a_set_rise_and_have_errors():
    fine = both_ways([1.0, 2.0, 2.0001], [1.0, 0.0, 3.0], [0.0, -2.0, 0.0])
    coarse = both_ways([1.0, 2.002, 2.003], [1.0, 0.0, 3.3], [0.0, 1.8, 0.0])
    both = merged(fine, coarse, 1.0)
    assert np.all(np.diff(both["frequency"]) >= 0.0) and "cluster" not in both
    assert np.abs(both["displacement"]) == pytest.approx([1.0, 0.0, 3.0])
    assert both["displacement_error"] == pytest.approx([0.0, 0.0, 0.3])
    assert both["tangential_displacement_error"] == pytest.approx([0.0, 0.2, 0.0])


def test_the_sign_of_a_mode_does_not_matter():
    one = combined(modes([1.0], [-2.0], [4.0]), [slice(0, 1)])
    assert one["displacement"] == [2.0] and one["displacement_curvature"] == [-4.0]


def test_modes_apart_stay_apart():
    assert groups(np.array([1.0, 1.01, 1.01001]), np.full(3, 1e-4)) == [slice(0, 1), slice(1, 3)]
    assert groups(np.array([1.0, 1.01]), np.full(2, 0.5)) == [slice(0, 1), slice(1, 2)]


def test_errors_are_differences():
    fine = modes([1.0, 2.0, 2.0005, 3.0, 4.0], [1.0, 0.6, -0.8, 0.0, 7.0])
    coarse = modes([1.01, 2.01, 2.02, 3.1], [1.1, 0.0, 1.2, 0.1])
    both = merged(fine, coarse, 1.0)
    assert both["frequency"] == pytest.approx([1.0, 2.00032, 3.0], rel=1e-6)
    assert both["frequency_error"] == pytest.approx([0.01, 0.0202, 0.1], abs=1e-4)
    assert both["displacement"] == pytest.approx([1.0, 1.0, 0.0])
    assert both["displacement_error"] == pytest.approx([0.1, 0.2, 0.1])
    assert both["complete_to"] == [3.0]


def test_frequencies_lie_between_their_bounds():
    """Of an error that falls with any order in between the true frequency is within the stated error."""
    least, most = 0.2, 0.7
    for share in (least, 0.45, most):
        true, fall = np.array([1.0, 2.0, 5.0]), np.array([1e-3, 3e-3, 1e-2])
        fine = modes(true + share * fall, [1.0, 1.0, 1.0])
        coarse = modes(true + (share + 1.0) * fall, [1.0, 1.0, 1.0])
        both = merged(fine, coarse, 1.04, (least, most))
        off = np.abs(both["frequency"] - true)
        assert np.all(off <= both["frequency_error"] * (1.0 + 1e-9))
        assert both["frequency_error"] == pytest.approx(0.25 * fall)
        assert both["complete_to"] == pytest.approx(both["frequency"][-1:])


def test_orders_make_the_bounds():
    body = pytest.importorskip("stoss.modal._body")
    for order in (2.75, 3.5, 5.0):
        coarse, fine = 1.4**order, 1.0
        share = fine / (coarse - fine)
        assert body.beyond(1.4, order) == pytest.approx(share)
        smooth = {"curved": True, "smooth": True}
        least, most = body.bounds(smooth, smooth, 1.4, 1.04)
        assert least <= share * (1.0 + 1e-12) and share <= most * (1.0 + 1e-12)
        assert body.bounds(smooth, {**smooth, "smooth": False}, 1.4, 1.04) == (0.0, 1.04)
        assert body.bounds({"curved": False}, smooth, 1.4, 1.04) == (-1.04, 1.04)


def test_modes_that_meshes_mix_are_one():
    """Two modes apart, of which each mesh makes two others: what they move together has small errors."""
    turned = [np.array([[np.cos(t), np.sin(t)], [-np.sin(t), np.cos(t)]]) @ [3.0, 4.0] for t in (0.1, 0.9)]
    fine = modes([1.0, 2.0, 2.01, 4.0], [1.0, *turned[0], 2.0])
    coarse = modes([1.03, 2.04, 2.06, 4.1], [1.0, *turned[1], 2.0])
    both = merged(fine, coarse, 1.0)
    assert both["displacement"] == pytest.approx([1.0, 5.0, 2.0])
    assert both["displacement_error"][1] < 0.25
    assert both["frequency_error"][1] > 0.01  # the distance between both is within
    assert 2.0 <= both["frequency"][1] <= 2.01
    # Those that are not mixed stay two, as near as they are.
    coarse = modes([1.03, 2.04, 2.06, 4.1], [1.0, *turned[0], 2.0])
    assert len(merged(fine, coarse, 1.0)["frequency"]) == 4


def test_one_mesh_has_no_errors():
    assert set(merged(modes([1.0], [1.0]), None, 1.0)) == {
        "frequency", "displacement", "displacement_curvature", "complete_to", "count"
    }  # fmt: skip
