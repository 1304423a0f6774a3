"""Two elastic towers under a travelling ground motion, by power series with 36 digits.

Writes towers.csv: every impact of towers.json with an impulse of at least 1 N.s. Needs mpmath; takes two minutes.
It reads the scene and its record and shares nothing else with the program. Between samples, impacts and rest the equations are linear, so that
44 terms of their power series leave 1e-40.
"""

import csv
import json
import pathlib
import sys

from mpmath import mp, mpf, nstr

mp.dps = 36
TERMS = 44
# A pair whose impact has less speed comes to rest [m/s].
SLOWEST = mpf(10) ** -15
# Shorter times are none [s].
INSTANT = mpf(10) ** -26
LEAST_IMPULSE = 1.0
HERE = pathlib.Path(__file__).parent


def samples(record):
    """The ground accelerations [m/s2] that the program uses, in its own rounding, and their interval [s]."""
    lines = (HERE / record["file"]).read_text().splitlines()
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))[1:]
    gravity = record["gravity_m_per_s2"]
    in_si = [float(row[1]) * gravity for row in rows]
    factor = record["scale_to"]["pga_g"] * gravity / max(map(abs, in_si))
    if record["reversed"]:
        factor = -factor
    return [mpf(value * factor) for value in in_si], mpf(float(rows[1][0]) - float(rows[0][0]))


def value(series, time):
    total = mpf(0)
    for coefficient in reversed(series):
        total = total * time + coefficient
    return total


def derivative(series):
    return [n * coefficient for n, coefficient in enumerate(series)][1:]


def root(series, low, high):
    """The zero between two times at which the series has different signs."""
    slope, positive = derivative(series), value(series, low) > 0
    time = (low + high) / 2
    for _ in range(80):
        here = value(series, time)
        if (here > 0) == positive:
            low = time
        else:
            high = time
        following = time - here / value(slope, time)
        if not low <= following <= high:
            following = (low + high) / 2
        if abs(following - time) < mpf(10) ** -33:
            return following
        time = following
    return time


def first_negative(series, end, parts=24):
    """The first time at which a series that begins positive is negative, or None."""
    slope, before = derivative(series), mpf(0)
    for part in range(1, parts + 1):
        time = end * part / parts
        if value(series, time) < 0:
            return root(series, before, time)
        if value(slope, before) < 0 < value(slope, time):
            least = root(slope, before, time)
            if value(series, least) < 0:
                return root(series, before, least)
        before = time
    return None


class Tower:
    def __init__(self, building, arrival):
        storeys, rayleigh = building["storeys"], building["damping"]["rayleigh"]
        self.arrival = mpf(arrival)
        self.masses = [mpf(storey["mass_kg"]) for storey in storeys]
        self.stiffnesses = [mpf(storey["stiffness_n_per_m"]) for storey in storeys]
        self.alpha, self.beta = mpf(rayleigh["alpha_per_s"]), mpf(rayleigh["beta_s"])
        self.displacements = [mpf(0) for _ in storeys]
        self.velocities = [mpf(0) for _ in storeys]
        # Of the ground: displacement and velocity.
        self.moved, self.speed = mpf(0), mpf(0)

    def shake(self, time, motion, interval):
        """Ground acceleration from a time on, and its rate."""
        index = int(mp.floor((time - self.arrival) / interval + mpf(10) ** -25))
        if time < self.arrival or index + 1 >= len(motion):
            self.ground = (mpf(0), mpf(0))
            return
        rate = (motion[index + 1] - motion[index]) / interval
        since = time - (self.arrival + index * interval)
        self.ground = (motion[index] + rate * since, rate)

    def begin(self):
        self.series = [[x, v] for x, v in zip(self.displacements, self.velocities)]

    def accelerations(self, n):
        """Coefficients n of the floors' accelerations over the ground, without contact."""
        forces = [-self.alpha * mass * (n + 1) * x[n + 1] for mass, x in zip(self.masses, self.series)]
        for floor, stiffness in enumerate(self.stiffnesses):
            below = self.series[floor - 1] if floor else [mpf(0)] * (n + 2)
            drift, rate = (self.series[floor][k] - below[k] for k in (n, n + 1))
            storey = stiffness * (drift + self.beta * (n + 1) * rate)
            forces[floor] -= storey
            if floor:
                forces[floor - 1] += storey
        ground = self.ground[n] if n < 2 else mpf(0)
        return [force / mass - ground for force, mass in zip(forces, self.masses)]

    def go_on(self, time):
        self.displacements = [value(x, time) for x in self.series]
        self.velocities = [value(derivative(x), time) for x in self.series]
        start, rate = self.ground
        self.moved += time * (self.speed + time * (start / 2 + time * rate / 6))
        self.speed += time * (start + time * rate / 2)


class Row:
    def __init__(self, scene):
        self.motion, self.interval = samples(scene["record"])
        self.towers = [
            Tower(structure["building"], arrival)
            for structure, arrival in zip(scene["structures"], scene["arrivals_s"])
        ]
        contact = scene["contacts"][0]
        self.gap, self.floor = mpf(contact["gap_m"]), contact["levels"][0] - 1
        self.restitution = mpf(contact["law"]["stereomechanical"]["restitution"])
        self.end = mpf(scene["duration_s"])
        self.rests = False

    def instants(self):
        times = {self.end}
        for tower in self.towers:
            arriving = (tower.arrival + index * self.interval for index in range(len(self.motion)))
            times.update(time for time in arriving if time < self.end)
        return sorted(times)

    def begin(self, time):
        """Finds the series of both towers, of the force between them and of their gap."""
        left, right = self.towers
        for tower in self.towers:
            tower.shake(time, self.motion, self.interval)
            tower.begin()
        self.force = []
        for n in range(TERMS - 2):
            both = [tower.accelerations(n) for tower in self.towers]
            force = mpf(0)
            if self.rests:
                in_space = [
                    own[self.floor] + (tower.ground[n] if n < 2 else 0)
                    for own, tower in zip(both, self.towers)
                ]
                mobility = sum(1 / tower.masses[self.floor] for tower in self.towers)
                force = (in_space[0] - in_space[1]) / mobility
                both[0][self.floor] -= force / left.masses[self.floor]
                both[1][self.floor] += force / right.masses[self.floor]
            self.force.append(force)
            for tower, own in zip(self.towers, both):
                for series, acceleration in zip(tower.series, own):
                    series.append(acceleration / ((n + 1) * (n + 2)))
        self.gaps = [b - a for a, b in zip(left.series[self.floor], right.series[self.floor])]
        self.gaps[0] += self.gap + right.moved - left.moved
        self.gaps[1] += right.speed - left.speed
        self.gaps[2] += (right.ground[0] - left.ground[0]) / 2
        self.gaps[3] += (right.ground[1] - left.ground[1]) / 6

    def approach(self):
        left, right = self.towers
        return left.velocities[self.floor] + left.speed - right.velocities[self.floor] - right.speed

    def strike(self, restitution):
        left, right = self.towers
        mobility = sum(1 / tower.masses[self.floor] for tower in self.towers)
        impulse = (1 + restitution) * self.approach() / mobility
        left.velocities[self.floor] -= impulse / left.masses[self.floor]
        right.velocities[self.floor] += impulse / right.masses[self.floor]
        return impulse

    def run(self):
        """Yields time [s] and impulse [N.s] of every impact."""
        time, bounced = mpf(0), False
        for instant in self.instants():
            while instant - time > INSTANT:
                left = instant - time
                self.begin(time)
                if self.rests:
                    ahead = first_negative(self.force, left) if self.force[0] > 0 else mpf(0)
                else:
                    # Just after an impact the gap is 0: what it is divided by is the time.
                    ahead = first_negative(self.gaps[1:] if bounced else self.gaps, left)
                bounced = False
                for tower in self.towers:
                    tower.go_on(left if ahead is None else ahead)
                time = instant if ahead is None else time + ahead
                if ahead is None:
                    continue
                if self.rests:
                    self.rests = False
                    continue
                approach = self.approach()
                yield time, self.strike(self.restitution)
                bounced = True
                if approach < SLOWEST:
                    self.strike(mpf(0))
                    self.rests, bounced = True, False


def main():
    scene = json.loads((HERE / "towers.json").read_text())
    with open(HERE / "towers.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["start_s", "impulse_n_s"])
        for time, impulse in Row(scene).run():
            if impulse >= LEAST_IMPULSE:
                table.writerow([nstr(time, 20), nstr(impulse, 17)])
                print(nstr(time, 20), file=sys.stderr)


if __name__ == "__main__":
    main()
