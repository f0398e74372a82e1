"""The C interface as languages see it that load a library at run time: main.py LIBRARY HEADER."""

import ctypes
import re
import sys
from pathlib import Path


class Control(ctypes.Structure):
    _fields_ = [("threads", ctypes.c_int), ("poll", ctypes.c_void_p), ("context", ctypes.c_void_p)]


class Estimate(ctypes.Structure):
    _fields_ = [("value", ctypes.c_double), ("error", ctypes.c_double)]


class Result(ctypes.Structure):
    _fields_ = [
        ("speed", ctypes.c_double),
        *((name, Estimate) for name in "restitution lost_fraction contact_time max_force max_compression".split()),
        ("converged", ctypes.c_int),
    ]


def main():
    library, header = ctypes.CDLL(sys.argv[1]), Path(sys.argv[2]).read_text(encoding="utf-8")
    declared = set(re.findall(r"\b(stoss_\w+)\(", header))
    assert len(declared) == 28, declared
    assert all(hasattr(library, name) for name in declared)  # visible in a shared library

    library.stoss_message.restype = library.stoss_version.restype = ctypes.c_char_p
    library.stoss_disk_make.argtypes = [ctypes.c_double] * 5 + [ctypes.c_void_p]
    library.stoss_curve.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_size_t, ctypes.c_double,
                                    ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
    for release in (library.stoss_body_free, library.stoss_contact_free):
        release.argtypes, release.restype = [ctypes.c_void_p], None

    body, contact = ctypes.c_void_p(), ctypes.c_void_p()
    assert library.stoss_disk_make(2.0, 1, 1, 1, 0, ctypes.byref(body)) == 1
    assert library.stoss_message().startswith(b"poisson: got 2, allowed -0.95 to 0.995")
    assert library.stoss_disk_make(0.33, 1, 1, 1, 0, ctypes.byref(body)) == 0
    assert library.stoss_wall_contact_make(body, ctypes.byref(contact)) == 0
    speeds, results = (ctypes.c_double * 2)(0.1, 0.05), (Result * 2)()
    assert library.stoss_curve(contact, speeds, 2, 1e-3, 1e-6, ctypes.byref(Control()), results) == 0
    assert [result.speed for result in results] == list(speeds) and results[1].converged == 1
    assert abs(results[0].restitution.value - 0.94704) < 5e-5
    library.stoss_contact_free(contact)
    library.stoss_body_free(body)

    library.stoss_hollow_sphere_make.argtypes = [ctypes.c_double] * 6 + [ctypes.c_void_p]
    assert library.stoss_hollow_sphere_make(0.3, 1.0, 1, 1, 1, 0, ctypes.byref(body)) == 1
    assert library.stoss_message().startswith(b"inner: got 1, allowed 0 to 0.99")
    assert library.stoss_hollow_sphere_make(0.3, 0.75, 1, 1, 1, 0, ctypes.byref(body)) == 0
    assert library.stoss_wall_contact_make(body, ctypes.byref(contact)) == 0
    assert library.stoss_curve(contact, (ctypes.c_double * 1)(0.01), 1, 1e-3, 1e-6, None, results) == 0
    assert abs(results[0].lost_fraction.value - 0.04199) < 5e-5  # docs/understand/findings/spheres.md
    library.stoss_contact_free(contact)
    library.stoss_body_free(body)
    print("stoss", library.stoss_version().decode(), "by ctypes")


main()
