"""What the tests share: the repository's second judge, the command, and profiles of examples."""

import os
import pathlib
import shutil
import sys

os.environ.setdefault("MPLBACKEND", "Agg")

import hypothesis
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
# The judge in big integers, which knows nothing of the crate.
sys.path.insert(0, str(ROOT / "tests/programs"))

# SWEEP_CDT_EXAMPLES says how many examples of each property are run; more than by default are drawn anew each time.
EXAMPLES = os.environ.get("SWEEP_CDT_EXAMPLES")
hypothesis.settings.register_profile(
    "own", max_examples=int(EXAMPLES or 100), deadline=None, derandomize=EXAMPLES is None
)
hypothesis.settings.load_profile("own")


@pytest.fixture(scope="session")
def command():
    """The command, where it is built or installed; SWEEP_CDT names another one."""
    found = os.environ.get("SWEEP_CDT")
    for path in (found, ROOT / "target/release/sweep-cdt", shutil.which("sweep-cdt")):
        if path and pathlib.Path(path).exists():
            return path
    if os.environ.get("CI"):
        pytest.fail("the command is not built: cargo build --release")
    pytest.skip("the command is not built: cargo build --release")
