"""The sixth lead on the chest of a person over the second of the limbs, beside the first of these, 10 seconds of a heart."""

from readers.pydicom import lead_models, leads

HAND_BUILT = "square, and third"


def rows(content):
    return leads(content, 5, i_uv="I", ii_uv="II", v6_uv="V6")


def models(c):
    return c["v6_uv"], lead_models(c["v6_uv"], c["ii_uv"], c["i_uv"], c["time_s"])
