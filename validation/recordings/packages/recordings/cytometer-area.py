"""Area of the pulse of light that a particle scatters in a flow cytometer, over its height, with its width; the first 4000 particles that have all three. An area is a height times a width."""

from models.fitting import line
from readers.fcsparser import cytometer

HAND_BUILT = "gain by width, and width"


def rows(content):
    frame = cytometer(content).iloc[:4000]
    frame = frame[(frame["FSC-A"] > 0) & (frame["FSC-H"] > 0)]
    return {"height": frame["FSC-H"], "area": frame["FSC-A"], "width": frame["FSC-W"] / 65536}


def models(c):
    y, x, width = c["area"], c["height"], c["width"]
    return y, {
        "line": line(y, x),
        "square": line(y, x, x**2),
        "width": line(y, x, width),
        "gain by width": line(y, x, width * x),
        HAND_BUILT: line(y, x, width * x, width),
    }
