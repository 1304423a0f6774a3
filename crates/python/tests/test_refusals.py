"""Wrong inputs are refused in the program's words, with their parts."""

import pickle

import numpy as np
import pounding
import pytest


def sdof(**changed):
    return pounding.sdof(**{"mass": 1e5, "period": 1.0, **changed})


@pytest.mark.parametrize(
    ("make", "place", "allowed"),
    [
        (lambda: pounding.row(sdof(mass=-1.0)), "structures[0].sdof.mass_kg", "> 0"),
        (lambda: pounding.row(sdof(), sdof(), gap=-0.01), "contacts[0].gap_m", ">= 0"),
        (lambda: pounding.row(sdof(), sdof(), gap=[0.01, 0.02]), "gap", "1"),
        (lambda: pounding.row(sdof(), sdof(), gap=0.01, restitution=2.0), "contacts[0].law", "0"),
        (lambda: pounding.row(sdof(), sdof(), gap=0.01, law="hertzz", restitution=0.5), "contacts[0].law", "hertz"),
        (lambda: pounding.record([], 0.01), None, "at least one sample"),
        (lambda: pounding.record([1.0], -0.01), None, "more than 0 s"),
        (lambda: pounding.formula("ricker", amplitude=1.0, frequency=-1.0, time_step=0.01), "record.generated", "> 0"),
        (lambda: pounding.formula("rickr", amplitude=1.0), "generated", "ricker"),
        (lambda: pounding.scene({"name": "x", "structures": []}), "structures", "one or more"),
        (lambda: pounding.certify("hertz", restitution=0.5, masses=(1.0, -1.0), speed=1.0), "masses[1]", "> 0"),
    ],
)
def test_extreme_wrong_inputs_are_refused(make, place, allowed) -> None:
    with pytest.raises(pounding.Refused) as caught:
        make()
    refused = caught.value
    assert isinstance(refused, ValueError)
    if place is not None:
        assert refused.place is not None and refused.place.startswith(place), refused
    assert allowed in str(refused)
    other = pickle.loads(pickle.dumps(refused))
    assert str(other) == str(refused)
    assert (other.place, other.found, other.allowed, other.help) == (
        refused.place,
        refused.found,
        refused.allowed,
        refused.help,
    )


def test_extreme_a_file_is_named_with_its_line(tmp_path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text('name = "x"\nrecord.file = "none.csv"\n[[structures]]\nsdof = { name = "a", mas_kg = 1 }\n')
    with pytest.raises(pounding.Refused, match="perhaps `mass_kg` is meant") as caught:
        pounding.scene(path)
    assert "scene.toml, line 4" in str(caught.value.place)


def test_extreme_a_missing_record_is_refused(towers, tmp_path) -> None:
    with pytest.raises(pounding.Refused, match="cannot be read"):
        pounding.read(tmp_path / "none.AT2")
    with pytest.raises(pounding.Refused, match="found none"):
        towers.run()


def test_extreme_what_is_no_number_is_refused() -> None:
    for gap in [float("nan"), float("inf")]:
        with pytest.raises(pounding.Refused, match="finite"):
            pounding.row(sdof(), sdof(), gap=gap)
    with pytest.raises(pounding.Refused):
        pounding.record(np.array([0.0, np.nan]), 0.01)
    with pytest.raises(TypeError):
        pounding.row(sdof(), sdof(), gap=object())


def test_extreme_an_unstable_step_is_refused_or_warned_of(towers, pulse) -> None:
    coarse = towers.replace(method={"central_difference": {"time_step_s": 0.2}}, duration_s=4.0)
    with pytest.raises(pounding.Refused, match="grows without bound"):
        coarse.run(pulse)
    fine = towers.replace(method={"central_difference": {"time_step_s": 0.05}}, duration_s=4.0)
    with pytest.warns(pounding.PoundingWarning):
        fine.run(pulse)


def test_issue_a_report_replaces_results_and_no_input(tmp_path) -> None:
    pulse = pounding.formula("ricker", amplitude=3.0, frequency=1.0, time_step=0.01)
    row = pounding.row(sdof(), sdof(period=0.4), gap=0.01, restitution=0.6, duration=2.0)
    out = tmp_path / "out"
    first = row.run(pulse).report(out, both=False)
    assert row.run(pulse).report(out, both=False) == first
    (out / "notes.txt").write_text("mine", encoding="utf-8")
    with pytest.raises(pounding.Refused, match="overwrite=True"):
        row.run(pulse).report(out, both=False)
    row.run(pulse).report(out, both=False, overwrite=True)
    assert (out / "notes.txt").read_text(encoding="utf-8") == "mine"
    inside = out / "history.csv"
    inside.write_text("time_s,acceleration_m_per_s2\n0,1\n0.1,-2\n0.2,1\n0.3,0\n", encoding="utf-8")
    read = pounding.read(inside)
    before = inside.read_bytes()
    with pytest.raises(pounding.Refused, match="cannot be made again"):
        row.run(read).report(out, both=False, overwrite=True)
    assert inside.read_bytes() == before


def test_limit_structures_in_a_list_are_refused() -> None:
    with pytest.raises(pounding.Refused, match="one by one"):
        pounding.row([pounding.sdof(mass=1e5, period=1.0)])


def test_limit_two_restitutions_are_refused() -> None:
    law = {"hertz_damp": {"impact_stiffness_n_per_m1_5": 1e9, "restitution": 0.5}}
    weak = pounding.sdof(mass=1e5, period=1.0)
    with pytest.raises(pounding.Refused, match="one of them"):
        pounding.row(weak, weak, gap=0.01, law=law, restitution=0.65)
