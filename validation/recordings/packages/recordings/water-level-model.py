"""Water level of a strait by a gauge over that by a model, half a year, a row an hour. They agree but for a little."""

from models.cycles import tone
from models.fitting import line
from models.lags import usual
from readers.modelskill import model_beside_measured

HAND_BUILT = "square"
MOON = 44714  # s


def rows(content):
    place = model_beside_measured(content, "1_Barseback.nc")
    return {"time_s": place["time_s"], "model_m": place["MIKE21"], "gauge_m": place["Observation"]}


def models(c):
    y, x, t = c["gauge_m"], c["model_m"], c["time_s"]
    return y, {**usual(y, x, t, 3600), "tide": line(y, x, *tone(t, MOON)), "square, and tide": line(y, x, x**2, *tone(t, MOON))}
