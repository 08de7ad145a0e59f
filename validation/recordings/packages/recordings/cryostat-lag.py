"""Temperature of a sample in a cryostat over that of the insert around it while it is cooled to 2 K, one and a half hours. It is late, and less so where it is cold."""

from formats.clock import since_first
from models.fitting import terms
from models.lags import lag, usual
from readers.stoner import tagged_table

HAND_BUILT = "bent lag"


def rows(content):
    frame = tagged_table(content).dropna()
    return {"time_s": since_first(frame["Elapsed Time"]), "insert_k": frame["VTI Temp"], "sample_k": frame["T (K)"]}


def models(c):
    y, x, t = c["sample_k"], c["insert_k"], c["time_s"]
    late = lambda p: lag(x, t, abs(p[0]) * 600)
    return y, {**usual(y, x, t), "lag, and drift": terms(y, lambda p: [late(p), t], [1.0]), HAND_BUILT: terms(y, lambda p: [late(p), late(p) ** 2], [1.0])}
