"""Runs programs, says what is going on, and ends everything in order at Ctrl-C.

The programs run in sessions of their own, so that Ctrl-C in a terminal reaches this script alone. The first one
interrupts what runs and sets `stopped`, after which a campaign goes straight to its report; the second one ends all.
"""

import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

FUZZ = pathlib.Path(__file__).resolve().parents[1]
# A program that was interrupted and has not ended after so many seconds is killed.
PATIENCE = 5

stopped = threading.Event()
started = time.monotonic()
_children = set()


class Failed(Exception):
    """A program that has to succeed did not."""


def duration(seconds):
    """Minutes and seconds, as a clock shows them."""
    return f"{int(seconds) // 60}:{int(seconds) % 60:02}"


def say(text):
    """Prints a line of progress with the time since the start."""
    print(f"[{duration(time.monotonic() - started)}] {text}", flush=True)


def _signal(process, number):
    """Sends a signal to a program and all that it started."""
    try:
        os.killpg(process.pid, number)
    except ProcessLookupError:
        pass


def _interrupted(_number, _frame):
    """What Ctrl-C does."""
    last = stopped.is_set()
    stopped.set()
    for process in list(_children):
        _signal(process, signal.SIGKILL if last else signal.SIGINT)
    if last:
        os._exit(130)
    print("\nstopping (Ctrl-C again ends at once)", file=sys.stderr, flush=True)


def listen():
    """From here on Ctrl-C stops a campaign as said above."""
    signal.signal(signal.SIGINT, _interrupted)


def run(command, seconds=None, shown=False, **options):
    """Runs a program; returns its exit status and all that it printed. One that takes longer is interrupted.

    With `shown` it prints to the terminal.
    """
    pipes = {} if shown else {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    after_stop = stopped.is_set()
    process = subprocess.Popen(command, cwd=FUZZ, start_new_session=True, **pipes, **options)
    _children.add(process)
    if stopped.is_set() and not after_stop:
        _signal(process, signal.SIGINT)
    try:
        for limit, number in [(seconds, signal.SIGINT), (PATIENCE, signal.SIGKILL), (None, None)]:
            try:
                text, _ = process.communicate(timeout=limit)
                break
            except subprocess.TimeoutExpired:
                _signal(process, number)
    finally:
        _children.discard(process)
    return process.returncode, (text or b"").decode(errors="replace")


def must(command, **options):
    """Runs a program that has to succeed; returns what it printed."""
    code, text = run(command, **options)
    if code != 0:
        raise Failed(f"{' '.join(map(str, command))} failed with status {code}\n{text}".strip())
    return text
