"""A simulator of ten lines, a frame, a diagnosis: a spring scale that was read late."""

import numpy as np

import truegap as tg


def simulate(inputs, parameters):  # type: ignore[no-untyped-def]
    return parameters["rest"] + inputs["force_n"] / parameters["k"]


fine = np.arange(600 * 50) * 0.01  # s; every 50th is kept
forces = 5 + 4 * np.sin(fine / 7) + 2 * np.sin(fine / 2.3)
late, value = [], forces[0]
for force in forces.tolist():
    late.append(value)
    value += (force - value) * 0.01 / 3.0  # the truth: 3 s behind
read = 1.0 + np.array(late[::50]) / 2.0 + np.random.default_rng(1).normal(0, 0.005, 600)

d = tg.diagnose(
    {"time_s": fine[::50], "force_n": forces[::50], "read": read},
    base=simulate,
    parameters={"k": tg.Parameter(2.1, sd=0.3, unit="N/mm"), "rest": tg.Parameter(0.0, sd=2.0, unit="mm")},
    columns={"response": "read"},
    units={"response": "mm"},
)
print(d)
