"""Signal of a part of a brain in a scanner over whether something was shown just then, a row each 2 s. Blood comes some seconds later, and more than it stays."""

from models.fitting import line, terms
from models.lags import lag, moved
from readers.nitime import shown_events

HAND_BUILT = "lag of a lag, and one that takes back"


def rows(content):
    return shown_events(content, 2)


def models(c):
    y, x, t = c["signal"], c["shown"], c["time_s"]
    late = lambda by: lag(x, t, abs(by))
    twice = lambda u, by: lag(lag(u, t, abs(by) + 0.3), t, abs(by) + 0.3)
    each = [moved(x, t, 2 * k) for k in range(12)]
    return y, {
        "line": line(y, x),
        "drift": line(y, x, t),
        "shift": terms(y, lambda p: [moved(x, t, p[0])], [4.0]),
        "lag": terms(y, lambda p: [late(p[0])], [4.0]),
        "shift, and lag": terms(y, lambda p: [lag(moved(x, t, p[1]), t, abs(p[0]))], [3.0, 2.0]),
        "lag of a lag": terms(y, lambda p: [twice(x, p[0])], [2.0]),
        "shift, and lag of a lag": terms(y, lambda p: [twice(moved(x, t, p[1]), p[0])], [2.0, 1.0]),
        "lag of a lag, and line": terms(y, lambda p: [x, twice(x, p[0])], [2.0]),
        "lag of a lag, and one that takes back": terms(y, lambda p: [twice(moved(x, t, p[1]), p[0]), twice(x, p[2])], [2.0, 1.0, 6.0]),
        "each of twelve rows": line(y, *each),
    }
