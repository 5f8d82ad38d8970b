"""The examples in the documentation: in the README, and of each module."""

import doctest
import importlib.util
import os
import pathlib
import pkgutil

import pytest

import sweep_cdt

os.environ.setdefault("MPLBACKEND", "Agg")
README = pathlib.Path(__file__).resolve().parents[1] / "README.md"
MODULES = [f"sweep_cdt.{module.name}" for module in pkgutil.iter_modules(sweep_cdt.__path__)]


def test_readme(tmp_path, monkeypatch):
    # The examples write files.
    monkeypatch.chdir(tmp_path)
    for needed in ("dask.dataframe", "distributed", "geopandas", "matplotlib", "meshio", "rasterio", "scipy", "shapely"):
        pytest.importorskip(needed)
    failed, tried = doctest.testfile(str(README), module_relative=False)
    assert failed == 0 and tried > 20


def test_types(tmp_path):
    """The package as it is strictly checked, and the examples as programs of users, who are."""
    api = pytest.importorskip("mypy.api")
    examples = doctest.DocTestParser().get_examples(README.read_text())
    (tmp_path / "examples.py").write_text("".join(example.source for example in examples))
    options = ["--config-file", str(README.with_name("pyproject.toml")), "--cache-dir", str(tmp_path)]
    said, errors, status = api.run([*options, str(README.with_name("python")), str(tmp_path / "examples.py")])
    assert status == 0, said + errors


def is_there(test):
    """Whether the libraries are there that the examples import."""
    imports = (line.source for line in test.examples if line.source.startswith("import "))
    names = [name.strip().partition(".")[0] for line in imports for name in line.removeprefix("import ").split(",")]
    return all(importlib.util.find_spec(name) for name in names)


@pytest.mark.parametrize("name", MODULES)
def test_module(name):
    runner = doctest.DocTestRunner()
    module = pytest.importorskip(name, exc_type=ImportError)
    for test in doctest.DocTestFinder().find(module):
        if is_there(test):
            runner.run(test)
    assert runner.failures == 0


def test_every_public_name_has_words():
    for name in sweep_cdt.__all__:
        assert name == "__version__" or getattr(sweep_cdt, name).__doc__, name
