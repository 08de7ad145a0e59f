"""Reads files of the package tensorly."""

from formats.arrays import array


def glow(content, samples, emission, *excitations):
    """How bright some samples glow in one colour while they react, under light of some colours: an array each, a row a sample."""
    table = array(content)[samples, emission]
    return [table[:, excitation] for excitation in excitations]
