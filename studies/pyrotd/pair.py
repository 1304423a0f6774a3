"""RotD00, RotD50 and RotD100 of a smooth pair by the package pyrotd (`pip install pyrotd "setuptools<80"`): python pair.py > pair.csv

pyrotd takes the motion as band-limited, `pounding` as straight lines between samples. Below 1.2 Hz with samples every 0.25 ms both
are one motion to 3e-7. Zeros behind the motion let the responses die away before the transform repeats them. Responses are taken 8 000
times a period, and in directions 0.01 degrees apart; percentiles are those of straight lines between the directions. pyrotd multiplies by the ratio of the numbers of frequencies, where the ratio of the lengths is
meant: 5e-6 too little for this motion, which is put right here.
"""

import numpy as np
import pyrotd

STEP, MOTION, LENGTH = 0.25e-3, 6.0, 90.0
ANGLES = np.arange(0.0, 180.0, 0.01)


def motion(time):
    window = np.where(time < MOTION, np.sin(np.pi * time / MOTION) ** 2, 0.0)
    first = np.sin(2 * np.pi * 1.2 * time) + 0.5 * np.cos(2 * np.pi * 0.7 * time)
    second = 0.8 * np.sin(2 * np.pi * 0.9 * time + 0.4)
    return window * first, window * second


def percentile(peaks, part):
    """The value below which peaks lie in this part of all directions, straight lines between them."""
    ends = np.append(peaks, peaks[0])
    low, high = np.minimum(ends[:-1], ends[1:]), np.maximum(ends[:-1], ends[1:])

    def below(value):
        return np.mean(np.clip((value - low) / np.maximum(high - low, 1e-300), 0.0, 1.0))

    least, largest = low.min(), high.max()
    for _ in range(60):
        middle = 0.5 * (least + largest)
        least, largest = (middle, largest) if below(middle) < part else (least, middle)
    return middle


def main():
    time = STEP * np.arange(round(LENGTH / STEP))
    amplitudes = [np.fft.rfft(one) for one in motion(time)]
    frequencies = np.linspace(0, 0.5 / STEP, num=amplitudes[0].size)
    print("period_s,damping_ratio,rotd00_m_per_s2,rotd50_m_per_s2,rotd100_m_per_s2")
    for period, damping in [(0.3, 0.05), (0.7, 0.05), (1.0, 0.05), (1.0, 0.2)]:
        of = [
            pyrotd.calc_oscillator_resp(frequencies, one, damping, 1 / period, max_freq_ratio=4000)
            for one in amplitudes
        ]
        n, m = frequencies.size, of[0].size // 2 + 1
        of = [one * ((m - 1) / (n - 1)) / (m / n) for one in of]
        # No direction has its peak where both components together are below the least peak of one.
        both = np.vstack(of)
        both = both[:, np.hypot(*both) >= 0.1 * np.abs(both).max(axis=1).min()]
        peaks = []
        for angle in ANGLES:
            found = pyrotd.calc_rotated_percentiles(both, [angle], [100], method="rigorous")
            peaks.append(found.spec_accel[0])
        peaks = np.array(peaks)
        values = [peaks.min(), percentile(peaks, 0.5), peaks.max()]
        print(",".join([repr(period), repr(damping), *(f"{value:.9e}" for value in values)]), flush=True)


if __name__ == "__main__":
    main()
