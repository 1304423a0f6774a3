"""The Python blocks of the documents run in their order."""

import pathlib
import re
import shutil
import warnings

import matplotlib
import pounding
import pytest
from conftest import ROOT

PAGES = [ROOT / "README.md", ROOT / "docs/how-to/python.md", ROOT / "crates/python/README.md"]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: path.name)
def test_limit_blocks_of_a_page_run(
    page: pathlib.Path, tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    matplotlib.use("Agg")
    # The format of a file follows from its content, not from its name.
    shutil.copy(ROOT / "crates/motion/tests/files/usgs.smc", tmp_path / "quake.AT2")
    shutil.copytree(ROOT / "studies/records", tmp_path / "folder")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert blocks
    names: dict = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        for block in blocks:
            exec(compile(block, str(page), "exec"), names)
