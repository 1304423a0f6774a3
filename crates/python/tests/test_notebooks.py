"""Every notebook runs from its first cell to its last."""

import importlib.util
import pathlib

import nbformat
import pytest
from nbclient import NotebookClient

NOTEBOOKS = sorted((pathlib.Path(__file__).resolve().parents[1] / "notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_limit_notebooks_run(path: pathlib.Path) -> None:
    if "opensees" in path.stem and importlib.util.find_spec("openseespy") is None:
        pytest.skip("OpenSees is not installed")
    notebook = nbformat.read(path, as_version=4)
    folder = {"metadata": {"path": str(path.parent)}}
    NotebookClient(notebook, timeout=600, kernel_name="python3", resources=folder).execute()
