"""Reads files of the package edges-cal."""

import pandas as pd
from formats.clock import seconds
from formats.text import csv

LOADS = "date time lna_v lna_ohm lna_c switch_v switch_ohm switch_c load_v load_ohm load_c room_c".split()


def load_thermistors(content):
    """Rows of a calibration of a radio receiver, one each half minute: voltages, resistances and temperatures of its thermistors, and seconds since the first."""
    frame = csv(content, encoding="latin1")
    frame.columns = LOADS
    when = pd.to_datetime(frame.date + " " + frame.time, format="%m/%d/%Y %H:%M:%S")
    return frame.assign(time_s=seconds(when))
