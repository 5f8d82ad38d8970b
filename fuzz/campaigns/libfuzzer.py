"""What libFuzzer is told, and what it says.

It names a file that it writes by what happened: `crash-`, `timeout-`, `oom-` and `leak-` are findings and end the
process; `slow-unit-` is an input that took long, after which it goes on. So one slice may write several files, and
only the last one can be a finding.
"""

import os
import pathlib
import re

from . import processes

LIMITS = ["-timeout=25", "-rss_limit_mb=2560", "-print_final_stats=1"]
# Weighing rare features costs more executions than it gains with generated inputs.
# How often a branch is taken says little of a geometric algorithm, whose loops turn as often as there are points; without
# these counts a third of the inputs is kept, and each execution costs less.
SLICE = ["-entropic=0", "-use_counters=0", "-reload=30"]
# libFuzzer looks at its clock between two inputs; after so many seconds more it is interrupted.
GRACE = 0.5


class Outcome:
    """What a run of libFuzzer came to."""

    def __init__(self, text):
        self.text = text
        executed = re.search(r"stat::number_of_executed_units:\s+(\d+)", text)
        self.ran = executed is not None
        self.executions = int(executed[1]) if executed else 0
        written = re.findall(r"Test unit written to (.+)$", text, re.M)
        seconds = re.findall(r"Slowest unit: (\d+) s", text)
        files = [pathlib.Path(name) for name in written]
        slow = [file for file in files if kind(file) == "slow-unit"]
        # The files of slow inputs, and how many seconds each took.
        self.slow = list(zip(slow, map(int, seconds)))
        # What is in the file of the finding, once it is read; and the file, if there is one.
        self.content = None
        self.artifact = next((file for file in reversed(files) if kind(file) != "slow-unit"), None)

    def failure(self):
        """The name of the failure: the panic's place and the start of its message, or what libFuzzer says; or none."""
        panic = re.search(r"panicked at ([^\n]+)\n([^\n]*)", self.text)
        if panic:
            return f"{panic[1]} {re.sub(r'[0-9]+', 'N', panic[2])[:80]}"
        summary = re.search(r"SUMMARY: ([^\n]+)", self.text)
        return summary[1] if summary else None


def longest(length):
    """The option for the longest input; the targets themselves make none that is longer than what they read."""
    return [f"-max_len={length}"] if length else []


def kind(file):
    """What happened, by the name of the file: crash, timeout, oom, leak or slow-unit."""
    return file.name.rpartition("-")[0]


def run(binary, *words, seconds=None, **environment):
    """Runs a fuzz target and waits for its end, at most so many seconds and some grace."""
    limit = None if seconds is None else seconds + GRACE
    settings = {**os.environ, **environment}
    _, text = processes.run([binary, *LIMITS, *words], seconds=limit, env=settings)
    return Outcome(text)
