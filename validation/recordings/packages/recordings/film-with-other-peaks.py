"""Light that a film scatters over what another scatters, whose peaks stand higher, by the shift of the light."""

from listeners import films, of_films

HAND_BUILT = "square"


def rows(content):
    return films(content, 40, 120)


def models(c):
    return of_films(c)
