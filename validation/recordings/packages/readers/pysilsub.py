"""Reads files of the package pysilsub, and holds models that its recordings share."""

from formats.text import csv
from models.bends import bends_with, levels_off
from models.fitting import line, scaled


def lamp(content, number):
    """Light of one lamp at each setting, all wavelengths together."""
    frame = csv(content)
    told = frame[frame.Primary == number]
    return told.Setting.to_numpy(), told.iloc[:, 2:].sum(axis=1).to_numpy()


def lamp_by_setting(content, number):
    """One lamp over its setting."""
    return dict(zip(("setting", "light"), lamp(content, number)))


def lamp_models(c):
    """Models of the second lamp over the first."""
    y, x = c["second"], c["first"]
    u = scaled(x)
    return y, {
        "as it is": lambda seen: x,
        "zero": lambda seen: x + (y - x)[seen].mean(),
        **bends_with(y, x),
        "fourth power": line(y, x, u**2, u**3, u**4),
        **levels_off(y, x, x.max() / 4),
    }


def two_lamps(first, second, number):
    """Two lamps of one kind at the same settings, in counts."""
    return {"first": lamp(first, number)[1], "second": lamp(second, number)[1]}
