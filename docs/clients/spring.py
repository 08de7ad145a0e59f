"""A program that truegap asks: the length of a spring under a load. The protocol is in docs/command-base.md."""

import sys


def simulate(inputs, parameters):
    """The simulator: one number a row. Put your own here."""
    return [parameters["rest"] + force / parameters["k"] for force in inputs["force_n"]]


inputs = {}
for line in sys.stdin:
    word, *rest = line.split()
    if word == "truegap":
        print("truegap 1", flush=True)
    elif word == "inputs":
        rows = [[float(cell) for cell in sys.stdin.readline().split()] for _ in range(int(rest[0]))]
        inputs = dict(zip(rest[1:], zip(*rows)))
    elif word == "ask":
        parameters = {name: float(value) for name, value in (pair.split("=") for pair in rest)}
        answer = simulate(inputs, parameters)
        print(f"answer {len(answer)}", *answer, sep="\n", flush=True)
