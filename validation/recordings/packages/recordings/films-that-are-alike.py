"""Light that a film scatters over what the one before it scatters, by the shift of the light."""

from readers.spectrapepper import film_models, films

HAND_BUILT = "square"


def rows(content):
    return films(content, 0, 1)


def models(c):
    return film_models(c)
