"""Flow of a river by its gauge over that by a model, five years, a row a day. The model lets the water go too early, and has too little of a year."""

from models.cycles import tone
from models.fitting import line, terms
from models.lags import lag, usual
from readers.modelskill import model_beside_measured

HAND_BUILT = "line and lag, and year"
DAY = 86400.0


def rows(content):
    place = model_beside_measured(content, "7_Suraz.nc")
    return {"time_s": place["time_s"], "model_m3_s": place["sim1"], "gauge_m3_s": place["Observation"]}


def models(c):
    y, x, t = c["gauge_m3_s"], c["model_m3_s"], c["time_s"]
    late = lambda p: lag(x, t, abs(p) * DAY)
    year = tone(t, 365.25 * DAY)
    return y, {
        **usual(y, x, t, DAY),
        "year": line(y, x, *year),
        "line and lag": terms(y, lambda p: [x, late(p[0])], [5.0]),
        "square, and lag": terms(y, lambda p: [x, x**2, late(p[0])], [5.0]),
        HAND_BUILT: terms(y, lambda p: [x, late(p[0]), *year], [5.0]),
        "line and lag, and gain by year": terms(y, lambda p: [x, late(p[0]), *[x * wave for wave in year]], [5.0]),
    }
