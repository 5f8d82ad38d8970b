"""Looks for the programs that a campaign needs, before anything is built."""

import pathlib
import re
import shutil
import subprocess

# rustc's profiles are read by these versions of LLVM.
VERSIONS = range(30, 18, -1)
# So many bytes are needed: the targets take a third, corpora and the program that counts the rest.
SPACE = 3e9


def space(folder):
    """Whether enough bytes are free where a folder is, and what to say of it."""
    free = shutil.disk_usage(folder).free
    return free >= SPACE, f"{free / 1e9:.1f} GB of disk are free, {SPACE / 1e9:.0f} are needed"


def _answer(*command):
    """What a program prints, or nothing if it is not there or fails."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=True)
    except (OSError, subprocess.CalledProcessError):
        return ""
    return done.stdout.decode(errors="replace").strip()


def missing():
    """What a campaign cannot do without and is not there, each with the line that installs it."""
    if not _answer("cargo", "--version"):
        return [("cargo", "see https://rustup.rs")]
    needed = [("the nightly toolchain", ["cargo", "+nightly", "--version"],
               "rustup toolchain install nightly --profile minimal"),
              ("cargo-fuzz", ["cargo", "fuzz", "--version"], "cargo install cargo-fuzz")]
    return [(name, install) for name, command, install in needed if not _answer(*command)]


def llvm(tool):
    """The path of an LLVM tool that reads what rustc writes: the toolchain's own, or the system's."""
    sysroot = pathlib.Path(_answer("rustc", "--print", "sysroot"))
    own = sorted(sysroot.glob(f"lib/rustlib/*/bin/{tool}"))
    system = [shutil.which(f"{tool}-{version}") for version in VERSIONS]
    return next((path for path in [*own, *system] if path), None)


def host():
    """The name of this machine's target, as in the path of what cargo-fuzz builds."""
    found = re.search(r"^host: (\S+)", _answer("rustc", "-vV"), re.M)
    return found[1] if found else "x86_64-unknown-linux-gnu"
