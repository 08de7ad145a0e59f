"""True airspeed that an aircraft sends, over its indicated airspeed, in a flight with parabolas; rows in which either changes. The air is thin where it is high."""

from models.fitting import line, terms
from models.lags import lag
from readers.traffic import flight

HAND_BUILT = "height"


def rows(content):
    frame = flight(content).dropna(subset=["IAS", "TAS", "altitude"])
    frame = frame[(frame.IAS.diff() != 0) | (frame.TAS.diff() != 0)]
    return {"time_s": frame.time_s, "indicated_kt": frame.IAS, "true_kt": frame.TAS, "height_kft": frame.altitude / 1000}


def models(c):
    y, x, t, height = c["true_kt"], c["indicated_kt"], c["time_s"], c["height_kft"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "drift": line(y, x, t),
        "line and lag": terms(y, lambda p: [x, lag(x, t, abs(p[0]) * 5)], [1.0]),
        HAND_BUILT: line(y, x, height),
        "height, bent": line(y, x, height, height**2),
        "gain by height": line(y, x, height * x),
        "gain by height, bent": line(y, x, height * x, height**2 * x),
        "gain and zero by height": line(y, x, height * x, height),
    }
