"""Series in time as files that seismic programs read: CSV, NPZ, two columns, SAC and miniSEED."""

from __future__ import annotations

import os
from typing import Any, ClassVar

import numpy as np

from stoss._arguments import choice, refusal
from stoss._documentation import documented
from stoss._errors import InvalidInput
from stoss.export._files import whole_file, write_lines
from stoss.results._result import Result

CHANNELS = {"force": "XYF", "normal": "XYZ", "radial": "XYR", "normal_velocity": "XVZ", "radial_velocity": "XVR"}
"""Names of channels of three letters: no others are allowed in these files."""

ENDINGS = (".csv", ".npz", ".txt", ".sac", ".mseed")


class Waveforms(Result):
    """A result whose columns run in time, evenly spaced."""

    _traces: ClassVar[tuple[str, ...]] = ()  # what seismic files have of it, the first by itself

    @documented
    def write(self, path: str | os.PathLike[str], trace: str | None = None) -> None:
        """Write a file in the format that its name ends with: .csv, .npz, .txt, .sac or .mseed.

        CSV is that of `to_csv`; NPZ has all columns as arrays. The others are in SI and need a
        material: two columns of time and one trace (.txt), as seismic codes take the force as a source
        time function; SAC with one trace, miniSEED with all, by obspy, which must be installed. The file
        appears whole or not at all.

        Parameters:
            trace (str, optional): Which one, of `force`, or of `normal`, `radial`, `normal_velocity` and
                `radial_velocity`. Default: the first.

        Examples:
            >>> ball = stoss.Sphere(radius=1.5e-3, material=stoss.materials["bearing steel"])
            >>> stoss.pulse(ball, speed=0.5).write("source.txt")
            >>> np.loadtxt("source.txt").shape
            (400, 2)
        """
        name = os.fspath(path)
        ending = os.path.splitext(name)[1].lower()
        if ending not in ENDINGS:
            raise refusal("path", name, f"a name that ends with {', '.join(ENDINGS[:-1])} or {ENDINGS[-1]}")
        chosen = self._traces[0] if trace is None else choice("trace", trace, self._traces)
        if ending == ".csv":
            return self.to_csv(path)
        if ending == ".npz":
            with whole_file(name, ".npz") as temporary:
                np.savez(temporary, **self._columns())
            return None
        if getattr(self, "material", None) is None:
            hint = "without a material there is no SI"
            raise InvalidInput.out_of_range("path", repr(name), "a .csv or an .npz", hint)
        if ending == ".txt":
            rows = zip(self._in_si_of("time").tolist(), self._in_si_of(chosen).tolist())
            return write_lines(path, (f"{time:.17g} {value:.17g}\n" for time, value in rows))
        self._write_stream(name, ending, [chosen] if ending == ".sac" else list(self._traces))
        return None

    def _in_si_of(self, name: str) -> Any:
        return getattr(self, f"{name}_si")

    def _write_stream(self, name: str, ending: str, traces: list[str]) -> None:
        try:
            from obspy import Stream, Trace, UTCDateTime
        except ModuleNotFoundError:
            raise InvalidInput.out_of_range(
                "path", repr(name), "a .csv, an .npz or a .txt", f"a {ending} needs obspy: pip install obspy"
            ) from None
        time = self._in_si_of("time")
        step = float(time[-1] - time[0]) / (time.size - 1)
        stream = Stream()
        for each in traces:
            header = {"delta": step, "channel": CHANNELS[each], "station": "STOSS",
                      "starttime": UTCDateTime(0) + float(time[0])}  # fmt: skip
            stream.append(Trace(np.array(self._in_si_of(each), dtype=np.float64), header))
        with whole_file(name, ending) as temporary:
            stream.write(temporary, format="SAC" if ending == ".sac" else "MSEED")
