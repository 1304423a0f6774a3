"""ObsPy is the second route for miniSEED and SAC: it writes files that this package reads."""

import numpy as np
import pounding
import pytest

obspy = pytest.importorskip("obspy")

RATE = 200.0
G = 9.80665


def counts(kind: str) -> np.ndarray:
    """Whole numbers with small and large differences, which need every packing of Steim."""
    random = np.random.default_rng(7)
    steps = random.normal(size=4000) * np.repeat(10.0 ** random.uniform(0, 5, 40), 100)
    largest = 3e4 if kind == "INT16" else 1e6
    wave = np.cumsum(steps)
    return np.round(wave / np.abs(wave).max() * largest).astype(np.int16 if kind == "INT16" else np.int32)


def trace(values: np.ndarray, channel: str = "HNE"):
    header = {"network": "XX", "station": "TEST", "channel": channel, "sampling_rate": RATE}
    return obspy.Trace(values, header)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("kind", ["STEIM1", "STEIM2", "INT16", "INT32"])
def test_reference_miniseed_of_counts(kind: str, order: str, tmp_path) -> None:
    wanted = counts(kind)
    path = tmp_path / "counts.mseed"
    trace(wanted).write(str(path), format="MSEED", encoding=kind, byteorder=order)
    read = pounding.read(path, unit="m_per_s2", per_count=1e-4)
    assert read.dt == 1 / RATE
    np.testing.assert_array_equal(read.acceleration, wanted * 1e-4)


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("kind", ["FLOAT32", "FLOAT64"])
def test_reference_miniseed_of_floats(kind: str, order: str, tmp_path) -> None:
    wanted = counts("STEIM2").astype(np.float32 if kind == "FLOAT32" else np.float64) / 7
    path = tmp_path / "floats.mseed"
    trace(wanted).write(str(path), format="MSEED", encoding=kind, byteorder=order)
    read = pounding.read(path, unit="m_per_s2")
    np.testing.assert_array_equal(read.acceleration, wanted.astype(np.float64))


@pytest.mark.parametrize("order", ["<", ">"])
def test_reference_sac(order: str, tmp_path) -> None:
    wanted = (counts("STEIM2") / 7e5).astype(np.float32)
    path = tmp_path / "one.sac"
    trace(wanted).write(str(path), format="SAC", byteorder=order)
    read = pounding.read(path, unit="g")
    assert read.dt == pytest.approx(1 / RATE, rel=1e-6)
    np.testing.assert_allclose(read.acceleration, wanted.astype(np.float64) * G, rtol=1e-15)


def test_reference_several_channels(tmp_path) -> None:
    stream = obspy.Stream([trace(counts("STEIM2") // (index + 1), channel) for index, channel in enumerate(["HNE", "HNN", "HNZ"])])
    path = tmp_path / "three.mseed"
    stream.write(str(path), format="MSEED", encoding="STEIM2", byteorder="<")
    for index, channel in enumerate(["HNE", "HNN", "HNZ"]):
        read = pounding.read(path, unit="m_per_s2", per_count=1e-4, component=channel)
        np.testing.assert_array_equal(read.acceleration, (counts("STEIM2") // (index + 1)) * 1e-4)
