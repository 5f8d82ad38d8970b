"""What the tests share: the repository's second judge, the command, and profiles of examples."""

import os
import pathlib
import shutil
import sys

import hypothesis
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
# The judge in big integers, which knows nothing of the crate.
sys.path.insert(0, str(ROOT / "tests/programs"))

# pytest --hypothesis-profile=long runs a hundred thousand examples of each property.
hypothesis.settings.register_profile("long", max_examples=100_000, deadline=None)
hypothesis.settings.register_profile("short", max_examples=200, deadline=None, derandomize=True)
hypothesis.settings.load_profile("short")


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
