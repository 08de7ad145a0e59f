"""What is hidden in a recording at rest, by laws that the diagnosis does not have.

A law takes the rows of a recording and one number and gives what is added to the response, in its unit, an array of shape (rows,). The number is chosen by `injected.py`.
Each kind has the names of the library that a fair judge would call right.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

HOUR, DAY = 3600.0, 86400.0


@dataclass(frozen=True)
class Rows:
    """A recording as a law sees it."""

    time: np.ndarray | None  # s, shape (rows,)
    signal: np.ndarray  # what the base model gives, calibrated; unit of the response, shape (rows,)
    driver: np.ndarray | None  # temperature, or a driver that is not in the base model
    where: float  # where in the recording something happens, from 0 to 1

    def phase(self):
        """Time from 0 at the first row to 1 at the last."""
        return (self.time - self.time[0]) / np.ptp(self.time)


@dataclass(frozen=True)
class Kind:
    name: str
    law: Callable[[Rows, float], np.ndarray]
    right: tuple[str, ...]
    needs: frozenset[str]
    largest: float  # of the number; where it would have to be larger, the kind does not fit this recording
    linear: bool = True  # what is added grows as the number does


def first_order(values, time, constant):
    """Follows `values` with a time constant, both in s; a straight line between the rows (exact for it)."""
    late = np.array(values, dtype=float)
    for k in range(1, len(late)):
        step = (time[k] - time[k - 1]) / constant
        kept = np.exp(-step)
        slope = (values[k] - values[k - 1]) / step if step > 0 else 0.0
        late[k] = values[k] - slope + (late[k - 1] - values[k - 1] + slope) * kept
    return late


def slab(values, time, constant):
    """Mean temperature of a slab whose surface follows `values` (Carslaw & Jaeger, Conduction of Heat in Solids, 2nd ed., 3.3): five of its first-order parts."""
    orders = 2 * np.arange(5) + 1
    weights = 1.0 / orders**2
    weights /= weights.sum()
    return sum(weight * first_order(values, time, constant / order**2) for weight, order in zip(weights, orders))


def late_as_a_slab(rows, constant):
    return slab(rows.signal, rows.time, constant) - rows.signal


def late_by_a_time(rows, delay):
    return np.interp(rows.time - delay, rows.time, rows.signal) - rows.signal


def gain_fouls(rows, size):
    """Dirt that slows its own growth: logarithm of the time."""
    return -size * rows.signal * np.log1p(5.0 * rows.phase()) / np.log(6.0)


def gain_jumps(rows, size):
    return size * rows.signal * (rows.phase() > rows.where)


def zero_creeps(rows, size):
    """A stretched exponential (Kohlrausch), exponent 0.6."""
    return size * (1.0 - np.exp(-((rows.phase() / 0.4) ** 0.6)))


def zero_jumps(rows, size):
    return size * (rows.phase() > rows.where)


def characteristic_bends(rows, size):
    """Exponential over the span of the signal."""
    middle = (rows.signal - rows.signal.mean()) / np.ptp(rows.signal)
    return size * np.ptp(rows.signal) * (np.expm1(1.5 * middle) - 1.5 * middle)


def characteristic_saturates(rows, size):
    """A hyperbola (Langmuir) above the middle of the signal."""
    above = np.maximum(rows.signal - rows.signal.min() - 0.5 * np.ptp(rows.signal), 0.0)
    return -above * (1.0 - 1.0 / (1.0 + size * above / np.ptp(rows.signal)))


def friction_of_dahl(rows, size):
    """Dahl's friction against the motion of the signal, in full after a twentieth of its span (Dahl, AIAA Journal 14 (1976) 1675)."""
    force, stiffness = np.zeros(len(rows.signal)), 20.0 / np.ptp(rows.signal)
    for k in range(1, len(force)):
        moved = rows.signal[k] - rows.signal[k - 1]
        kept = np.exp(-stiffness * abs(moved))
        force[k] = np.sign(moved) * (1.0 - kept) + force[k - 1] * kept
    return -size * np.ptp(rows.signal) * force


def follows_the_driver(rows, size):
    """A straight line with a small exponential bend."""
    middle = (rows.driver - rows.driver.mean()) / np.ptp(rows.driver)
    return size * np.expm1(0.5 * middle)


def gain_follows_the_driver(rows, size):
    middle = (rows.driver - rows.driver.mean()) / np.ptp(rows.driver)
    return size * rows.signal * np.expm1(0.5 * middle)


def day_of_sun(rows, size):
    """Light of the day: a half sine of twelve hours, and dark nights."""
    return size * np.maximum(np.sin(2.0 * np.pi * (rows.time / DAY - rows.where)), 0.0)


def relaxes(rows, constant):
    """Overshoots by a third and fades, as a slab does."""
    return (rows.signal - slab(rows.signal, rows.time, constant)) / 3.0


LATE = ("slow_response", "readout_lag", "thermal_lag", "late_driver")
DRIVER = ("driver_coefficient", "second_driver_coefficient", "temperature_coefficient")
DRIVER_GAIN = ("driver_gain", "second_driver_gain", "gain_drift")
MOVES, CLOCK, DAYS, OTHER = "a signal that moves", "a clock", "days enough", "a driver beside the base model"

KINDS = [
    Kind("late as a slab", late_as_a_slab, LATE, frozenset({MOVES, CLOCK}), 0.1, linear=False),
    Kind("late by a time", late_by_a_time, ("time_offset",), frozenset({MOVES, CLOCK}), 0.02, linear=False),
    Kind("overshoots", relaxes, ("stress_relaxation",), frozenset({MOVES, CLOCK}), 0.1, linear=False),
    Kind("gain fouls", gain_fouls, ("gain_ageing",), frozenset({MOVES, CLOCK}), 0.5),
    Kind("gain jumps", gain_jumps, ("gain_change", "regime_change"), frozenset({MOVES, CLOCK}), 0.5),
    Kind("zero creeps", zero_creeps, ("offset_drift", "settling"), frozenset({CLOCK}), np.inf),
    Kind("zero jumps", zero_jumps, ("regime_change", "offset_steps"), frozenset({CLOCK}), np.inf),
    Kind("bends", characteristic_bends, ("nonlinearity", "saturation"), frozenset({MOVES}), 0.5),
    Kind("saturates", characteristic_saturates, ("saturation", "nonlinearity"), frozenset({MOVES}), 20.0, linear=False),
    Kind("friction", friction_of_dahl, ("friction", "saturating_loop"), frozenset({MOVES, CLOCK}), 0.2),
    Kind("follows a driver", follows_the_driver, DRIVER, frozenset({OTHER}), np.inf),
    Kind("gain follows a driver", gain_follows_the_driver, DRIVER_GAIN, frozenset({MOVES, OTHER}), 0.5),
    Kind("sun of the day", day_of_sun, ("daily_cycle",), frozenset({CLOCK, DAYS}), np.inf),
]
