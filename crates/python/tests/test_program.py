"""The package computes the same numbers as the program, bit for bit."""

import csv
import io
import json
import pathlib
import random
import subprocess

import numpy as np
import pandas
import pounding
import pytest
from conftest import ROOT

pytestmark = pytest.mark.filterwarnings("ignore::pounding.PoundingWarning")

EXAMPLES = sorted(
    path for path in (ROOT / "studies" / "examples").iterdir() if path.suffix in {".toml", ".json"}
)


def table_of(text: str) -> pandas.DataFrame:
    """A CSV table whose numbers keep every bit."""
    rows = list(csv.DictReader(io.StringIO(text)))

    def read(cell: str) -> object:
        try:
            return float(cell) if cell else float("nan")
        except ValueError:
            return cell

    return pandas.DataFrame([{name: read(cell) for name, cell in row.items()} for row in rows])


def asked(program: str, *words: object) -> str:
    done = subprocess.run(
        [program, *map(str, words)], capture_output=True, text=True, check=False, timeout=600
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def of_one_run(summary: str) -> dict[str, object]:
    """A summary without the second run of the program, under a band-limited record."""
    found = json.loads(summary)
    found.pop("between_samples", None)
    return found


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.name)
def test_limit_examples_have_the_bits_of_the_program(program: str, path: pathlib.Path) -> None:
    run = pounding.scene(path).run()
    assert run.summary == of_one_run(asked(program, "run", path, "--one-direction", "--json"))


@pytest.mark.parametrize("path", EXAMPLES[:2], ids=lambda path: path.name)
def test_limit_reports_have_the_bytes_of_the_program(
    program: str, path: pathlib.Path, tmp_path: pathlib.Path
) -> None:
    pounding.scene(path).run().report(tmp_path / "ours")
    asked(program, "run", path, "--out", tmp_path / "theirs")
    theirs = {one.name: one.read_bytes() for one in (tmp_path / "theirs").iterdir()}
    ours = {one.name: one.read_bytes() for one in (tmp_path / "ours").iterdir()}
    assert ours == theirs


def random_scene(seed: int) -> dict:
    draw = random.Random(seed)
    laws = [
        {"stereomechanical": {"restitution": draw.uniform(0.1, 1.0)}},
        {"linear_spring": {"impact_stiffness_n_per_m": 10 ** draw.uniform(7, 9)}},
        {
            "hertz_damp": {
                "impact_stiffness_n_per_m1_5": 10 ** draw.uniform(8, 10),
                "restitution": draw.uniform(0.3, 0.9),
            }
        },
    ]
    structures = []
    for index in range(draw.randint(2, 4)):
        fields = {
            "name": f"{index}",
            "mass_kg": 10 ** draw.uniform(4.5, 6.5),
            "period_s": draw.uniform(0.2, 2.0),
            "damping": {"ratio": draw.uniform(0.0, 0.1)},
        }
        if draw.random() < 0.3:
            fields["yield_displacement_m"] = draw.uniform(0.01, 0.1)
        structures.append({"sdof": fields})
    contacts = [
        {"gap_m": draw.uniform(0.0, 0.05), "law": draw.choice(laws)} for _ in structures[1:]
    ]
    method = draw.choice(["exact", {"rk4": {"time_step_s": 1e-3}}, {"newmark": {"time_step_s": 1e-3}}])
    ground = {
        "ground": draw.choice(["firm", "medium", "soft"]),
        "pga_m_per_s2": draw.uniform(1.0, 5.0),
        "strong_from_s": 1.0,
        "strong_until_s": 3.0,
        "decay_per_s": 1.0,
        "duration_s": 5.0,
        "time_step_s": 0.01,
        "seed": seed,
    }
    return {
        "name": f"random {seed}",
        "record": {"generated": {"stochastic": ground}, "reversed": draw.random() < 0.5},
        "structures": structures,
        "contacts": contacts,
        "duration_s": 6.0,
        "method": method,
    }


@pytest.mark.parametrize("seed", range(12))
def test_limit_random_scenes_have_the_bits_of_the_program(
    program: str, seed: int, tmp_path: pathlib.Path
) -> None:
    words = random_scene(seed)
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(words))
    done = subprocess.run([program, "run", path, "--one-direction", "--json"], capture_output=True, text=True, check=False)
    try:
        run = pounding.scene(words).run()
    except pounding.Refused as refused:
        assert done.returncode == 1
        theirs = json.loads(done.stderr)["error"]["message"]
        assert str(refused) in theirs or theirs.endswith(str(refused)), (str(refused), theirs)
        return
    assert done.returncode == 0, done.stderr
    assert run.summary == of_one_run(done.stdout)


def test_limit_a_sweep_has_the_rows_of_the_program(program: str, tmp_path: pathlib.Path) -> None:
    words = random_scene(3)
    words["contacts"] = [
        {"gap_m": 0.02, "law": {"stereomechanical": {"restitution": 0.65}}} for _ in words["contacts"]
    ]
    gaps = np.linspace(0.0, 0.05, 40)
    sweep = {
        "scene": words,
        "vary": [{"field": "contacts[*].gap_m", "values": gaps.tolist()}],
    }
    path = tmp_path / "sweep.json"
    path.write_text(json.dumps(sweep))
    asked(program, "sweep", path, "--out", tmp_path / "out.csv")
    theirs = table_of((tmp_path / "out.csv").read_text(encoding="utf-8"))
    ours = pounding.scene(words).sweep(gap=gaps)
    assert list(ours.columns) == list(theirs.columns)
    numbers = [name for name in theirs.select_dtypes("number") if name != "failed"]
    assert len(numbers) > 10 and ours["failed"].isna().all() and theirs["failed"].isna().all()
    pandas.testing.assert_frame_equal(
        ours[numbers].astype(float), theirs[numbers].astype(float), check_exact=True
    )


def test_limit_a_summary_has_the_lines_of_the_program(program: str, tmp_path: pathlib.Path) -> None:
    path = ROOT / "studies" / "examples" / "two-structures.json"
    gap, summary = "contacts[0].gap_m", {"by": ["contacts[0].gap_m"], "exceedance": {"peak_displacement_m": [0.1]}}
    masses = {"field": "structures[0].sdof.mass_kg", "values": [6e4, 75e3, 9e4]}
    sweep = {"scene": str(path), "vary": [{"field": gap, "values": [0.01, 0.04]}, masses], "summary": summary}
    (tmp_path / "sweep.json").write_text(json.dumps(sweep))
    asked(program, "sweep", tmp_path / "sweep.json", "--out", tmp_path / "out.csv")
    theirs = table_of((tmp_path / "out.csv").read_text(encoding="utf-8"))
    vary = {gap: [0.01, 0.04], masses["field"]: masses["values"]}
    ours = pounding.scene(path).sweep(vary, summary=summary)
    assert set(ours["statistic"]) >= {"runs", "mean", "quantile", "exceedance"}
    pandas.testing.assert_frame_equal(ours, theirs, check_exact=True, check_dtype=False)


def test_limit_answers_are_those_of_the_program(program: str) -> None:
    path = ROOT / "studies" / "examples" / "two-structures.json"
    scene = pounding.scene(path)
    theirs = json.loads(asked(program, "run", path, "--json", "--effects"))["effects"]
    ours = scene.effects()
    for is_reversed, key in ((False, "as_given"), (True, "reversed")):
        floors = ours[ours["reversed"] == is_reversed]
        assert list(floors["name"]) == [one["name"] for one in theirs[key]]
        assert list(floors["peak_drift_m"]) == [one["peak_drift_m"]["beside"] for one in theirs[key]]
        assert list(floors["impulse_n_s_high"]) == [one["impulse_n_s"]["high"] for one in theirs[key]]
    theirs = json.loads(asked(program, "advise", path, "--accuracy", "1%", "--quantity", "momentum", "--json"))
    assert scene.advise(0.01, "momentum") == theirs
    certify = ["certify", "hertz_damp", "--restitution", 0.65, "--masses", 75e3, 3e6, "--speed", 0.3, "--json"]
    theirs = json.loads(asked(program, *certify))
    ours = pounding.certify("hertz_damp", restitution=0.65, masses=(75e3, 3e6), speed=0.3)
    assert ours == theirs
    records = ROOT / "studies" / "records"
    theirs = json.loads(asked(program, "assess", path, "--records", records, "--json"))
    assert scene.assess(records).facts == theirs
    theirs = asked(program, "gap", path, "--records", records, "--csv")
    ours = scene.required_gap(records)
    theirs = table_of(theirs).drop(columns="refused")
    assert list(ours.columns) == list(theirs.columns)
    numbers = list(ours.select_dtypes("float").columns)
    pandas.testing.assert_frame_equal(ours[numbers], theirs[numbers], check_exact=True)


def test_limit_frequencies_are_those_of_the_program(program: str, tmp_path: pathlib.Path) -> None:
    path = ROOT / "studies" / "examples" / "two-structures.json"
    records = tmp_path / "records"
    records.mkdir()
    for event, frequency in enumerate([0.6, 0.8, 1.0, 1.3, 1.7, 2.2, 3.0]):
        pulse = pounding.formula("ricker", amplitude=1.0, frequency=frequency, time_step=0.01)
        rows = [f"{time!r},{one!r}" for time, one in zip(pulse.time.tolist(), pulse.acceleration.tolist())]
        text = "\n".join(["time_s,acceleration_m_per_s2", *rows])
        (records / f"event{event}.csv").write_text(text + "\n")
    curve = [(0.01, 0.2), (0.1, 0.01), (1.0, 1e-4), (5.0, 1e-6)]
    hazard = tmp_path / "hazard.csv"
    hazard.write_text("".join(f"{im},{frequency}\n" for im, frequency in curve))
    words = ["ida", path, "--records", records, "--im", "T1", "--hazard", hazard, "--gaps", "0.02,0.05"]
    scene = pounding.scene(path)
    ours = scene.ida(records, im="T1", hazard=curve, gaps=[0.02, 0.05])
    assert ours.facts == json.loads(asked(program, *words, "--json"))
    assert repr(ours) == asked(program, *words)
    assert ours == scene.ida(records, im="t1", hazard=hazard, gaps=[0.02, 0.05])
    theirs = table_of(asked(program, *words, "--csv"))
    numbers = list(theirs.select_dtypes("float").columns)
    pandas.testing.assert_frame_equal(
        ours.table[numbers], theirs[numbers], check_exact=True, check_dtype=False
    )
    assert list(ours.by_gap["gap_m"]) == [0.02, 0.05]
    assert ours.report(tmp_path / "out").read_text(encoding="utf-8").startswith("Answer")
    # A folder for every intensity, which has no fragility: the answer says why.
    both = scene.ida({0.1: records, 0.2: records})
    assert both.facts["states"][0]["refused"] in both.warnings[0]
    with pytest.raises(pounding.Refused, match="measure of the hazard curve"):
        scene.ida(records, hazard=curve)
    with pytest.raises(pounding.Refused, match="found -1, allowed are finite numbers > 0"):
        scene.ida(records, gaps=[-1.0])


def test_limit_spectra_are_those_of_the_program(program: str) -> None:
    path = next((ROOT / "studies" / "records").glob("*.csv"))
    table = asked(program, "motion", "spectrum", path, "--count", 7, "--csv")
    theirs = table_of(table)
    ours = pounding.read(path).spectrum(theirs["period_s"])
    assert list(ours.columns) == list(theirs.columns)
    pandas.testing.assert_frame_equal(ours, theirs, check_exact=True)
