"""Voltage of the battery of a hybrid car over the current that goes into it, half an hour on rollers. It has more voltage the fuller it is, and a part of it comes late. The charge is the current summed up from the start."""

from formats.rows import charged
from models.fitting import line, terms
from models.lags import lag, usual_and_lags
from readers.co2mpas import car_on_rollers

HAND_BUILT = "charge, bent, and late current"


def rows(content):
    frame = car_on_rollers(content)
    amp, time = frame.drive_battery_currents.to_numpy(), frame.times.to_numpy()
    charge = charged(amp, time)
    return {"time_s": time, "current_a": amp, "charge_ah": charge, "voltage_v": frame.drive_battery_voltages}


def models(c):
    y, x, t, charge = c["voltage_v"], c["current_a"], c["time_s"], c["charge_ah"]
    late = lambda p: lag(x, t, abs(p) * 30)
    return y, {
        **usual_and_lags(y, x, t, 30),
        "charge": line(y, x, charge),
        "charge, bent": line(y, x, charge, charge**2),
        "charge, and drift": line(y, x, charge, t),
        "charge, and late current": terms(y, lambda p: [x, charge, late(p[0])], [1.0]),
        "charge, bent, and late current": terms(y, lambda p: [x, charge, charge**2, late(p[0])], [1.0]),
        "charge, and two late currents": terms(y, lambda p: [x, charge, late(p[0]), late(p[1])], [0.2, 2.0]),
        "charge, late current, and drift": terms(y, lambda p: [x, charge, late(p[0]), t], [1.0]),
    }
