"""What a person sees: examples, figures, notebook page, analytic model, types."""

from __future__ import annotations

import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import stiffening_spring
import truegap as tg
from conftest import EXAMPLES, ROOT

PACKAGE = EXAMPLES.parent


@pytest.fixture(scope="module")
def shaken():
    return stiffening_spring.main()


def test_a_cubic_spring_inside_the_simulator_is_found_and_confirmed_on_the_other_recording(shaken):
    before, confirmation, _ = shaken
    fit = before.document["fit"]["held_out"]
    assert fit["rmse_before"] > 3 * stiffening_spring.NOISE, "the recording shows what is missing"
    assert before.verdict == "explained" and [f.effect for f in before.findings] == ["inner_stiffening"], before.says
    cubic = before.findings[0].parameters[0]
    assert abs(cubic.value - stiffening_spring.K3) < 4 * cubic.sd and cubic.sd < 0.1 * stiffening_spring.K3, str(cubic)
    assert fit["rmse_after"] < 1.2 * stiffening_spring.NOISE
    assert confirmation.verdict == "confirmed", confirmation.says


def test_the_simulator_with_the_cubic_term_agrees_and_predicts_the_other_recording(shaken):
    _, _, after = shaken
    assert after.verdict == "agrees" and after.findings == [], after.says
    truth = {"k": stiffening_spring.K, "c": stiffening_spring.C, "k3": stiffening_spring.K3}
    for parameter in after.base_parameters:
        assert abs(parameter.value - truth[parameter.name]) < 4 * parameter.sd, str(parameter)
        assert 0 < parameter.sd_of_fit <= parameter.sd, repr(parameter)
    # 600 rows: the error of an error is 3 % of it
    assert stiffening_spring.error(after, stiffening_spring.recorded(2)) == pytest.approx(stiffening_spring.NOISE, rel=0.12)


def test_a_page_for_a_notebook_says_what_was_found(shaken):
    d, confirmation, _ = shaken
    page = d._repr_html_()
    report = d.report_html()
    figure = page[page.index("<svg") : page.index("</svg>")]
    # the report's first screen: its sentence, how sure that is, its errors, and the figure of what is left
    assert figure in report and "Recorded less predicted" in figure
    for part in ('class="callout', 'class="says"', "on data the fit did not see", "noise of one reading"):
        assert part in page and part in report, part
    assert "<script" not in page and "<html" not in page and "http" not in page.replace("http://www.w3.org", "")
    # the one that was confirmed says so
    assert "confirmed" in page and confirmation.says in page
    assert repr(d).startswith(f"<truegap.Diagnosis: {d.verdict}")
    assert "<table>" in confirmation._repr_html_() and len(confirmation.to_frame()) == 600


def test_a_figure_is_written_as_svg_and_pdf(shaken, tmp_path):
    d, _, _ = shaken
    figure = d.plot()
    assert [axis.get_ylabel() for axis in figure.axes] == ["response [m]", "left over [m]"]
    left_over = np.asarray(figure.axes[1].lines[0].get_ydata(), dtype=float)
    table = d.table
    assert left_over == pytest.approx(table["recorded_m"] - table["base_m"])
    for ending in ("svg", "pdf"):
        figure.savefig(tmp_path / f"d.{ending}")
        assert (tmp_path / f"d.{ending}").stat().st_size > 5000


def test_findings_are_objects(shaken):
    d, _, _ = shaken
    for finding in d.findings:
        assert 0 <= finding.probability <= 1 and finding.says and finding.parameters
        assert str(finding.parameters[0]).startswith(finding.parameters[0].name)
    assert len(d.to_frame()) == 600 and {"base_m", "recorded_m"} <= set(d.table)


def test_the_ten_lines_run(capsys):
    runpy.run_path(str(EXAMPLES / "linear_in_ten_lines.py"), run_name="__main__")
    assert "lag" in capsys.readouterr().out


def test_the_analytic_model_is_the_command_lines():
    states = tg.simulate(force_n=[0, 4.5], temperature_c=[20, 50])
    assert list(states["force_n"]) == [0, 4.5, 0, 4.5] and np.all(np.diff(states["c_total_pf"][:2]) != 0)
    assert "singletact-s15-4.5n" in tg.sensors()
    assert tg.coefficients()
    with pytest.raises(tg.TruegapError, match="no-such"):
        tg.coefficients("no-such")
    with pytest.raises(tg.TruegapError, match="closes the gap"):
        tg.simulate(force_n=1e4)


def test_the_version_is_the_workspaces():
    lines = (ROOT / "Cargo.toml").read_text().splitlines()
    assert f'version = "{tg.__version__}"' in lines


def test_types_are_checked():
    done = subprocess.run([sys.executable, "-m", "mypy"], cwd=PACKAGE, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_stubs_say_what_the_native_half_has():
    done = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "truegap._truegap", "--allowlist", Path(__file__).parent / "stubs.txt"],
        cwd=PACKAGE,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
