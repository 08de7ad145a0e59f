"""Cases and design studies: the command line's answers as objects; effects that explain themselves; the package's own figures."""

from __future__ import annotations

import json
import subprocess

import pytest
import truegap as tg
from conftest import ROOT, command


def said(*arguments: str):
    done = subprocess.run([command(), "--json", "-q", *arguments], capture_output=True, text=True, check=False)
    assert done.returncode < 2, done.stderr
    return json.loads(done.stdout)


def test_a_case_is_solved_as_on_the_command_line():
    case = ROOT / "meshes/cases/coaxial_cable.toml"
    ours, theirs = tg.solve(case), said("solve", str(case))
    assert ours["quantities"] == theirs["quantities"] and ours["quantities"]
    with pytest.raises(tg.TruegapError, match=r"no-such\.toml"):
        tg.solve("no-such.toml")


def test_the_studies_are_those_of_the_command_line(tmp_path):
    assert tg.sensitivity(rows=256) == said("sensitivity", "--rows", "256")
    limits = {"span": (2.3, 2.6), "linearity": (None, 6.0)}
    theirs = said("tolerance", "--samples", "3000", "--limit", "span=2.3:2.6", "--limit", "linearity=:6")
    assert tg.tolerance(samples=3000, limits=limits, folder=tmp_path / "t") == theirs
    assert json.loads((tmp_path / "t/tolerance.json").read_text()) == theirs and (tmp_path / "t/report.html").is_file()
    theirs = said("optimise", "--searches", "1", "--vary", "height=150 um:210 um", "--hold", "diameter")
    steps = []
    ours = tg.optimise(searches=1, vary={"height": "150 um:210 um"}, hold=["diameter"], progress=lambda *step: steps.append(step))
    assert ours == theirs and steps and steps[-1][0] == 1.0


def test_a_study_says_what_it_cannot_do():
    with pytest.raises(tg.TruegapError, match="no metric `width`.*span"):
        tg.tolerance(limits={"width": (0, 1)}, samples=1000)
    with pytest.raises(tg.TruegapError, match="--vary height.*unit"):
        tg.optimise(vary={"height": "200:150 um"})
    with pytest.raises(ValueError, match="change_pct is 0"):
        tg.sensitivity(change_pct=0)


def test_ctrl_c_of_a_study_comes_back():
    def enough(done, step, what):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        tg.optimise(searches=8, progress=enough)


def test_an_effect_explains_itself():
    lag = tg.explain("thermal lag")
    assert lag.document == said("explain", "thermal_lag")
    assert lag.equation in str(lag) and "told apart by" in lag._repr_html_()
    assert set(lag.mistaken_for) <= set(tg.effects())
    with pytest.raises(tg.TruegapError, match="did you mean `thermal_lag`"):
        tg.explain("thermal_lagg")
