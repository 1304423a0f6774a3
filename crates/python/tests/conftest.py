"""Paths of the repository and of the program that the package is compared with."""

import os
import pathlib
import shutil

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]


@pytest.fixture(scope="session")
def program() -> str:
    """Path of the program, from `cargo xtask check --python`."""
    named = os.environ.get("POUNDING_PROGRAM")
    built = [ROOT / "target" / profile / "pounding" for profile in ("debug", "release")]
    found = named or next((str(path) for path in built if path.exists()), None) or shutil.which("pounding")
    assert found, "build the program first: cargo build -p pounding"
    return found


@pytest.fixture
def pulse():
    import pounding

    return pounding.formula("ricker", amplitude=4.0, frequency=1.0, time_step=0.01)


@pytest.fixture
def towers():
    import pounding

    return pounding.row(
        pounding.sdof(mass=75e3, period=1.2, damping=0.05),
        pounding.sdof(mass=3e6, period=0.3, damping=0.05),
        gap=0.03,
        restitution=0.65,
    )
