"""Reads files of the package galileoqc."""

import numpy as np
import pandas as pd


def survey_rows(content):
    """Rows of a survey from the air as a data frame, in their order."""
    cells = [text.split() for text in content.decode("latin1").splitlines()]
    head = next(line for line in cells if "FTIME" in line)[1:]
    frame = pd.DataFrame([line for line in cells if len(line) == len(head) and line[0][0].isdigit()], columns=head)
    return frame.apply(pd.to_numeric, errors="coerce")


def survey(content, **names):
    """Columns of a survey by the names that they are to have; a line that was flown is a run. Seconds are those of the day's clock since the first row."""
    frame = survey_rows(content)
    return {"run": pd.factorize(frame.LINE)[0] + 1, "time_s": frame.FTIME - frame.FTIME.iloc[0], **{name: frame[column] for name, column in names.items()}}


def flown_again(content, every, what):
    """What was told along a line as it was flown again and again, each so many rows from west to east, beside what was told the first time at the same places; a flight is a run."""
    frame = survey_rows(content)
    first, *others = (rows.sort_values("MGA-X") for _, rows in frame.groupby("LINE"))
    found = []
    for run, rows in enumerate(others, 1):
        rows = rows[rows["MGA-X"].between(first["MGA-X"].iloc[0], first["MGA-X"].iloc[-1])].iloc[::every].dropna(subset=[what])
        found.append(np.column_stack([np.full(len(rows), run), np.interp(rows["MGA-X"], first["MGA-X"], first[what]), rows[what]]))
    run, before, again = np.concatenate(found).T
    return {"run": run.astype(int), "first_mgal": np.round(before, 6), "again_mgal": again}


def means_along_runs(x, run, rows):
    """Means over so many rows about each, inside of its run."""
    return np.concatenate([pd.Series(x[run == one]).rolling(rows, center=True, min_periods=1).mean() for one in np.unique(run)])
