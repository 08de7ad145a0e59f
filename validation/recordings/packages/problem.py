"""What is told to the person at the command line: one kind of error, one exit code."""

import sys


class Problem(Exception):
    """Bad input or a refusal: what, where, how to mend it. The commands of this folder then leave with exit code 2."""


def command(main):
    """Runs a command and leaves with its exit code; a problem is told in one line."""
    try:
        sys.exit(main())
    except Problem as problem:
        print(f"error: {problem}", file=sys.stderr)
        sys.exit(2)
