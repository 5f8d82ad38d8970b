"""A folder with the campaign, and a cargo, a rustc and fuzz targets that only pretend.

A fake target does what its name says, as libFuzzer would: it prints, writes files and stops when it is told to.
"""

import os
import pathlib
import shutil
import stat
import subprocess
import sys
import tempfile

FUZZ = pathlib.Path(__file__).resolve().parents[2]

# What a target does, by its name.
TARGET = '''#!{python}
import hashlib, os, pathlib, re, signal, sys, time
name = pathlib.Path(sys.argv[0]).name
flags = dict(re.match("-([a-z_]+)=(.*)", word).groups() for word in sys.argv[1:] if word.startswith("-"))
files = [pathlib.Path(word) for word in sys.argv[1:] if not word.startswith("-")]
with open(os.environ["FAKE_LOG"], "a") as log:
    log.write(f"{{time.time()}} {{name}} {{' '.join(sys.argv[1:])}}\\n")

def end(status):
    print("stat::number_of_executed_units: 100", flush=True)
    os._exit(status)

def write(kind, content):
    path = flags.get("exact_artifact_path") or \\
        flags["artifact_prefix"] + kind + "-" + hashlib.sha1(content).hexdigest()
    pathlib.Path(path).write_bytes(content)
    print(f"artifact_prefix='{{flags.get('artifact_prefix', './')}}'; Test unit written to {{path}}", flush=True)

def fail(content):
    print("thread '<unnamed>' panicked at src/sweep/mod.rs:7:9:\\nvertex 12 is not there", flush=True)
    # What is run alone is not written again.
    if "artifact_prefix" in flags:
        write("crash", content)
    end(77)

signal.signal(signal.SIGINT, lambda *_: end(72))
if "merge" in flags:
    end(0)
if "minimize_crash" in flags:
    write("minimized-from", b"small")
    end(0)
if "SWEEP_CDT_SHOW" in os.environ:
    row = pathlib.Path(os.environ["SWEEP_CDT_SHOW"]) / "row.txt"
    row.write_text(f"row of {{files[0].read_bytes()}}\\n")
    end(0)
if files and files[0].is_file():
    if files[0].read_bytes() in (b"small", b"large", b"seed"):
        fail(files[0].read_bytes())
    end(0)
if name == "absent":
    print("cannot be loaded")
    sys.exit(1)
if name == "seeded":
    for folder in files:
        for file in folder.iterdir():
            fail(file.read_bytes())
if name == "slow":
    print("Slowest unit: 11 s:")
    write("slow-unit", b"slow")
    fail(b"large")
if name == "loading":
    time.sleep(60)
time.sleep(float(flags["max_total_time"]))
end(0)
'''

CARGO = '''#!{python}
import os, pathlib, shutil, sys, time
words, fuzz = sys.argv[1:], pathlib.Path(os.environ["FAKE_FUZZ"])
if "--version" in words:
    print("cargo 1")
    sys.exit(" ".join(words) in os.environ.get("FAKE_MISSING", "").split(","))
if "fuzz" in words:
    for line in (fuzz / "seeds").iterdir():
        corpus = fuzz / "corpus" / line.stem
        corpus.mkdir(parents=True, exist_ok=True)
        (corpus / "seed_0001").write_bytes(b"seed")
    shutil.copytree(fuzz / "fakes", fuzz / "target/x86_64-fake-linux-gnu/release", dirs_exist_ok=True)
if words[0] == "build":
    (fuzz / "target/coverage/release").mkdir(parents=True, exist_ok=True)
    shutil.copy(fuzz / "properties", fuzz / "target/coverage/release/sweep-cdt-properties")
'''

PROPERTIES = '''#!{python}
import os, pathlib, shutil, sys, time
if sys.argv[1] == "run":
    with open(os.environ["FAKE_LOG"], "a") as log:
        log.write(f"{{time.time()}} covering {{sys.argv[2]}}\\n")
    time.sleep(float(os.environ.get("FAKE_COVERING", 0)))
    pathlib.Path(os.environ["LLVM_PROFILE_FILE"]).write_text("")
'''

RUSTC = '''#!/bin/sh
[ "$1" = -vV ] && echo "host: x86_64-fake-linux-gnu"
[ "$2" = sysroot ] && echo "$FAKE_FUZZ/sysroot"
exit 0
'''

LLVM = '''#!/bin/sh
file="$(cd "$FAKE_FUZZ/.." && pwd)/src/sweep/mod.rs"
region() { echo "{\\"filenames\\": [\\"$file\\"], \\"regions\\": [[$1, 1, $1, 9, $2, 0, 0, 0], [1, 1, 9, 9, 0, 0, 0, 1]]}"; }
# One function for two types, of which one reaches it, and one that is missed.
[ "$1" = export ] && echo "{\\"data\\": [{\\"functions\\": [$(region 3 7), $(region 3 0), $(region 5 0)]}]}"
exit 0
'''


class Workplace:
    """The folder, for targets of these names; to be used in a `with` statement."""

    def __init__(self, *names):
        self.names = names

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(self.folder.name)
        self.fuzz, self.log = root / "fuzz", root / "log"
        self.out = self.fuzz / "target/campaign"
        self.fuzz.mkdir()
        (root / "src").mkdir()
        shutil.copytree(FUZZ / "oss-fuzz", self.fuzz / "oss-fuzz")
        shutil.copytree(FUZZ / "campaigns", self.fuzz / "campaigns", ignore=shutil.ignore_patterns("tests"))
        shutil.copy(FUZZ / "campaign", self.fuzz)
        (self.fuzz / "Cargo.toml").write_text("".join(f'path = "fuzz_targets/{name}.rs"\n' for name in self.names))
        (self.fuzz / "seeds").mkdir()
        for name in self.names:
            self.program(f"fakes/{name}", TARGET)
            (self.fuzz / f"seeds/{name}.hex").write_text(f"{b'seed'.hex()}  # a name\n")
        self.program("bin/cargo", CARGO)
        self.program("bin/rustc", RUSTC)
        self.program("properties", PROPERTIES)
        for tool in ["llvm-cov", "llvm-profdata"]:
            self.program(f"sysroot/lib/rustlib/fake/bin/{tool}", LLVM)
        return self

    def __exit__(self, *_):
        self.folder.cleanup()

    def program(self, path, text):
        """Writes a program."""
        file = self.fuzz / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.format(python=sys.executable) if "{python}" in text else text)
        file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def start(self, *words, **environment):
        """Starts the campaign."""
        return subprocess.Popen([sys.executable, self.fuzz / "campaign", *words], text=True,
                                env=self.settings(**environment), stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def settings(self, **environment):
        """The environment in which cargo and rustc are those that pretend."""
        path = f"{self.fuzz}/bin:{os.environ['PATH']}"
        return {**os.environ, "PATH": path, "FAKE_FUZZ": str(self.fuzz), "FAKE_LOG": str(self.log), **environment}

    def run(self, *words, **environment):
        """The exit status of the campaign and what it prints."""
        process = self.start(*words, **environment)
        text, _ = process.communicate(timeout=60)
        return process.returncode, text

    def report(self):
        """The report."""
        return (self.out / "report.md").read_text()

    def slices(self):
        """The names and options of the slices that ran, in their order."""
        lines = [line.split(" ", 2)[1:] for line in self.log.read_text().splitlines()]
        return [(name, words) for name, words in lines if "max_total_time" in words and "minimize" not in words]
