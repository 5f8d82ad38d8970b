"""The notebook runs from its first cell to its last."""

import pathlib

import pytest

NOTEBOOK = pathlib.Path(__file__).resolve().parents[1] / "notebook.ipynb"


def test_notebook(tmp_path, monkeypatch):
    for needed in ("nbformat", "nbclient", "ipykernel", "matplotlib", "scipy", "shapely"):
        pytest.importorskip(needed)
    import ipykernel.kernelspec
    import nbclient
    import nbformat

    # The kernel is this Python, whatever kernels are installed.
    ipykernel.kernelspec.install(prefix=str(tmp_path))
    monkeypatch.setenv("JUPYTER_PATH", str(tmp_path / "share/jupyter"))
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    kinds = {kind for output in outputs for kind in output.get("data", {})}
    assert {"text/html", "image/svg+xml", "image/png"} <= kinds
