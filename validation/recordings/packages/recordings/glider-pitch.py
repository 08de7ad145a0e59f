"""Pitch of an underwater glider over the place of the battery that it moves for that, 14 dives, one a run, every tenth row.

The trim changes with the depth, which presses the hull, and the lever is a curve.
"""

from models.fitting import line
from readers.glidertools import dives

HAND_BUILT = "cubic, depth and square of volume"


def rows(*contents):
    names = {"time_s": "time", "battery_cm": "eng_pitchCtl", "depth_db": "pressure", "volume_cm3": "eng_vbdCC", "pitch_deg": "eng_pitchAng", "phase": "eng_GC_phase"}
    d = dives(contents, names)
    d = d[(d.depth_db > 15) & (d.phase == 6)].iloc[::10]
    return {"dive": d.dive, "time_s": (d.time_s - d.time_s.iloc[0]).round(3), **{name: d[name] for name in ("battery_cm", "depth_db", "volume_cm3", "pitch_deg")}}


def models(c):
    y, x, depth, volume = c["pitch_deg"], c["battery_cm"], c["depth_db"], c["volume_cm3"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "cubic": line(y, x, x**2, x**3),
        "depth": line(y, x, depth),
        "depth and volume": line(y, x, depth, volume),
        "cubic and depth": line(y, x, x**2, x**3, depth),
        "square, depth and volume": line(y, x, x**2, depth, volume),
        HAND_BUILT: line(y, x, x**2, x**3, depth, volume, volume**2),
    }
