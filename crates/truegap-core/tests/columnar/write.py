"""Writes the files beside this one: `python3 write.py` with pandas, pyarrow and polars."""

from pathlib import Path

import pandas as pd
import polars as pl

here = Path(__file__).parent
times = ["2026-03-01T12:00:00.250", "2026-03-01T12:00:00.750", "2026-03-01T12:00:01.500", "2026-03-01T12:00:02.250", "2026-03-01T12:00:03"]
frame = pd.DataFrame(
    {
        "time": pd.to_datetime(times, format="ISO8601"),
        "force_n": [0.0, 1.5, float("nan"), 2.5, 3.0],
        "capacitance_pf": [70.0, 71.25, 72.0, 73.0, 74.0],
        "fan": [1, 2, 3, 4, 5],
        "who": ["a", "b", "c", "d", "e"],
    }
)
frame.to_csv(here / "bench.csv", index=False, date_format="%Y-%m-%dT%H:%M:%S.%f")
frame.to_parquet(here / "bench.parquet", index=False)
pl.from_pandas(frame).write_ipc(here / "bench.arrow", compression="zstd")
