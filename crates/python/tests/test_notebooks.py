"""Every notebook runs from its first cell to its last."""

import pathlib
import subprocess
import sys

import nbformat
import pytest
from nbclient import NotebookClient

NOTEBOOKS = sorted((pathlib.Path(__file__).resolve().parents[1] / "notebooks").glob("*.ipynb"))


def opensees_works() -> bool:
    """The import runs in a separate process, because a failed one ends its process with a message."""
    asked = [sys.executable, "-c", "import openseespy.opensees"]
    return subprocess.run(asked, capture_output=True, check=False).returncode == 0


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_limit_notebooks_run(path: pathlib.Path) -> None:
    if "opensees" in path.stem and not opensees_works():
        pytest.skip("OpenSees is not installed, or lacks a library of the system (libblas3, liblapack3)")
    notebook = nbformat.read(path, as_version=4)
    folder = {"metadata": {"path": str(path.parent)}}
    NotebookClient(notebook, timeout=600, kernel_name="python3", resources=folder).execute()
