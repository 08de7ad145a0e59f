"""Area of cells that pass a camera, by their contour, over that of the hull around the contour. Contours with a bay have less."""

from models.bends import usual_and_bends
from models.fitting import line
from readers.dclab import cells

HAND_BUILT = "square"


def rows(content):
    frame = cells(content, "area_cvx", "area_msd")
    return {"time_s": frame.time_s, "hull_px": frame.area_cvx, "cell_px": frame.area_msd}


def models(c):
    y, x, t = c["cell_px"], c["hull_px"], c["time_s"]
    return y, {**usual_and_bends(y, x, t, 0.1), "square, and drift": line(y, x, x**2, t)}
