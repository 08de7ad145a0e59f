"""A Python function as a base model."""

from __future__ import annotations

import os
import shutil
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import truegap as tg
from conftest import pressed, spring


@pytest.fixture(scope="module")
def agreed():
    parameters = {"k": tg.Parameter(1.8, sd=0.5, unit="N/mm", low=0.1), "rest": tg.Parameter(0.0, sd=3.0, unit="mm")}
    return tg.diagnose(pressed(), base=spring, parameters=parameters)


def test_parameters_are_found_as_least_squares_finds_them(agreed):
    made = pressed()
    slope, rest = np.polyfit(made["force_n"], made["response_mm"], 1)
    k, found_rest = agreed.base_parameters
    assert (k.name, k.unit, k.prior) == ("k", "N/mm", (1.8, 0.5))
    assert k.value == pytest.approx(1 / slope, abs=3 * k.sd) and found_rest.value == pytest.approx(rest, abs=3 * found_rest.sd)
    assert k.value == pytest.approx(2.0, abs=4 * k.sd) and k.sd < 0.01


def test_nothing_is_named_where_nothing_is_missing(agreed):
    assert agreed.findings == [] and agreed.verdict == "agrees", agreed.says
    assert agreed.noise == pytest.approx(5e-3, rel=0.2)


def test_a_prediction_is_the_function_at_the_values_found(agreed):
    values = {p.name: p.value for p in agreed.base_parameters}
    force = np.array([0.0, 3.0, 20.0])
    predicted = agreed.predict({"force_n": force})
    assert np.asarray(predicted) == pytest.approx(spring({"force_n": force}, values), rel=1e-12)
    assert len(predicted) == 3 and predicted.unit == "mm"


def test_the_function_is_called_from_the_thread_that_asked(parameters):
    threads = set()

    def watched(inputs, values):
        threads.add(threading.get_ident())
        return spring(inputs, values)

    d = tg.diagnose(pressed(), base=watched, parameters=parameters)
    assert threads == {threading.get_ident()}
    assert 10 < d.calls[0] < 100_000 and d.calls[1] > 0


def test_an_exception_comes_back_as_it_is_with_its_parameters(parameters):
    class OutOfMesh(Exception):
        pass

    raised = []

    def broken(inputs, values):
        if len(raised) or values["k"] > 1.9:
            raised.append(OutOfMesh("no cell there"))
            raise raised[-1]
        return spring(inputs, values)

    with pytest.raises(OutOfMesh) as caught:
        tg.diagnose(pressed(), base=broken, parameters=parameters)
    assert caught.value is raised[0] and len(raised) == 1
    if sys.version_info >= (3, 11):
        assert "k = " in caught.value.__notes__[0] and "rest = " in caught.value.__notes__[0]


def test_what_is_no_answer_is_told(parameters):
    with pytest.raises(ValueError, match=r"`short` answered with an array of shape \(2,\) for 300 rows"):

        def short(inputs, values):
            return [1.0, 2.0]

        tg.diagnose(pressed(), base=short, parameters=parameters)
    with pytest.raises(ValueError, match="could not convert"):
        tg.diagnose(pressed(), base=lambda i, p: ["a"] * 300, parameters=parameters)


def test_nan_is_no_answer_at_these_values_and_no_failure(parameters):
    def only_near(inputs, values):
        return spring(inputs, values) if 1.0 < values["k"] < 3.0 else np.full(len(inputs["run"]), np.nan)

    d = tg.diagnose(pressed(), base=only_near, parameters=parameters)
    assert d.base_parameters[0].value == pytest.approx(2.0, abs=0.02)


def test_a_function_that_answers_nan_alone_is_told_with_its_parameters(parameters):
    with pytest.raises(tg.TruegapError, match=r"row 1: .*no finite response there with k = [0-9.]+ N/mm, rest = "):
        tg.diagnose(pressed(), base=lambda inputs, values: np.full(len(inputs["run"]), np.nan), parameters=parameters)


@pytest.mark.skipif(sys.platform == "win32", reason="signals are sent another way there")
def test_ctrl_c_interrupts_a_simulator_in_the_middle_of_an_answer(parameters):
    # whoever starts the tests in the background has SIGINT ignored, and Python then keeps it so
    signal.signal(signal.SIGINT, signal.default_int_handler)

    def slow(inputs, values):
        time.sleep(30)

    threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        tg.diagnose(pressed(), base=slow, parameters=parameters)
    assert time.monotonic() - start < 5
    # and another diagnosis runs
    assert tg.diagnose(pressed(rows=60), base=spring, parameters=parameters).verdict


def test_progress_goes_on_to_the_end_and_its_exception_ends_the_work(parameters):
    seen = []
    tg.diagnose(pressed(), base=spring, parameters=parameters, progress=lambda done, step, what: seen.append((done, step, what)))
    assert len(seen) > 3 and all(0 <= done <= 1 for done, _, _ in seen) and all(step for _, step, _ in seen)

    def enough(done, step, what):
        raise StopIteration("enough")

    with pytest.raises(StopIteration):
        tg.diagnose(pressed(), base=spring, parameters=parameters, progress=enough)


def test_a_bar_is_drawn_and_cleared(parameters, capsys):
    tg.diagnose(pressed(), base=spring, parameters=parameters, progress=True)
    assert "%" in capsys.readouterr().err
    tg.diagnose(pressed(), base=spring, parameters=parameters, progress=False)
    assert capsys.readouterr().err == ""


def test_parameters_that_are_none_are_told_by_name():
    with pytest.raises(TypeError, match="`k` is a float"):
        tg.diagnose(pressed(), base=spring, parameters={"k": 2.0})
    with pytest.raises(tg.TruegapError, match="`k` has value 2 and sd 0"):
        tg.diagnose(pressed(), base=spring, parameters={"k": tg.Parameter(2.0, sd=0.0)})
    with pytest.raises(TypeError, match="belong to a base that is a function"):
        tg.diagnose(pressed(), base="linear", parameters={"k": tg.Parameter(2.0, sd=1.0)})


def test_inputs_are_in_si_under_their_names(parameters):
    seen = {}

    def keeps(inputs, values):
        # the first question is put before any physics is tried
        seen.update({} if seen else inputs)
        return spring({"force_n": inputs["force_n"]}, values)

    made = pressed()
    frame = {"t": made["time_s"] / 60, "load": made["force_n"] * 1e3, "u": made["response_mm"], "pump": made["time_s"] + 1}
    names = {"time": "t", "force": "load", "response": "u"}
    units = {"time": "min", "force": "mN", "response": "mm"}
    drivers = {"pump": {"column": "pump", "unit": "V"}}
    tg.diagnose(frame, base=keeps, parameters=parameters, columns=names, units=units, drivers=drivers)
    assert seen.keys() == {"run", "time_s", "force_n", "pump"}
    assert seen["force_n"] == pytest.approx(made["force_n"]) and seen["time_s"] == pytest.approx(made["time_s"])


def late(seed):
    """As `pressed`, with a force of many periods that is read 3 s late: a first-order lag in steps of 10 ms, of which every 50th is kept."""
    fine = np.arange(600 * 50) * 0.01
    forces = 5 + 4 * np.sin(fine / 7 + seed) + 2 * np.sin(fine / 2.3)
    read, value = [], forces[0]
    for force in forces.tolist():
        read.append(value)
        value += (force - value) * 0.01 / 3.0
    noise = np.random.default_rng(seed).normal(0, 5e-3, 600)
    return {"time_s": fine[::50], "force_n": forces[::50], "response_mm": 1 + np.array(read[::50]) / 2 + noise}


def test_what_was_added_is_confirmed_from_the_object_and_from_its_file(tmp_path, parameters):
    d = tg.diagnose(late(1), base=spring, parameters=parameters)
    assert d.findings, d.says
    seconds = [p.value for f in d.findings for p in f.parameters if p.unit == "s"]
    assert any(abs(value - 3.0) < 0.02 for value in seconds), d.says
    confirmation = d.confirm(late(2))
    assert confirmation.verdict == "confirmed" and confirmation.rmse_augmented < 1.5 * 5e-3 < confirmation.rmse_base, confirmation.says
    # each rival that the diagnosis left open is judged beside what is named
    open_ones = {(rival, named) for named, *rivals in d.document["ambiguity"] for rival in rivals}
    assert set(confirmation.rivals) == open_ones and bool(confirmation.rivals_say) == bool(open_ones), confirmation.document
    assert all(rmse > 0.9 * 5e-3 for rmse in confirmation.rivals.values()), confirmation.rivals
    # the function may have a memory, so its recorded input is used; what the lag did is gone
    corrected = d.compensate(late(2))
    truth = 1 + late(2)["force_n"] / 2
    errors = [float(np.sqrt(np.mean((np.asarray(column) - truth) ** 2))) for column in (late(2)["response_mm"], corrected)]
    assert errors[1] < 2 * 5e-3 < 0.1 * errors[0] and len(corrected) == 600, corrected
    assert any("recorded input" in note for note in corrected.notes), corrected.notes
    d.save(tmp_path / "out")
    file = tmp_path / "out/augmented.toml"
    again = tg.confirm(file, late(2), base=spring, parameters=parameters)
    assert again.rmse_augmented == pytest.approx(confirmation.rmse_augmented, rel=1e-12)
    with pytest.raises(tg.TruegapError, match="needs the function itself"):
        tg.confirm(file, late(2))
    command = os.environ.get("TRUEGAP_COMMAND") or shutil.which("truegap")
    assert command is not None, "set TRUEGAP_COMMAND to the path of the command `truegap`"
    said = subprocess.run([command, "simulate", "--model", file, "--drive", "example"], capture_output=True, text=True, check=False)
    assert said.returncode == 2 and "docs/python.md" in said.stderr
