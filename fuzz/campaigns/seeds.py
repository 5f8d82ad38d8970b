"""The seeds and the longest inputs of the targets, read without a program that would have to be built first."""

import shutil

from .processes import FUZZ

# A line for each target: its name, and of how many bytes its inputs are at most. A test of `fuzz/properties` compares
# it with the table there.
LENGTHS = FUZZ / "lengths.txt"


def lengths():
    """Of how many bytes the inputs of each target are at most."""
    return {name: int(length) for name, length in map(str.split, LENGTHS.read_text().splitlines())}


def unpack(target, folder):
    """Writes each seed of a target into a folder as a file of its own, beside no others.

    The names are those that the program of `fuzz/properties` gives them, too.
    """
    lines = (FUZZ / "seeds" / f"{target}.hex").read_text().splitlines()
    seeds = {bytes.fromhex(line.partition("#")[0]) for line in lines}
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for number, seed in enumerate(sorted(seeds), 1):
        (folder / f"seed_{number:04}").write_bytes(seed)
