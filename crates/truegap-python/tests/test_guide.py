"""The Python code of the guide runs and says what the page is about."""

from __future__ import annotations

from conftest import ROOT


def test_the_simulator_of_the_guide_is_diagnosed(capsys):
    page = (ROOT / "docs/guide/own-simulator.md").read_text()
    codes = [block.removeprefix("python\n") for block in page.split("```")[1::2] if block.startswith("python\n")]
    assert len(codes) == 1
    names: dict[str, object] = {"__name__": "guide"}
    exec(compile(codes[0], "own-simulator.md", "exec"), names)
    said = capsys.readouterr().out
    assert "explained" in said and "temperature_coefficient" in said, said
