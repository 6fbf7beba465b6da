"""Writes flip.json: what the program of FLIP's authors says of pictures that are made by formula.

    python3 -m venv venv && venv/bin/pip install flip-evaluator==1.7 numpy
    venv/bin/python flip.py > flip.json

The same formulas stand in tests/tests/metrics/pictures.rs; main.rs beside it compares.
"""

import json

import flip_evaluator
import numpy as np

WIDTH, HEIGHT = 64, 48
MASK = (1 << 64) - 1
# What `Rng::new` has for a stream without a purpose: the basis of FNV-1a.
PURPOSE = 0xCBF29CE484222325
SAMPLED = [(0, 0), (63, 47), (20, 11), (33, 24), (40, 30), (7, 40)]


def stream(seed, count):
    """`count` numbers in 0 .. 1 of SplitMix64, as the harness draws them."""
    state, found = seed ^ PURPOSE, []
    for _ in range(count):
        state = (state + 0x9E3779B97F4A7C15) & MASK
        z = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        found.append(((z ^ (z >> 31)) >> 11) * 2.0**-53)
    return np.array(found)


def colours(*channels):
    return np.stack(np.broadcast_arrays(*channels), axis=-1).astype(np.float32)


X, Y = np.meshgrid(np.arange(WIDTH), np.arange(HEIGHT))
U, V = (X + 0.5) / WIDTH, (Y + 0.5) / HEIGHT


def noise(seed):
    return stream(seed, 3 * WIDTH * HEIGHT).reshape(HEIGHT, WIDTH, 3)


def checkers(shift):
    white = ((X + shift) // 8 + Y // 8) % 2
    return colours(0.1 + 0.8 * white, 0.1 + 0.6 * white, 0.2 + 0.3 * white)


def ramp(gain):
    light = np.exp2(16.0 * U - 8.0) * gain
    return colours(light, light * (0.5 + 0.5 * V), 0.25 * light)


def fireflies(seed, gain):
    light = noise(seed) ** 4
    return (light * np.where(noise(seed + 1)[..., :1] < 0.02, gain, 1.0)).astype(np.float32)


def dark(gain):
    return colours(*(np.where(Y < 30, 0.0, channel * gain) for channel in (U, V, 1.0)))


PICTURES = {
    "gradient": lambda: colours(U, V, 1.0 - U),
    "gradient darkened": lambda: colours(0.9 * U, 0.9 * V, 0.9 * (1.0 - U)),
    "gradient turned": lambda: colours(V, 1.0 - U, U),
    "noise 1": lambda: noise(1).astype(np.float32),
    "noise 2": lambda: noise(2).astype(np.float32),
    "checkers": lambda: checkers(0),
    "checkers shifted": lambda: checkers(3),
    "ramp": lambda: ramp(1.0),
    "ramp bent": lambda: ramp(0.8 + 0.4 * V),
    "fireflies": lambda: fireflies(3, 100.0),
    "no fireflies": lambda: fireflies(3, 1.0),
    "dark": lambda: dark(1.0),
    "dark brightened": lambda: dark(1.3),
}

LOW = [
    ("gradient darkened", "gradient"),
    ("gradient turned", "gradient"),
    ("noise 1", "noise 2"),
    ("noise 1", "gradient"),
    ("checkers shifted", "checkers"),
    ("checkers", "checkers"),
]
HIGH = [
    ("ramp bent", "ramp"),
    ("fireflies", "no fireflies"),
    ("no fireflies", "fireflies"),
    ("dark brightened", "dark"),
]


def case(picture, truth, high, pixels_per_degree, tone_map="aces"):
    found, _, used = flip_evaluator.evaluate(
        PICTURES[truth](),
        PICTURES[picture](),
        "HDR" if high else "LDR",
        inputsRGB=False,
        applyMagma=False,
        parameters={"ppd": pixels_per_degree} | ({"tonemapper": tone_map} if high else {}),
    )
    row = {"picture": picture, "truth": truth, "pixels_per_degree": pixels_per_degree}
    if high:
        row |= {"tone_map": tone_map, "exposures": [used["startExposure"], used["stopExposure"]]}
        row |= {"count": used["numExposures"]}
    values = found[..., 0].astype(np.float64)
    return row | {
        "mean": round(float(values.mean()), 7),
        "max": round(float(values.max()), 6),
        "pixels": [[x, y, round(float(values[y, x]), 6)] for x, y in SAMPLED],
    }


rows = [case(*pair, False, ppd) for pair in LOW for ppd in (67.02064, 30.0)]
rows += [case(*pair, True, 67.02064, curve) for pair in HIGH for curve in ("aces", "hable", "reinhard")]
rows += [case(*HIGH[0], True, 20.0)]
print("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]")
