"""Least squares: straight in some terms, or curved by a few numbers.

A model is a function of the rows that may be seen, as a mask; it gives a prediction of every row.
"""

import numpy as np
from scipy.optimize import least_squares


def scaled(x):
    """Values less their mean, over their scatter."""
    return (x - x.mean()) / x.std()


def line(y, *terms):
    """A constant and terms, each with a coefficient."""
    return through_zero(y, np.ones(len(y)), *terms)


def through_zero(y, *terms):
    """Terms, each with a coefficient, and no constant."""
    matrix = np.column_stack([np.asarray(term, float) for term in terms])
    matrix = matrix / (np.abs(matrix).max(axis=0) + 1e-300)
    return lambda seen: matrix @ np.linalg.lstsq(matrix[seen], y[seen], rcond=None)[0]


def terms(y, basis, start, combine=line):
    """Terms that hold some numbers: `basis(p)` gives them. Coefficients are solved for inside of the search for `p`."""
    return lambda seen: searched(y, lambda p: combine(y, *basis(p))(seen), start, seen)


def curve(y, predict, start):
    """A prediction by some numbers, `predict(p)`."""
    return lambda seen: searched(y, predict, start, seen)


def searched(y, predict, start, seen):
    """The prediction by the numbers that fit best."""
    best = least_squares(lambda p: (predict(p) - y)[seen], start, x_scale="jac", max_nfev=300)
    return predict(best.x)
