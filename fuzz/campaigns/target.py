"""One fuzz target: its folders, its slices, and what has come of them so far."""

import contextlib
import shutil
import threading
import time

from . import libfuzzer, processes
from .processes import FUZZ

# Every other slice keeps to inputs of at most so many bytes: smaller ones, and more of them.
SHORT = 48
# The corpus of one target is minimised for so many seconds at most.
MINIMISING = 120


class Target:
    """A target by its name. Its inputs have at most as many bytes as it reads, or as asked for."""

    def __init__(self, name, max_len, binary, out):
        self.name, self.max_len, self.binary, self.out = name, max_len, binary, out
        self.corpus = FUZZ / "corpus" / name
        self.reached, self.artifacts = out / "reached" / name, out / "artifacts" / name
        for folder in [self.corpus, self.reached, self.artifacts, out / "peer-faults"]:
            folder.mkdir(parents=True, exist_ok=True)
        dictionary = FUZZ / "dictionaries" / f"{name}.dict"
        self.words = [f"-dict={dictionary}"] if dictionary.exists() else []
        self.executions, self.seconds, self.turns, self.broken = 0, 0.0, 0, None
        # What ended a slice first, by the name of the failure; and slow inputs with their seconds.
        self.failures, self.slow = {}, {}
        # How many files the corpus had before it was minimised, and has now.
        self.sizes = None
        self.lock = threading.Lock()

    def fuzz(self, seconds):
        """One slice: again after each failure, until the time is up."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 1 and not self.broken and not processes.stopped.is_set():
            self._fuzz_once(left)

    def _fuzz_once(self, seconds):
        with self.lock:
            self.turns += 1
            longest = self.max_len if self.turns % 2 else min(self.max_len or SHORT, SHORT)
        start = time.monotonic()
        outcome = libfuzzer.run(
            self.binary, *libfuzzer.longest(longest), f"-max_total_time={int(seconds)}",
            f"-artifact_prefix={self.artifacts}/", *libfuzzer.SLICE, *self.words, self.corpus, seconds=seconds,
            SWEEP_CDT_REACHED=str(self.reached), SWEEP_CDT_PEER_FAULTS=str(self.out / "peer-faults"))
        with self.lock:
            self.seconds += time.monotonic() - start
            self.executions += outcome.executions
            self.slow.update(outcome.slow)
            if outcome.artifact and outcome.artifact.exists():
                # A later slice that is interrupted may leave half of the same file.
                outcome.content = outcome.artifact.read_bytes()
                self.failures.setdefault(outcome.failure() or "unknown", outcome)
                self._put_aside(outcome.content, longest)
            elif not outcome.ran and not processes.stopped.is_set():
                self.broken = outcome.text[-2000:]
                processes.say(f"{self.name} did not run:\n{self.broken}")

    def _put_aside(self, failing, longest):
        """Removes an input that fails from those that each slice begins with, or none would get past it."""
        for file in self.corpus.iterdir():
            # libFuzzer may replace a file of the corpus meanwhile.
            with contextlib.suppress(FileNotFoundError):
                if failing == file.read_bytes()[:longest]:
                    file.unlink()

    def minimise(self):
        """Keeps the smallest files of the corpus that reach what all of it reaches."""
        small = self.corpus.with_name(f"{self.name}.small")
        shutil.rmtree(small, ignore_errors=True)
        small.mkdir()
        before, start = len(list(self.corpus.iterdir())), time.monotonic()
        code, _ = processes.run(
            [self.binary, *libfuzzer.LIMITS, *libfuzzer.longest(self.max_len), *self.words, "-merge=1", small,
             self.corpus], seconds=MINIMISING)
        took = time.monotonic() - start
        if code != 0:
            shutil.rmtree(small)
            processes.say(f"  {self.name}: not minimised in {took:.0f} s, kept as it is")
            return
        shutil.rmtree(self.corpus)
        small.rename(self.corpus)
        self.sizes = before, len(list(self.corpus.iterdir()))
        processes.say(f"  {self.name}: {before} files, now {self.sizes[1]}, in {took:.0f} s")

    def shares(self):
        """How many inputs were looked at, and how many of them reached each event."""
        sums = {}
        for file in self.reached.glob("*.tsv"):
            for line in file.read_text().splitlines():
                name, count = line.split("\t")
                sums[name] = sums.get(name, 0) + int(count)
        return sums.pop("inputs", 0), sums
