"""Types are correct in the package and in the code of the notebooks."""

import json
import pathlib
import subprocess
import sys

import pounding
import pytest

HERE = pathlib.Path(__file__).resolve().parents[1]
NOTEBOOKS = sorted((HERE / "notebooks").glob("*.ipynb"))


def mypy(*arguments: object) -> None:
    command = [sys.executable, "-m", "mypy", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=HERE)
    assert done.returncode == 0, done.stdout + done.stderr


def code(notebook: pathlib.Path) -> str:
    """The code of a notebook. A notebook prints a last expression; here it is a statement."""
    cells = json.loads(notebook.read_text(encoding="utf-8"))["cells"]
    return "\n\n".join("".join(cell["source"]) for cell in cells if cell["cell_type"] == "code")


def test_limit_the_package_has_its_types() -> None:
    mypy("--strict", "--ignore-missing-imports", "--package", "pounding")


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_limit_notebooks_have_the_types(notebook: pathlib.Path, tmp_path: pathlib.Path) -> None:
    module = tmp_path / f"{notebook.stem.replace('-', '_')}.py"
    module.write_text(code(notebook), encoding="utf-8")
    mypy("--ignore-missing-imports", module)


def test_reference_every_public_name_says_what_it_is() -> None:
    for name in pounding.__all__:
        one = getattr(pounding, name)
        assert one.__doc__, name
        for key, member in vars(one).items() if isinstance(one, type) else []:
            if not key.startswith("_") and callable(getattr(member, "fget", member)):
                assert getattr(member, "__doc__", None), f"{name}.{key}"
