"""Light that a film scatters over what the one beside it scatters, by the shift of the light."""

from readers.spectrapepper import film_models, films

HAND_BUILT = "square, and place"


def rows(content):
    return films(content, 7, 9)


def models(c):
    return film_models(c)
