"""How much heavier than a standard a gas is at mass 48 over the same at mass 46, a session of a mass spectrometer."""

from models.drifts import usual_shifts_and_drifts
from readers.d47calib import one_session

HAND_BUILT = "line"


def rows(content):
    return one_session(content, 1, mass_46="d46", mass_48="d48")


def models(c):
    return c["mass_48"], usual_shifts_and_drifts(c["mass_48"], c["mass_46"], c["time_s"], 3600)
