"""Reads files of the package dosepy."""

import numpy as np
from formats.text import matrix


def film(measured, planned, millimetres, every):
    """Dose over a film and over the plan of it, each so many points in both directions: doses in Gy, and the place along the film."""
    measured, planned = (matrix(content, delimiter=",", comments="#")[::every, ::every] for content in (measured, planned))
    place = np.indices(measured.shape)[0] * every * millimetres
    return {"place_mm": place.ravel(), "planned_gy": planned.ravel(), "film_gy": measured.ravel()}
