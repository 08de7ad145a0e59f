"""Light that a film scatters over what another scatters, whose peaks stand higher, by the shift of the light."""

from readers.spectrapepper import film_models, films

HAND_BUILT = "square"


def rows(content):
    return films(content, 40, 120)


def models(c):
    return film_models(c)
