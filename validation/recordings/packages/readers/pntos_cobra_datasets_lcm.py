"""Reads files of the package pntos-cobra-datasets-lcm."""

import struct

import numpy as np

INERTIAL, RECEIVER = ("/sensor/ins-d/pva", ">qB6d"), ("/sensor/ublox-ZED-F9T/pva", ">qB6d")
BAROMETER, ACCELEROMETER = ("/sensor/bmp388/baro_pressure", ">qd"), ("/sensor/vn-100/imu", ">qB3d")


def channel(content, name, form, head=39):
    """Numbers of one channel of a log of messages, of each a column; they begin so many bytes behind the begin of a message. The first is a time in ns."""
    rows, at, name = [], 0, name.encode()
    while at < len(content):
        letters, size = struct.unpack_from(">ii", content, at + 20)
        begin = at + 28 + letters
        if content[at + 28 : begin] == name:
            rows.append(struct.unpack_from(form, content, begin + head))
        at = begin + size
    clock, *told = zip(*rows)
    return (np.array(clock) - np.array(clock[0])) / 1e9, clock[0], np.array(told, float)


def at_times_of(at, channel_of, begin, value):
    """Values of another channel at times of this one, straight between its rows; `begin` is the first time of this one in ns."""
    t, first, _ = channel_of
    return np.interp(at, t + (first - begin) / 1e9, value)


def ground_speeds(told):
    """How fast something moves over the ground; a place and a speed have three numbers each, behind a number of the frame."""
    return np.hypot(told[4], told[5])


def drive_by_pressure(content):
    """Pressure in a car, its height and how fast it goes."""
    (t, begin, told), car = channel(content, *BAROMETER), channel(content, *INERTIAL)
    height, speed = (at_times_of(t, car, begin, value) for value in (car[2][3], ground_speeds(car[2])))
    return {"time_s": np.round(t, 4), "height_m": height, "speed_m_s": speed, "pressure_hpa": told[0] / 100}


def drive_by_speed(content, first, last):
    """How fast a car goes by two instruments, from one row of the receiver to another."""
    (t, begin, told), car = channel(content, *RECEIVER), channel(content, *INERTIAL)
    other = at_times_of(t, car, begin, ground_speeds(car[2]))
    return {"time_s": np.round(t[first:last] - t[first], 4), "inertial_m_s": other[first:last], "receiver_m_s": ground_speeds(told)[first:last]}


def drive_by_force(content, slowest):
    """What an accelerometer feels along a car, over how much faster it gets, and how steep the road is: over each second in which it goes faster than the slowest."""
    (t, begin, told), car = channel(content, *INERTIAL), channel(content, *ACCELEROMETER)
    at = np.arange(1, int(t[-1]))
    speed, height = (np.interp(at, t, value) for value in (ground_speeds(told), told[3]))
    felt = np.diff(at_times_of(at, car, begin, np.cumsum(car[2][1])))
    middle = (speed[1:] + speed[:-1]) / 2
    kept = middle > slowest
    return {"time_s": at[:-1][kept], "gained_m_s2": np.diff(speed)[kept], "slope": np.diff(height)[kept] / middle[kept], "felt_m_s2": felt[kept]}
