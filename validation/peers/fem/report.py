"""One line of JSON for a run of a Python program."""

import json
import resource
import time

RADIUS, HEIGHT, PRESS = 291.5e-6, 198e-6, 1e-3
YOUNG, POISSON = 1e6, 0.49
LAMBDA = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
MU = YOUNG / (2 * (1 + POISSON))


class Clock:
    """Processor seconds between marks; equal to wall-clock seconds where one thread has a core to itself."""

    def __init__(self):
        self.last = self.begin = time.process_time()
        self.parts = {}

    def mark(self, name):
        now = time.process_time()
        self.parts[name] = now - self.last
        self.last = now

    def print(self, unknowns, value):
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1000
        total = self.last - self.begin
        print(json.dumps({"unknowns": int(unknowns), "value": float(value), "seconds": total, **self.parts, "peak_mb": peak}))


def apparent_modulus(twice_energy):
    """E_a / E of the rubber disc from a(u, u) (J): force = a(u, u) / displacement of the plate."""
    import math

    force = twice_energy / (PRESS * HEIGHT)
    return force / (math.pi * RADIUS**2 * PRESS * YOUNG)
