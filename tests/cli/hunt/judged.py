"""Runs a call and says how it breaks the rule: it shows progress or ends soon, heeds Ctrl-C, and refuses at once."""

import os
import pty
import re
import signal
import subprocess
import time

SILENT = 5.0  # seconds of processor time in which it ends or shows progress,
ANSWER = 0.3  # in which it ends after Ctrl-C,
REFUSAL = 1.0  # in which it refuses
ENOUGH = 6.0  # after which it is interrupted
TICK = 0.05  # what the clock of /proc is coarse by


def _used(pid):
    """Its processor time, with all its threads; None when it has ended."""
    with open(f"/proc/{pid}/stat") as stat:
        words = stat.read().rpartition(")")[2].split()
    return None if words[0] == "Z" else (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def _defaults():
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def run(words, interrupt=None, patience=300):
    """Runs the command, with Ctrl-C after so much processor time or where it falls silent.

    Returns exit code, processor time, that since Ctrl-C or None, whether it was silent, and what a terminal got.
    """
    ours, its = pty.openpty()
    os.set_blocking(ours, False)
    process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=its,
                               preexec_fn=_defaults)
    os.close(its)
    rows = process.stdout.fileno()
    os.set_blocking(rows, False)
    written = False  # rows that come one by one are progress too
    text, signalled, silent, began = b"", None, False, time.monotonic()
    while True:
        used = _used(process.pid)
        try:
            text += os.read(ours, 65536)
        except OSError:
            pass
        try:
            written = bool(os.read(rows, 1 << 20)) or written
        except OSError:
            pass
        if used is None:
            break
        shown = written or b"\r[" in text or b" s, " in text
        late = used > SILENT and not shown
        if signalled is None and (late or used > (ENOUGH if interrupt is None else interrupt)):
            # What it has used by now, not when it was looked at.
            process.send_signal(signal.SIGINT)
            signalled = _used(process.pid) or used
            silent = late
        hangs = time.monotonic() - began > patience
        if hangs or (signalled is not None and used - signalled > 10 * ANSWER):
            process.kill()
        time.sleep(0.01)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    try:
        while more := os.read(ours, 65536):
            text += more
    except OSError:
        pass
    os.close(ours)
    process.stdout.close()
    used = usage.ru_utime + usage.ru_stime
    return process.returncode, used, None if signalled is None else used - signalled, silent, text.decode()


def judge(code, used, answer, silent, text):
    """How a call that ran like this breaks the rule; "" if it does not."""
    lines = [line.split("\r")[-1] for line in re.split(r"\r*\n", text) if line.strip()]  # without progress
    if answer is not None and answer > ANSWER + TICK:
        return f"{answer:.2f} s from Ctrl-C to the end (exit code {code})"
    if silent:
        return f"no progress in {used:.2f} s"
    if code in (2, 3):
        if used > REFUSAL:
            return f"refused after {used:.2f} s: {lines[-1]}"
        if len(lines) != 1:
            return f"refused in {len(lines)} lines: {text!r}"
    elif code not in (0, 1) and not (answer is not None and code in (128 + signal.SIGINT, -signal.SIGINT)):
        return f"exit code {code}: {text!r}"
    return ""
