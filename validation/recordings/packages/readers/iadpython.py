"""Reads files of the package iadpython, and holds models that its recordings share."""

import csv as tables
import io

import numpy as np
from models.fitting import line, scaled, terms


def spectra(content, times):
    """Wavelengths in nm, and of each the reflectance of so many times a person, person after person: a CSV whose head names the times R1, R2 and so on."""
    cells = list(tables.reader(io.StringIO(content.decode("latin1"))))
    begin, head = next((k, line) for k, line in enumerate(cells) if line and line[0].startswith("Wavelength"))
    columns = [0, *(k for k, name in enumerate(head) if name.startswith("R"))]
    values = np.array([[line[k] for k in columns] for line in cells[begin + 1 :]], float)
    return values[:, 0], values[:, 1:].reshape(len(values), -1, times)


def skins(content, times=3, **wavelengths):
    """Reflectance of skin near some wavelengths, a row for each time that a person was seen; a person is a run."""
    told, seen = spectra(content, times)
    people = seen.shape[1]
    near = lambda one: seen[np.argmin(np.abs(told - one))].ravel()
    return {"run": np.repeat(np.arange(people) + 1, times), **{name: near(one) for name, one in wavelengths.items()}}


def skin_models(y, x, people, **colour):
    """Models of the light that comes back from skin at one wavelength, by that at another and that of one further colour (each N)."""
    [(name, of_colour)] = colour.items()
    return {
        f"slope by {name} alone": line(y, x, scaled(x) * scaled(of_colour)),
        "product of powers": terms(y, lambda p: [x ** p[0] * of_colour ** p[1]], [1.0, 0.5]),
        "number": line(y, x, people),
    }


def skin_twice(content, times, *wavelengths):
    """Reflectance of skin near some wavelengths the first and the second time that a person was seen; a person is a run."""
    told, seen = spectra(content, times)
    near = [np.argmin(np.abs(told - one)) for one in wavelengths]
    both, people = seen[near].transpose(1, 0, 2), seen.shape[1]
    run = np.repeat(np.arange(people) + 1, len(near))
    return {"run": run, "nm": np.tile(told[near], people), "first": both[:, :, 0].ravel(), "second": both[:, :, 1].ravel()}
