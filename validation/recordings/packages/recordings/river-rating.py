"""Flow of a river over its water level, the last 3000 days of its table, means of a day. The flow grows by a power of the depth."""

import io

import pandas as pd
from formats.clock import seconds
from models.fitting import line
from models.lags import usual

HAND_BUILT = "cubic"


def rows(content):
    frame = pd.read_excel(io.BytesIO(content), sheet_name="Sheet1").iloc[:, :3].dropna().iloc[-3000:]
    when, flow, level = (frame.iloc[:, k] for k in range(3))
    return {"time_s": seconds(when), "level_ft": level, "flow_ft3_s": flow}


def models(c):
    y, x, t = c["flow_ft3_s"], c["level_ft"], c["time_s"]
    return y, {**usual(y, x, t, 86400), HAND_BUILT: line(y, x, x**2, x**3), "cubic, and drift": line(y, x, x**2, x**3, t)}
