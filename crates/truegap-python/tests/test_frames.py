"""Frames as people have them: clocks as text or as an index, frames not yet collected, and what a mistake is answered with."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pytest
import truegap as tg
from conftest import pressed, spring

STAMPS = pd.Timestamp("2026-02-27 10:00:00") + pd.to_timedelta(np.arange(300) * 1.0, unit="s")


def times(frame: Any, **columns: str) -> Any:
    d = tg.diagnose(frame, base="linear", columns=columns, progress=False)
    return d.table["time_s"]


def unclocked() -> pd.DataFrame:
    return pd.DataFrame(pressed()).drop(columns="time_s")


@pytest.mark.parametrize("how", ["%Y-%m-%dT%H:%M:%S", "%d.%m.%Y %H:%M:%S", "%m/%d/%Y %H:%M:%S", "%d/%m/%Y %H:%M:%S", "%Y-%m-%d %H:%M:%S+01:00"])
def test_dates_as_text_are_a_clock_as_in_a_csv(how, tmp_path):
    made = unclocked()
    made.insert(0, "time", STAMPS.strftime(how))
    made.to_csv(tmp_path / "r.csv", index=False)
    by_file = tg.diagnose(tmp_path / "r.csv", base="linear")
    assert tg.diagnose(made, base="linear").notes == by_file.notes
    for frame in (made, pl.from_pandas(made), {name: list(cells) for name, cells in made.items()}):
        assert times(frame) == pytest.approx(np.arange(300.0))
        assert times(frame, time="time") == pytest.approx(np.arange(300.0))
    made.loc[7, "time"] = None
    assert len(times(made)) == 299


def test_dates_as_text_that_cannot_be_told_say_so():
    made = unclocked()
    made.insert(0, "time", (STAMPS + pd.Timedelta("2D")).strftime("%d/%m/%Y %H:%M:%S"))
    made.loc[200:, "time"] = made["time"][200:].str.replace("01/03", "02/03")
    with pytest.raises(TypeError, match=r"row 1: .*01/03/2026.* day or with the month; .*pandas.to_datetime\(frame\[.time.\], dayfirst=True\)"):
        tg.diagnose(made, base="linear")
    made["time"] = STAMPS.strftime("%Y-%m-%d %H:%M:%S")
    made.loc[4, "time"] = "later"
    with pytest.raises(TypeError, match="`time`.* 5: `later`"):
        tg.diagnose(made, base="linear")


def test_the_index_of_a_frame_is_a_column_where_it_has_a_name_or_is_a_clock():
    made = unclocked()
    for index in (STAMPS, STAMPS.rename("when"), STAMPS.tz_localize("Europe/Berlin"), STAMPS - STAMPS[0], pd.Index(np.arange(300.0), name="time_s")):
        assert times(made.set_index(index)) == pytest.approx(np.arange(300.0))
    assert times(made.set_index(STAMPS.rename("when")), time="when") == pytest.approx(np.arange(300.0))
    # a column that is a clock already goes before, and the numbers of rows are none
    clocked = pd.DataFrame(pressed()).set_index(STAMPS + pd.to_timedelta(np.arange(300), unit="h"))
    assert times(clocked) == pytest.approx(np.arange(300.0))
    assert "time_s" not in tg.diagnose(made, base="linear").table


def test_a_lazy_frame_and_a_structured_array_are_read():
    made = pl.DataFrame(pressed())
    assert times(made.lazy()) == pytest.approx(np.arange(300.0))
    assert times(pd.DataFrame(pressed()).to_records(index=False)) == pytest.approx(np.arange(300.0))


def test_columns_that_are_not_read_are_named_in_words_of_python(tmp_path):
    made = pd.DataFrame({**pressed(), "spare": np.cos(np.arange(300.0)), "label": "press"})
    made.to_csv(tmp_path / "r.csv", index=False)
    made.to_parquet(tmp_path / "r.parquet", index=False)
    for recording in (made, pl.from_pandas(made), tmp_path / "r.csv", tmp_path / "r.parquet"):
        notes = tg.diagnose(recording, base="linear", progress=False).notes
        assert any(note.startswith("not read: `spare`, `label`; name what they are by columns=") for note in notes), notes
        assert not any("--map" in note or "TOML" in note for note in notes), notes
        drivers = {"spare": {"column": "spare", "unit": "mm"}}
        notes = tg.diagnose(recording, base="linear", drivers=drivers, progress=False).notes
        assert any(note.startswith("not read: `label`;") for note in notes), notes


def test_what_is_no_frame_of_numbers_says_what_to_do():
    made = pd.DataFrame(pressed())
    with pytest.raises(TypeError, match="pandas.DataFrame"):
        tg.diagnose(made.to_dict("records"), base="linear")
    with pytest.raises(TypeError, match="a Series is no recording"):
        tg.diagnose(made["force_n"], base="linear")
    with pytest.raises(TypeError, match="`response_mm` of the frame is there twice"):
        tg.diagnose(pd.concat([made, made[["response_mm"]]], axis=1), base="linear", columns={"response": "response_mm"})
    with pytest.raises(ValueError, match="`force_n` has 299 rows and `time_s` has 300"):
        tg.diagnose({**pressed(), "force_n": pressed()["force_n"][:-1]}, base="linear")
    texts = made.assign(force_n=[*(str(cell) for cell in made["force_n"][:-1]), "overload"])
    with pytest.raises(TypeError, match="'overload' in row 300; .*to_numeric"):
        tg.diagnose(texts, base="linear", columns={"force": "force_n"})
    commas = made.assign(force_n=made["force_n"].astype(str).str.replace(".", ","))
    with pytest.raises(TypeError, match="'5,0' in row 1; .*decimal commas"):
        tg.diagnose(commas, base="linear", columns={"force": "force_n"})


def test_what_to_do_about_a_frame_is_said_in_words_of_python():
    for columns, units, said in (
        ({"response": "reading"}, {}, r'frame: no column for response: `reading` .*columns=\{"response": "..."\}'),
        ({"temprature": "force_n"}, {}, "frame: columns has no key `temprature`; did you mean `temperature`"),
        ({}, {"force": "kelvin"}, r'frame: units=\{"force": ...\}: .*kelvin'),
        ({"temperature": "bath"}, {}, r'`bath` \(temperature\) has no unit .*units=\{"temperature": "'),
    ):
        with pytest.raises(tg.TruegapError, match=said) as raised:
            tg.diagnose({**pressed(), "bath": np.arange(300.0)}, base="linear", columns=columns, units=units)
        assert "TOML" not in str(raised.value) and "--map" not in str(raised.value) and "line" not in str(raised.value)


def test_a_function_that_answers_nonsense_is_blamed_by_its_name(parameters):
    def nothing(inputs, values):
        spring(inputs, values)

    def words(inputs, values):
        return ["far"] * 300

    def phasor(inputs, values):
        return spring(inputs, values) * 1j

    for function, said in ((nothing, "`nothing` answered with None"), (words, "`words` .*no number"), (phasor, "`phasor` .*complex")):
        with pytest.raises((TypeError, ValueError), match=said):
            tg.diagnose(pressed(), base=function, parameters=parameters)


def test_a_prediction_is_shown_in_a_line():
    d = tg.diagnose(pressed(), base="linear", progress=False)
    assert repr(d.predict(pressed(2))).count("\n") == 0
