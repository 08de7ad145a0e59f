"""The tactile sensor of the paper, by name: the built-in recording, and what finite elements say of one assumption."""

from __future__ import annotations

import truegap as tg


def main() -> tg.Diagnosis:
    d = tg.diagnose("example")
    print(d)
    print(tg.simulate("singletact-s15-4.5n", force_n=[0, 2, 4.5], temperature_c=[20, 50]))
    print(tg.coefficients("singletact-s15-4.5n"))
    return d


if __name__ == "__main__":
    main()
