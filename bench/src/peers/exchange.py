"""Scenes as the benchmark writes them."""

import json

import numpy as np


class Law:
    """Scenes of a law: kind 0 is impact with restitution a, 1 the nonlinear viscoelastic element with beta a and xi b."""

    def __init__(self, words):
        self.name = words["name"]
        self.kind, self.a, self.b = words["kind"], words["a"], words["b"]
        # Of two structures a row each: masses, stiffnesses, dampings of both, and the gap. Of towers their storeys, and the gap.
        scenes = words["scenes"]
        self.scenes = scenes if isinstance(scenes[0], dict) else np.array(scenes)


class Study:
    """The ground motion, linear between samples, and the scenes of every law."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            words = json.load(file)
        self.duration, self.ground_step = words["duration"], words["ground_step"]
        self.ground = np.array(words["ground"])
        self.laws = {law["name"]: Law(law) for law in words["laws"]}


def sampled(study, step):
    """Acceleration at the nodes of a time step."""
    nodes = np.arange(round(study.duration / step) + 1) * step
    return np.interp(nodes, study.ground_step * np.arange(len(study.ground)), study.ground)
