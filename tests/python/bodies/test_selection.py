"""An impact with some of the modes only, and the energy of each mode in time."""

import pickle

import numpy as np
import pytest

import stoss

SOFT = stoss.ExponentialWall(hardness=100)
COMMON = {"poisson": 0.33, "speed": 0.1, "cutoff": 12, "against": SOFT}


@pytest.fixture(scope="module")
def whole():
    return stoss.impact(**COMMON)


@pytest.fixture(scope="module")
def keep(whole):
    """The forty most energetic."""
    average = whole.mode_energies["average"]
    return average >= np.sort(average)[-40]


@pytest.fixture(scope="module")
def some(keep):
    return stoss.impact(**COMMON, keep=keep)


def test_all_is_no_selection_bit_for_bit(whole):
    same = stoss.impact(**COMMON, keep=np.ones(whole.modes, dtype=bool))
    assert same.restitution == whole.restitution and same.steps == whole.steps
    assert np.array_equal(same.mode_energies, whole.mode_energies)
    assert np.array_equal(same.trajectory().force, whole.trajectory().force)


def test_only_the_chosen_modes_have_energies(whole, some, keep):
    assert some.modes == len(some.mode_energies) == 40 and some.cutoff == whole.cutoff
    for name in ("order", "index", "omega"):
        assert np.array_equal(some.mode_energies[name], whole.mode_energies[name][keep])
    assert some.restitution != whole.restitution
    assert some.mode_energies["after"].sum() == pytest.approx(some.vibration, rel=1e-12)
    assert abs(some.energy_error) < 1e-8
    # The strongest modes do not change much when the weak ones are left out.
    assert some.mode_energies["average"] == pytest.approx(whole.mode_energies["average"][keep], rel=0.1, abs=5e-4)


def test_the_selection_goes_with_the_result(some, keep):
    assert np.array_equal(some.keep, keep) and not some.keep.flags.writeable
    keep_again = keep.copy()
    given = stoss.impact(**COMMON, keep=keep_again)
    keep_again[:] = False
    assert np.array_equal(given.keep, keep)
    path = some.trajectory()
    assert -path.velocity[-1] / path.velocity[0] == pytest.approx(some.restitution, rel=1e-12)
    assert np.isfinite(some.field(time=2.0, radius=[0.5, 1.0], angle=[0.0]).x).all()
    twin = pickle.loads(pickle.dumps(some))
    assert np.array_equal(twin.mode_energies, some.mode_energies) and np.array_equal(twin.keep, keep)
    assert twin.restitution == some.restitution


def test_it_is_told(some, whole, keep, tmp_path):
    assert some.to_dict()["keep"] == keep.tolist() and "keep" not in whole.to_dict()
    some.to_csv(tmp_path / "some.csv")
    assert f"# keep: 40 of {keep.size} modes" in (tmp_path / "some.csv").read_text(encoding="utf-8").splitlines()
    whole.to_csv(tmp_path / "whole.csv")
    assert "keep" not in (tmp_path / "whole.csv").read_text(encoding="utf-8")


def test_a_rod_may_be_chosen_from_too():
    rod = stoss.impact(stoss.Rod(), speed=0.1, cutoff=50, against=SOFT, keep=np.arange(15) < 9)
    assert rod.modes == 9 and rod.trajectory().force.max() > 0


@pytest.mark.parametrize(
    "keep", [True, [], [0, 1], "all", [[True]], np.ones((2, 2), dtype=bool), [True, None], object()]
)
def test_what_is_no_list_of_flags_is_refused(keep):
    with pytest.raises(stoss.InvalidInput, match="^keep: got .*allowed a one-dimensional array of True and False"):
        stoss.impact(**COMMON, keep=keep)


def test_flags_that_do_not_fit_are_refused(whole):
    for flags in (np.ones(whole.modes + 1, dtype=bool), np.ones(3, dtype=bool), np.zeros(whole.modes, dtype=bool)):
        with pytest.raises(stoss.InvalidInput, match=f"^keep: got .*allowed 1 to {whole.modes} of the {whole.modes}"):
            stoss.impact(**COMMON, keep=flags)


@pytest.mark.parametrize("tail", ["radiating", "static"])
def test_a_hard_wall_refuses_any_selection(whole, tail):
    for flags in (np.ones(whole.modes, dtype=bool), np.arange(whole.modes) < 9):
        with pytest.raises(stoss.InvalidInput, match="^keep: .*HardWall.*ExponentialWall"):
            stoss.impact(**(COMMON | {"against": stoss.HardWall()}), tail=tail, keep=flags)


def test_energies_in_time_are_those_of_the_trajectory(some):
    path = some.trajectory(every=50)
    energies = some.energies_at(time=path.time)
    assert energies.shape == (len(path), some.modes) and not energies.flags.writeable
    assert energies.dtype.names == ("body", "order", "index", "omega", "energy")
    assert energies["energy"].sum(axis=1) == pytest.approx(path.vibration, abs=1e-12)
    for name in ("order", "index", "omega"):
        assert np.array_equal(energies[name][0], some.mode_energies[name])
    # Before the impact nothing vibrates, after it the energies stay.
    assert energies["energy"][0].max() < 1e-10
    late = some.energies_at(time=[path.time[-1], path.time[-1] + 100])
    assert late["energy"] == pytest.approx(np.tile(some.mode_energies["after"], (2, 1)), abs=1e-12)


def test_energies_take_times_of_any_shape_and_order(whole):
    times = np.array([[3.0, 1.0], [2.0, 3.0]])
    energies = whole.energies_at(time=times)
    assert energies.shape == (2, 2, whole.modes)
    for at in np.ndindex(2, 2):
        one = whole.energies_at(time=times[at])
        assert one.shape == (whole.modes,) and np.array_equal(one, energies[at])
    assert np.array_equal(energies[0, 0], energies[1, 1])
    assert whole.energies_at(time=[]).shape == (0, whole.modes)


@pytest.mark.parametrize("time", [np.nan, 1e9, "now", None, [1, "2"]])
def test_times_that_are_none_are_refused(whole, time):
    with pytest.raises(stoss.InvalidInput, match="^time: got"):
        whole.energies_at(time=time)


def test_energies_of_a_hard_wall_and_of_a_rod(hit):
    path = hit.trajectory()
    middle = len(path) // 2
    assert hit.energies_at(time=path.time[middle])["energy"].sum() == pytest.approx(path.vibration[middle], abs=1e-12)
    rod = stoss.impact(stoss.Rod(), speed=0.1, cutoff=50)
    assert rod.energies_at(time=1.0)["energy"].sum() > 0.9  # in the middle of its contact a rod stands still
