"""The third lead on the chest of a person over the fourth, beside the second, 10 seconds of a heart."""

from readers.pydicom import lead_models, leads

HAND_BUILT = "third that is shifted, slope by it"


def rows(content):
    return leads(content, 5, v2_uv="V2", v4_uv="V4", v3_uv="V3")


def models(c):
    return c["v3_uv"], lead_models(c["v3_uv"], c["v4_uv"], c["v2_uv"], c["time_s"])
