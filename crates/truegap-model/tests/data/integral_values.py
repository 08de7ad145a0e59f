"""Writes integral_values.csv: the capacitance integral in 50-digit arithmetic by quadrature over rings, no closed form.

Run: python3 integral_values.py > integral_values.csv      (needs mpmath)
Inputs are doubles, printed so that they read back exactly; the integral is that of those doubles.
"""
import math
from mpmath import mp, mpf, quad, sqrt, pi

mp.dps = 50


def sag(k, rho):
    return k * rho**2 / (1 + sqrt(1 - k**2 * rho**2))


def integral(k, r, g0):
    k, r, g0 = mpf(k), mpf(r), mpf(g0)
    # rings in sigma = rho^2 / r^2: dA = pi r^2 dsigma; geometric nodes towards both ends, where a nearly touching plate makes a pole just outside
    near = [mpf(4) ** -i for i in range(16, 0, -1)]
    nodes = [mpf(0)] + near + [1 - x for x in reversed(near)] + [mpf(1)]
    f = lambda sigma: 1 / (g0 + sag(k, r * sqrt(sigma)))
    return pi * r**2 * quad(f, nodes)


def double_sag(k, r):
    return k * r * r / (1 + math.sqrt(1 - (k * r) ** 2))


rows = []
for r in (7.5e-3, 4e-3):
    d = 1.62e-4
    for k in (0.0, 1e-18, -1e-12, 1e-8, -1e-6, 1e-4, -1e-3, 0.01, -0.05, 0.3, -0.3, 1.436, -1.436):
        rows.append((k, r, d))
    for share in (0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6):
        k = 3.7
        rows.append((k, r, share * d))
        rows.append((-k, r, share * d + abs(double_sag(k, r))))
for kr in (0.1, 0.5, 0.9, 0.999, 1.0):
    for g in (1e-4, 1e-2, 1.0, 100.0):
        k = kr / 2.0
        rows.append((k, 2.0, g))
        rows.append((-k, 2.0, g + abs(double_sag(k, 2.0))))

print("curvature_per_m,radius_m,centre_gap_m,integral_m")
for k, r, g in rows:
    print(f"{k!r},{r!r},{g!r},{mp.nstr(integral(k, r, g), 22)}")
