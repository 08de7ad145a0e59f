"""The command `truegap`, asked for one diagnosis."""

import shlex
import subprocess

from problem import Problem


def diagnose(truegap, description, out):
    """Diagnoses the recording that a TOML file describes, into a folder."""
    run = [*shlex.split(truegap), "diagnose", str(description), "-o", str(out)]
    try:
        done = subprocess.run(run, capture_output=True, text=True)
    except OSError as error:
        raise Problem(f"`{truegap}` cannot be run: {error.strerror}; name the command by --truegap") from error
    if done.returncode not in (0, 1):
        said = (done.stderr.strip() or "nothing was said").splitlines()[-1]
        raise Problem(f"truegap left with exit code {done.returncode}: {said}")
