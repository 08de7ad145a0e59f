"""Reads files of the package pypromice."""

from formats.clock import seconds
from formats.toa5 import toa5


def logger_table(content, *names):
    """Columns of a logger's table with its four lines of heading, rows with a number in each, and seconds since the first."""
    frame = toa5(content)[["TIMESTAMP", *names]].dropna().reset_index(drop=True)
    return frame.assign(time_s=seconds(frame.TIMESTAMP))


def tried_in_town(content, *names):
    """A station that is tried in a town before it goes to the ice: every second row since its upper level runs, without those in which a thermometer told 7999."""
    frame = logger_table(content, "Asp_temp_U", "TemperatureRadSensor", *names)
    frame = frame[frame.TemperatureRadSensor < 100].iloc[50::2]
    return frame.assign(time_s=frame.time_s - frame.time_s.iloc[0])
