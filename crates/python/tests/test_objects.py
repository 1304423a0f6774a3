"""Objects work as in Python: they compare, can be pickled, do not change, and hold no second copy."""

import pickle
import re
import signal
import subprocess
import sys
import textwrap
import threading
import time
import warnings

import numpy as np
import polars
import pounding
import pyarrow
import pytest
from conftest import ROOT

RECORD = next((ROOT / "studies" / "records").glob("*.csv"))


def test_reference_the_four_lines() -> None:
    record = pounding.read(RECORD)
    weak, stiff = (
        pounding.sdof(mass=75e3, period=1.2, damping=0.05),
        pounding.sdof(mass=3e6, period=0.3, damping=0.05),
    )
    run = pounding.row(weak, stiff, gap=0.03, restitution=0.65).run(record)
    assert len(run.impacts) == run.pairs["collisions"].sum() > 0
    # An impact transfers the momentum (1+e) m v₀ with the reduced mass m.
    reduced = 1.0 / (1.0 / 75e3 + 1.0 / 3e6)
    first = run.impacts.iloc[0]
    impulse = 1.65 * reduced * first["approach_speed_m_per_s"]
    assert first["impulse_n_s"] == pytest.approx(impulse, rel=1e-12)


def test_limit_a_large_record_is_no_copy() -> None:
    samples = 0.1 * np.sin(np.arange(1_000_000) * 0.01)
    record = pounding.record(samples, 0.01)
    views = [record.acceleration for _ in range(2)]
    addresses = {view.__array_interface__["data"][0] for view in views}
    assert len(addresses) == 1, "both look at the same memory"
    assert not views[0].flags.owndata and not views[0].flags.writeable
    assert np.array_equal(views[0], samples)
    del record
    assert views[0][-1] == samples[-1], "a view keeps the memory"
    with pytest.raises(ValueError):
        views[0][0] = 1.0


def test_limit_histories_agree_with_peaks(towers, pulse) -> None:
    run = towers.run(pulse)
    assert run.displacement.shape == (len(run.time), 2)
    largest = np.abs(run.displacement).max(axis=0)
    peaks = np.abs(run.peaks["peak_displacement_m"].to_numpy())
    assert np.all(largest <= peaks * (1 + 1e-12)) and np.allclose(largest, peaks, rtol=1e-3)
    gap = 0.03 + run.displacement[:, 1] - run.displacement[:, 0]
    assert np.allclose(run.opening[:, 0], gap, atol=1e-15)
    assert run.time[-1] <= run.summary["method"]["duration_s"] + 1e-9


def test_limit_pickles_are_equal(towers, pulse) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        for one in [
            towers,
            pulse,
            pulse.using(scale=2.0),
            pounding.read(RECORD),
            pounding.record(np.array([0.0, 1.0, 0.0]), 0.1),
            pounding.scene(ROOT / "studies" / "examples" / "two-structures.json"),
            towers.run(pulse),
        ]:
            other = pickle.loads(pickle.dumps(one))
            assert other == one and hash(other) == hash(one)
            assert type(other) is type(one)
    assert pulse != pulse.using(scale=2.0)
    assert towers != towers.replace(name="other")


def test_limit_tables_go_to_arrow_and_polars(towers, pulse) -> None:
    run = towers.run(pulse)
    for name in ["impacts", "peaks", "pairs"]:
        table = run.table(name)
        ours = getattr(run, name)
        theirs = polars.DataFrame(table)
        assert theirs.columns == list(ours.columns)
        assert theirs.height == len(ours) == len(table)
        arrow = pyarrow.table(table)
        for column in ours.select_dtypes("number"):
            mine = ours[column].to_numpy()
            other = arrow[column].to_pandas().to_numpy(dtype=mine.dtype)
            assert np.array_equal(mine, other, equal_nan=mine.dtype.kind == "f")


def test_limit_threads_give_the_same_bits(towers, pulse) -> None:
    wanted = towers.run(pulse).summary
    found = []
    threads = [threading.Thread(target=lambda: found.append(towers.run(pulse).summary)) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [wanted] * 8


LONG = """
    import pounding, time, threading
    row = pounding.row(*[pounding.sdof(mass=1e5, period=0.3 + 0.01 * i) for i in range(20)], gap=0.001, restitution=0.9)
    noise = pounding.formula("stochastic", ground="firm", pga=5.0, strong_from=2.0, strong_until=90.0, decay=0.4,
                             duration=100.0, time_step=0.005, seed=1)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="signals of Unix")
def test_issue_ctrl_c_stops_a_run() -> None:
    code = textwrap.dedent(LONG) + textwrap.dedent("""
        print("ready", flush=True)
        try:
            row.sweep({"structures[0].sdof.mass_kg": [1e5 + i for i in range(2000)]}, record=noise)
        except KeyboardInterrupt:
            print("stopped", flush=True)
    """)
    child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True)
    assert child.stdout is not None and child.stdout.readline() == "ready\n"
    time.sleep(2.0)
    begin = time.monotonic()
    child.send_signal(signal.SIGINT)
    assert child.stdout.read() == "stopped\n"
    child.wait(timeout=10)
    assert time.monotonic() - begin < 5.0


def test_limit_others_work_while_a_run_waits(towers) -> None:
    noise = pounding.formula(
        "stochastic", ground="firm", pga=5.0, strong_from=2.0, strong_until=30.0, decay=0.4, duration=40.0, time_step=0.005, seed=1
    )
    counted = 0
    run = threading.Thread(target=lambda: towers.sweep(gap=np.linspace(0.0, 0.05, 200), record=noise))
    run.start()
    while run.is_alive():
        counted += 1
        time.sleep(0.001)
    assert counted > 20, "the interpreter was free"


def test_limit_progress_is_told(towers, pulse) -> None:
    told = []
    table = towers.sweep(gap=np.linspace(0.0, 0.05, 3000), record=pulse, progress=lambda *now: told.append(now))
    assert len(table) == 3000
    assert all(0 < done <= of == 3000 for done, of in told)


def test_issue_what_progress_raises_ends_the_sweep(towers, pulse) -> None:
    def fails(done: int, of: int) -> None:
        raise RuntimeError("enough")

    noise = pounding.formula(
        "stochastic", ground="firm", pga=5.0, strong_from=2.0, strong_until=30.0, decay=0.4, duration=40.0, time_step=0.005, seed=1
    )
    with pytest.raises(RuntimeError, match="enough"):
        towers.sweep(gap=np.linspace(0.0, 0.05, 3000), record=noise, progress=fails)


def test_limit_an_array_sweeps_as_it_runs(towers, pulse) -> None:
    array = pounding.record(pulse.acceleration, pulse.dt)
    same = pounding.record(array.acceleration, array.dt)
    assert same == array
    for record in (pulse, array):
        table = towers.sweep(gap=[0.03], record=record)
        peak = towers.run(record).peaks["peak_displacement_m"][0]
        assert table.iloc[0]["structure 1: peak_displacement_m"] == pytest.approx(peak, rel=1e-9)


def test_limit_records_at_hand_are_a_folder(towers, tmp_path) -> None:
    record = pounding.read(RECORD)
    (tmp_path / RECORD.name).write_bytes(RECORD.read_bytes())
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        folder, hand = towers.required_gap(tmp_path), towers.required_gap([record])
    assert folder.drop(columns="record").equals(hand.drop(columns="record"))


def test_reference_notebooks_show_a_sketch_and_a_sentence(towers, pulse) -> None:
    run = towers.run(pulse)
    html = run._repr_html_()
    assert "<svg" in html and "floors touch" in html
    assert "<svg" in towers._repr_html_()
    assert "Record ricker" in repr(pulse)
    assert "line" in repr(pounding.read(RECORD)), "says from which line"
    assert run.plot().axes


def test_reference_compare_stands_side_by_side(towers, pulse) -> None:
    wide = towers.replace(name="wide", contacts=[{"gap_m": 0.5, "law": {"stereomechanical": {"restitution": 0.65}}}])
    table = pounding.compare([towers.run(pulse), wide.run(pulse)])
    assert list(table.columns) == ["row", "wide"]
    collisions = table.loc[("gap", 0, 1, "collisions")]
    assert collisions["row"] > 0 and collisions["wide"] == 0


def test_limit_a_path_is_its_record(towers, tmp_path) -> None:
    (tmp_path / "pulse.csv").write_text("time_s,acceleration_m_per_s2\n" + "".join(f"{0.1 * i!r},{i % 3}.0\n" for i in range(50)))
    path = str(tmp_path / "pulse.csv")
    record = pounding.read(path)
    assert towers.run(path) == towers.run(record) == towers.under(path).run()
    assert towers.required_gap(record).equals(towers.required_gap([path]))
    assert towers.sweep(gap=[0.01, 0.02], record=path).equals(towers.sweep(gap=[0.01, 0.02], record=record))


def test_limit_a_gap_is_replaced(towers, pulse) -> None:
    wider = towers.replace(gap=0.13)
    assert wider.to_dict()["contacts"][0]["gap_m"] == 0.13
    assert wider.replace(gap=0.03).run(pulse).impacts.equals(towers.run(pulse).impacts)


def test_limit_the_lowest_storey_has_a_drift(pulse) -> None:
    storeys = [{"mass": 1e5, "stiffness": 2e8, "height": 3.0}] * 2
    beside = pounding.sdof(mass=3e6, period=0.3, height=3.0)
    row = pounding.row(pounding.building(storeys), beside, gap=0.03)
    run = row.run(pulse)
    peaks = run.peaks
    assert peaks.loc[peaks["storey"] == 1, "peak_drift_m"].notna().all()
    largest = abs(run.drift).max(axis=0)
    assert largest == pytest.approx(peaks["peak_drift_m"].abs(), rel=1e-2)


def test_limit_a_notebook_shows_a_plot(towers, pulse) -> None:
    assert towers.run(pulse).plot()._repr_png_().startswith(b"\x89PNG")


def test_limit_values_far_from_usual_warn(pulse) -> None:
    row = pounding.row(pounding.sdof(mass=1e5, period=1.0, damping=5), pounding.sdof(mass=1e5, period=0.5), gap=0.02)
    with pytest.warns(pounding.PoundingWarning, match="500 %"):
        row.run(pulse)


def test_issue_components_of_one_event_are_one_event(towers, pulse) -> None:
    one, other = (pounding.record(sign * pulse.acceleration, pulse.dt, name=f"ABC-{end}") for sign, end in [(1, "EW"), (2, "NS")])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        assert towers.assess([one, other]).facts["events"] == 1
        alike = towers.assess([one, one.using(scale=3.0), other])
        assert [motion["record"] for motion in alike.facts["motions"][::2]] == ["1-ABC-EW", "ABC-EW", "ABC-NS"]


def test_issue_an_assessment_says_what_the_program_does(towers, pulse) -> None:
    with pytest.warns(pounding.PoundingWarning, match="not scaled") as told:
        found = towers.assess([pulse])
    assert [str(one.message) for one in told] == [*found.warnings, *found.remarks]
    # What makes the answer doubtful stands before it.
    assert "not scaled" in found.sentences[0]
    assert found.answers == found.facts["answers"] and found.sentences[1 : 1 + len(found.answers)] == found.answers
    said = [*found.sentences, *found.motions, *found.warnings, *found.remarks]
    assert len(found.sentences) > 1 and all(line in repr(found) for line in said)


def test_issue_a_gap_between_floors_and_columns_is_computed(pulse) -> None:
    # "The width that they need is not known", although it needs no contact model.
    low = pounding.building([{"mass": 1e5, "stiffness": 2e8, "height": 3.0}], name="low")
    other = pounding.building([{"mass": 1e5, "stiffness": 1e8, "height": 4.5}], name="other")
    row = pounding.row(low, other, gap=0.03)
    with pytest.warns(pounding.PoundingWarning, match="a floor that hits a column can bring a building down"):
        found = row.required_gap([pulse])
    assert (found["required_m"] > 0).all() and found["at_column"].all()
    # The column follows its floor at 4.5 m in part.
    assert (found["required_m"] <= found["abs_m"] * (1 + 1e-9)).all()
    for rule in ["ntc_2018_m", "is_1893_m", "tbdy_2018_m", "e_030_2018_m", "gb_50011_m"]:
        assert found[rule].notna().all()
    # A run lets the floor hit the column.
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        pairs = row.run(pulse).pairs
    assert list(pairs["left"]) == ["low, floor 1"] and list(pairs["right"]) == ["other, column of storey 1"]


def test_issue_tables_name_building_and_level(towers, pulse) -> None:
    run = towers.run(pulse)
    assert list(run.peaks["building"]) == [structure["sdof"]["name"] for structure in towers.to_dict()["structures"]]
    assert set(run.impacts["level"]) == set(run.pairs["level"]) == {1}
    assert set(run.impacts["contact"]) == {0}


def fifteen() -> pounding.Scene:
    nine = pounding.building([{"mass": 3e5, "stiffness": 2e8, "height": 3.1, "yield_force": 2e6, "repeat": 9}], name="nine")
    six = pounding.building([{"mass": 2.6e5, "stiffness": 4e8, "height": 3.1, "repeat": 6}], name="six")
    return pounding.row(nine, six, gap=0.05, restitution=0.65)


def test_issue_a_plot_of_fifteen_storeys_is_a_profile(towers, pulse) -> None:
    """Fifteen curves over time stood below a legend that covered both panels."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        profiles, gaps = fifteen().run(pulse).plot().axes
    assert [line.get_label() for line in profiles.lines] == ["nine", "six"]
    assert [len(line.get_ydata()) for line in profiles.lines] == [9, 6]
    assert len(gaps.lines) == 6 + 1
    few, _ = towers.run(pulse).plot().axes
    assert len(few.lines) == 2 and few.get_xlabel() == "time [s]"
    for axes in (profiles, gaps, few):
        box = axes.get_legend().get_bbox_to_anchor().transformed(axes.transAxes.inverted())
        assert box.x0 > 1.0, "the legend stands beside the panel"


def test_issue_tables_and_assessments_are_drawn(towers, pulse) -> None:
    """Only a run had a figure."""
    records = [pounding.formula("ricker", amplitude=2.0 + one, frequency=0.5 + 0.2 * one, time_step=0.01) for one in range(4)]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pounding.PoundingWarning)
        (assessed,) = towers.assess(records).plot().axes
        required = towers.required_gap(records)
    (drawn,) = pounding.plot_required_gap(required).axes
    widest = 1e3 * required["required_m"].max()
    for axes in (assessed, drawn):
        assert axes.lines[0].get_xdata()[-2] == pytest.approx(widest)
    swept = towers.sweep(gap=[0.01, 0.02, 0.03], record=pulse)
    peak = next(name for name in swept.columns if str(name).endswith("peak_displacement_m"))
    (axes,) = pounding.plot_sweep(swept, "contacts[*].gap_m", peak).axes
    assert len(axes.lines[0].get_xdata()) == 3
    with pytest.raises(pounding.Refused, match="x: found `gap`, allowed are the columns"):
        pounding.plot_sweep(swept, "gap", peak)
    force = next(name for name in swept.columns if str(name).endswith("peak_force_n"))
    with pytest.raises(pounding.Refused, match="without a number"):
        pounding.plot_sweep(swept, "contacts[*].gap_m", force)


def test_issue_effects_are_a_table(towers, pulse) -> None:
    """They were dicts in dicts."""
    found = towers.effects(pulse)
    assert list(found["reversed"]) == [False, False, True, True] and set(found["storey"]) == {1}
    ratio = found["peak_drift_m"] / found["peak_drift_alone_m"]
    assert np.allclose(found["drift_amplification"], ratio, rtol=1e-9)
    assert (found["drift_amplification_low"] <= found["drift_amplification_high"]).all()


def test_issue_a_loop_warns_once(pulse) -> None:
    """Fifteen runs of a loop printed the same sentence fifteen times, each with another number."""
    row, strong = fifteen(), pulse.using(scale=3.0)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("default")
        runs = [row.replace(gap=gap).run(strong) for gap in (0.05, 0.06, 0.07)]
    with warnings.catch_warnings(record=True) as each:
        warnings.simplefilter("always")
        for gap in (0.05, 0.06, 0.07):
            row.replace(gap=gap).run(strong)
    assert 0 < len(told) < len(each) == sum(len(run.warnings) for run in runs)
    kinds = {re.sub(r"[0-9.]+", "", str(one.message)) for one in told}
    assert len(kinds) == len(told)
