"""Files of MATLAB."""

import io

from scipy.io import loadmat


def variables(content, **options):
    """Variables by their names; options are those of `scipy.io.loadmat`."""
    return loadmat(io.BytesIO(content), **options)
