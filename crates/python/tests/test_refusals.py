"""Wrong inputs are refused in the program's words, with their parts."""

import os
import pathlib
import pickle
import warnings

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


TWO = [[0.0, 0.0], [0.02, 1.0], [0.04, 0.0]]


@pytest.mark.parametrize(
    ("samples", "found"),
    [
        (np.array(TWO), "the shape (3, 2)"),
        (np.zeros((3, 1)), "the shape (3, 1)"),
        (1.0, "the shape ()"),
        ([[0.0], [1.0, 2.0]], "lists of different lengths"),
        (np.ma.masked_greater([0.0, 1.0, 2.0], 1.5), "1 masked values"),
        (np.array([0.0, 1.0j]), "complex128"),
        (np.array([0.0, None]), "object"),
        (np.array([True, False]), "bool"),
        (["0.1", "0.2"], "<U3"),
        (np.array(["2020-01-01"], dtype="datetime64[s]"), "datetime64"),
        (np.array([0, 12, -7]), "whole numbers (int64)"),
    ],
    ids=lambda one: one if isinstance(one, str) else "",
)
def test_issue_what_is_no_row_of_numbers_is_no_record(samples, found) -> None:
    """Two columns became one of twice the length, and masks and imaginary parts were lost."""
    with pytest.raises(pounding.Refused, match="acceleration: found") as caught:
        pounding.record(samples, 0.02)
    assert found in str(caught.value.found)


def test_issue_what_is_no_row_of_numbers_is_no_list_of_periods(pulse) -> None:
    assert len(pulse.spectrum_table([1, 2], 0.05)) == 2
    for wrong in [np.ones((2, 2)), np.ma.masked_equal([1.0, 2.0], 2.0), np.array([1.0j])]:
        with pytest.raises(pounding.Refused, match="periods: found"):
            pulse.spectrum_table(wrong)
        with pytest.raises(pounding.Refused, match="damping: found"):
            pulse.spectrum_table([1.0], wrong)


def test_issue_no_name_steers_a_terminal(pulse, tmp_path) -> None:
    """Output and warnings about a scene contained the control characters of its names."""
    escape = "\x1b[31m\u202e"
    towers = [pounding.sdof(mass=1e5, period=one, name=f"{escape}{one}") for one in (0.5, 1.0)]
    row = pounding.row(*towers, gap=0.01, restitution=0.6, name=escape, duration=3.0)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        run = row.replace(structures=[*towers, pounding.sdof(mass=1.0, period=1.0, name=escape)], contacts=None).run(pulse)
        told = [repr(row), repr(run), *(str(one.message) for one in caught), row._repr_html_()]
    with pytest.raises(pounding.Refused) as refused:
        row.replace(**{escape: 1})
    for text in [*told, repr(pounding.record([0.0, 1.0], 0.1, name=escape)), str(refused.value)]:
        assert "\x1b" not in text and "\u202e" not in text, repr(text)
    assert any("\\u001b[31m\\u202e" in text for text in told)


def test_limit_a_mask_that_hides_nothing_is_none() -> None:
    samples = np.ma.masked_greater([0.0, 1.0, 0.5], 1.5)
    assert pounding.record(samples, 0.02).acceleration.tolist() == [0.0, 1.0, 0.5]
    assert pounding.record(np.float32([0.0, 0.5]), 0.02).acceleration.tolist() == [0.0, 0.5]
    assert pounding.record(samples[::-1], 0.02).acceleration.tolist() == [0.5, 1.0, 0.0]


@pytest.mark.skipif(not pathlib.Path("/dev/zero").exists(), reason="devices of Unix")
def test_issue_what_is_no_regular_file_is_not_read(tmp_path) -> None:
    """A device was read until the memory was full, and the program waited for a pipe."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    long = tmp_path / "long.toml"
    with open(long, "wb") as file:
        file.truncate(65 << 20)
    binary = tmp_path / "binary.toml"
    binary.write_bytes(b"name = '\xff'")
    for path, found in [("/dev/zero", "a device"), (pipe, "a pipe"), (long, "longer than 64 MB"), (binary, "no UTF-8")]:
        with pytest.raises(pounding.Refused, match=found):
            pounding.scene(path)
    for path in ["/dev/zero", pipe]:
        with pytest.raises(pounding.Refused, match="a pipe or a device"):
            pounding.read(path)


def test_issue_a_file_that_is_missing_is_an_error_of_the_system(towers, pulse, tmp_path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text('name = "x"\nrecord.file = "none.csv"\nstructures = [{ wall = {} }]\n')
    for missing in [
        lambda: pounding.scene(tmp_path / "none.toml"),
        lambda: pounding.read(tmp_path / "none.AT2"),
        lambda: pounding.scene(scene).run(),
        lambda: towers.assess(tmp_path / "none"),
        lambda: towers.assess(pulse, target=tmp_path / "none.csv"),
        lambda: towers.assess(pulse, target="none.csv"),
        lambda: towers.required_gap(tmp_path / "none"),
        lambda: towers.sweep(gap=[0.01], records=tmp_path / "none"),
    ]:
        with pytest.raises(FileNotFoundError, match="cannot be read") as caught:
            missing()
        assert isinstance(caught.value, pounding.Refused)
        assert str(pickle.loads(pickle.dumps(caught.value))) == str(caught.value)


def deep(levels: int) -> dict:
    found: dict = {}
    for _ in range(levels):
        found = {"name": found}
    return found


def test_issue_no_dict_ends_in_an_internal_error(towers, pulse) -> None:
    cyclic: dict = {"name": "x"}
    cyclic["structures"] = [cyclic]
    weak = sdof()
    for wrong, words in [
        (lambda: towers.sweep_table(gap=[0.01], record=pulse, summary=5), "summary: found int"),
        (lambda: towers.sweep_table(gap=[0.01], record=pulse, summary={"by": 5}), "summary.by"),
        (lambda: towers.sweep_table(gap=[0.01], record=pulse, summary={"by": [5]}), "summary.by"),
        (lambda: towers.sweep_table(5, record=pulse), "vary: found int"),
        (lambda: pounding.scene(cyclic), "within itself"),
        (lambda: towers.replace(name=cyclic), "within itself"),
        (lambda: pounding.scene(deep(100_000)), "too deep"),
        (lambda: pounding.scene(deep(500)), "recursion limit"),
        (lambda: pounding.row({}), r"structures\[0\]: found a dict of 0 entries"),
        (lambda: pounding.row({"sdof": 5}), r"structures\[0\].sdof: found int"),
        (lambda: pounding.building([5]), r"storeys\[0\]: found int"),
        (lambda: pounding.row(weak, weak, gap=0.01, law={"hertz": 5}, restitution=0.5), "law.hertz: found int"),
        (lambda: pounding.row(weak, weak, gap=0.01, law=5, restitution=0.5), "law: found int"),
        (lambda: pounding.scene({("a", 1): 2}), "keys must be"),
        (lambda: pounding.scene({"name": "\udcff"}), "is Unicode"),
    ]:
        with pytest.raises((pounding.Refused, TypeError), match=words):
            wrong()


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


def test_issue_a_misspelt_field_of_a_storey_is_refused_at_once() -> None:
    """It was refused by the row, with the number of a structure that nobody counts."""
    with pytest.raises(pounding.Refused, match="perhaps `mass_kg` is meant") as caught:
        pounding.building([{"mas": 3e5, "stiffness": 2e8}])
    assert caught.value.place == "storeys[0].mas" and str(caught.value).startswith("storeys[0].mas: found the field `mas`")
    with pytest.raises(pounding.Refused, match="perhaps `period_s` is meant"):
        pounding.building([{"mass": 3e5}], perod=1.0)
