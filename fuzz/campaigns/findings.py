"""Describes a failure: its smallest bytes, the panic, and what the bytes stand for."""

import hashlib
import shutil

from . import libfuzzer, processes

# A finding is made smaller for so many seconds at most.
MINIMISING = 60
# An input that does not end is not waited for any longer.
SHOWING = 30


class Finding:
    """A failure of a target, by its name, in a folder of its own."""

    def __init__(self, target, failure, outcome):
        self.target, self.failure, self.outcome = target, failure, outcome
        self.kind = libfuzzer.kind(outcome.artifact)
        name = f"{target.name}-{hashlib.sha1(failure.encode()).hexdigest()[:8]}"
        self.folder = target.out / "findings" / name
        # What a reader has to know of it.
        self.note = ""

    def keep(self):
        """Fills the folder."""
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        smallest, text = self.folder / "bytes", self.outcome.text
        smallest.write_bytes(self.outcome.content)
        if processes.stopped.is_set():
            self.note = "Not made smaller, as the campaign was stopped."
        else:
            if self.kind == "crash":
                self._minimise(smallest)
            again = self._again(smallest)
            if again.failure():
                text = again.text
            else:
                self.note = "Run alone, these bytes did not fail again."
        (self.folder / "panic.txt").write_text(text)
        shown = libfuzzer.run(self.target.binary, smallest, seconds=SHOWING, SWEEP_CDT_SHOW=str(self.folder))
        if not (self.folder / "row.txt").exists():
            (self.folder / "show.txt").write_text(shown.text)

    def _again(self, file):
        """The bytes once more, alone. libFuzzer then writes no file."""
        return libfuzzer.run(self.target.binary, file, seconds=SHOWING)

    def _minimise(self, smallest):
        """Smaller bytes that fail in the same way. What takes long is no such bytes, and would be written as well."""
        less = self.folder / "less"
        libfuzzer.run(self.target.binary, "-minimize_crash=1", f"-max_total_time={MINIMISING}",
                      "-report_slow_units=1000", f"-exact_artifact_path={less}", smallest, seconds=MINIMISING + 5)
        if less.exists():
            if self._again(less).failure() == self.failure:
                less.replace(smallest)
            else:
                less.unlink()

    def again(self):
        """The line that runs the bytes once more, without a build."""
        return f"{self.target.binary} {self.folder / 'bytes'}"

    def files(self):
        """The names of the files in the folder."""
        return sorted(file.name for file in self.folder.iterdir())

    def row(self):
        """The input as a row of the table of cases, or what stands for it."""
        row = self.folder / "row.txt"
        return row.read_text().strip() if row.exists() else ""
