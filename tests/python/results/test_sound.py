"""What is heard of an impact: partials with the energies of the ledger, and WAV files."""

import wave

import numpy as np
import pytest
import stoss

GLASS = stoss.Material(young=7e10, poisson=0.22, density=2500)
BALL = stoss.Sphere(radius=0.05, material=GLASS)


@pytest.fixture(scope="module")
def hit():
    return stoss.impact(BALL, speed=1.0, cutoff=4)


def test_its_power_is_that_of_the_ledger(hit):
    # Without decay the mean square is Σ u²E/m: of a mode of energy E the amplitude of the point is u √(2E/m).
    heard = hit.sound(duration=2.0, slower=200, quality=1e12)
    modes = stoss.modes(BALL, cutoff=4)
    at = {(n, k): u for n, k, u in zip(modes.order, modes.index, modes.radial)}
    ledger = hit.mode_energies
    share = sum(at[each["order"], each["index"]] ** 2 * each["after"] for each in ledger) / 2
    assert np.mean((heard.samples / 1.0) ** 2) == pytest.approx(share, rel=0.02)  # E as a share of ½mv²
    assert heard.samples.shape == heard.time.shape == (88200,) and heard.time[1] == 1 / (44100 * 200)


def test_it_goes_on_as_the_impact_ends(hit):
    # The vibration a little later is that of the replay: the same sum of energies, and the velocity of the point
    # that follows from the free motion of the modes.
    state = hit.state_after(flight=0.0)
    modes = stoss.modes(BALL, cutoff=4)
    at = {(n, k): (u, w) for n, k, u, w in zip(modes.order, modes.index, modes.radial, modes.omega)}
    heard = hit.sound(duration=0.2, slower=200, quality=1e12)
    time = heard.time / BALL.scales.time
    parted = hit.restitution * hit.speed * BALL.scales.speed
    path = hit.trajectory()
    # State and phases count from where the bodies would part unexcited; the sound begins at the end of the impact.
    delay = (path.center[-1] + 1.0) / (-hit.restitution * hit.speed)
    expected = sum(
        -u * np.sqrt(each["energy"]) * parted * np.sin(w * (time + delay) + each["phase"])
        for each in state for u, w in [at[each["order"], each["index"]]]
    )  # fmt: skip
    assert np.abs(heard.samples - expected).max() < 1e-6 * np.abs(expected).max()


def test_modes_decay(hit):
    heard = hit.sound(duration=1.0, slower=100, quality=50)
    lowest = stoss.modes(BALL, cutoff=4).omega.min() * BALL.scales.frequency
    early, late = (np.abs(heard.samples[part]).max() for part in (slice(0, 4410), slice(22050, 26460)))
    assert late < early * np.exp(-0.4 * lowest * heard.time[22050] / 50)
    lossy = stoss.Sphere(radius=0.05, material=GLASS, loss_time=2e-8)
    ring = stoss.impact(lossy, speed=1.0, cutoff=4).sound(duration=1.0, slower=100)
    rate = 0.5 * 2e-8 * lowest**2
    before, after = (np.abs(ring.samples[part]).max() for part in (slice(22050, 26460), slice(39690, 44100)))
    assert np.log(before / after) == pytest.approx(rate * (ring.time[39690] - ring.time[22050]), rel=0.15)


def test_a_wav_file_holds_it(hit, tmp_path):
    heard = hit.sound(duration=0.25, rate=8000, slower=50)
    heard.save(tmp_path / "ball.wav")
    with wave.open(str(tmp_path / "ball.wav")) as file:
        assert (file.getnchannels(), file.getsampwidth(), file.getframerate()) == (1, 2, 8000)
        written = np.frombuffer(file.readframes(file.getnframes()), dtype="<i2")
    assert np.abs(written).max() == 32767
    assert np.abs(written / 32767 - heard.samples / np.abs(heard.samples).max()).max() < 2e-5
    assert repr(heard) == "Sound(Sphere(poisson=0.22, radius=0.05 m), 0.25 s at 8000 Hz, 50 times slower)"


def test_either_body_is_heard():
    pair = stoss.impact(BALL, against=stoss.Sphere(radius=0.1, material=GLASS), speed=1.0, cutoff=4)
    first, second = (pair.sound(duration=0.2, slower=100, of=of) for of in (0, 1))
    assert np.abs(first.samples).max() > 0 and np.abs(second.samples).max() > 0 and "0.1 m" in repr(second)


@pytest.mark.parametrize(
    "given, line",
    [({"duration": 0}, "duration: got 0"), ({"rate": 10}, "rate: got 10"), ({"quality": 0.1}, "quality: got 0.1"),
     ({"of": 1}, "of: got 1, allowed 0"), ({"slower": -1}, "slower: got -1"),
     ({}, "slower: got 1.0, allowed a larger one")],
)  # fmt: skip
def test_refusals(given, line):
    small = stoss.impact(stoss.Sphere(radius=0.005, material=GLASS), speed=1.0, cutoff=4)
    with pytest.raises(stoss.InvalidInput) as refused:
        small.sound(**{"slower": 1000 if given else 1.0, **given})
    assert str(refused.value).startswith(line) and "\n" not in str(refused.value)


def test_without_a_material_there_are_no_hertz():
    with pytest.raises(stoss.InvalidInput, match="one with a material"):
        stoss.impact(poisson=0.33, speed=0.1, cutoff=12).sound()
    wall = stoss.ExponentialWall()
    chosen = stoss.impact(BALL, against=wall, speed=1.0, cutoff=4)
    some = np.arange(chosen.mode_energies.size) < 5
    with pytest.raises(stoss.InvalidInput, match="^keep: "):
        stoss.impact(BALL, against=wall, speed=1.0, cutoff=4, keep=some).sound(slower=100)
