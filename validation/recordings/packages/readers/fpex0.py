"""Reads files of the package fpex0."""

import json

import numpy as np


def melting(fast, slow, lowest, highest):
    """What a sample takes up as it is warmed fast, and as it was at the same warmth when it was warmed slowly; seconds since the lowest warmth."""
    fast, slow = json.loads(fast), json.loads(slow)
    warmth, taken = np.array(fast["T"]), np.array(fast["latentdata"])
    kept = (warmth > lowest) & (warmth < highest)
    told = {"time_s": (warmth[kept] - warmth[kept][0]) / fast["rate"] * 60, "slow_j_gk": np.interp(warmth[kept], slow["T"], slow["latentdata"])}
    return {name: np.round(values, 6) for name, values in {**told, "fast_j_gk": taken[kept]}.items()}
