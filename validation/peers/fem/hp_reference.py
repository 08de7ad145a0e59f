"""Two references for bodies without closed form, by NGSolve: polynomials of high degree on meshes refined into every singular corner.

    target/peers-venv/bin/python validation/peers/fem/hp_reference.py

Prints each value for rising degree and number of layers; the digits that no longer move are those of
`validation/verification/references_independent.toml`. Nothing of truegap takes part.
"""

import math

import ngsolve as ng
from netgen.geom2d import SplineGeometry


def mesh_of(corners, layers):
    """A polygon, `corners` = (point, singular, name of the side that follows), refined `layers` times into its singular corners."""
    geometry = SplineGeometry()
    points = [geometry.AppendPoint(*p, hpref=1 if singular else 0) for p, singular, _ in corners]
    for i, (_, _, name) in enumerate(corners):
        geometry.Append(["line", points[i], points[(i + 1) % len(points)]], leftdomain=1, rightdomain=0, bc=name)
    mesh = ng.Mesh(geometry.GenerateMesh(maxh=0.35))
    mesh.RefineHP(layers, factor=0.15)
    return mesh


def stepped_bar(degree, layers):
    """Force (N) that draws a bar of steel (E = 200 GPa, nu = 0.3) by 1 um: radius 2 m up to z = 1 m, radius 1 m from there to 2 m."""
    young, nu = 200e9, 0.3
    la, mu = young * nu / ((1 + nu) * (1 - 2 * nu)), young / (2 * (1 + nu))
    mesh = mesh_of([((0, 0), False, "bottom"), ((2, 0), False, "free"), ((2, 1), False, "free"), ((1, 1), True, "free"),
                    ((1, 2), False, "top"), ((0, 2), False, "axis")], layers)
    space = ng.VectorH1(mesh, order=degree, dirichletx="axis", dirichlety="top|bottom")
    u, v = space.TnT()
    strain = lambda f: (ng.Grad(f)[0, 0], ng.Grad(f)[1, 1], f[0] / ng.x, ng.Grad(f)[0, 1] + ng.Grad(f)[1, 0])
    e, d = strain(u), strain(v)
    volume = (e[0] + e[1] + e[2]) * (d[0] + d[1] + d[2])
    work = la * volume + 2 * mu * (e[0] * d[0] + e[1] * d[1] + e[2] * d[2]) + mu * e[3] * d[3]
    pull = 1e-6
    return energy(mesh, space, 2 * math.pi * ng.x * work, ng.CF((0, mesh.BoundaryCF({"top": pull}, 0))), "top") / pull


def annulus_in_can(degree, layers):
    """C / eps0 (m) of a flat ring, 0.5 m to 1 m, in the middle of a grounded can of radius 2 m and height 2 m: twice the lower half."""
    mesh = mesh_of([((0, 0), False, "can"), ((2, 0), False, "can"), ((2, 1), False, "middle"), ((1, 1), True, "ring"),
                    ((0.5, 1), True, "middle"), ((0, 1), False, "axis")], layers)
    space = ng.H1(mesh, order=degree, dirichlet="can|ring")
    u, v = space.TnT()
    form = 2 * math.pi * ng.x * ng.grad(u) * ng.grad(v)
    return 2 * energy(mesh, space, form, mesh.BoundaryCF({"ring": 1}, 0), "can|ring")


def energy(mesh, space, form, prescribed, held):
    """a(u, u) of the solution with prescribed values, condensed and refined once."""
    a = ng.BilinearForm(space, symmetric=True)
    a += form * ng.dx(bonus_intorder=6)
    u = ng.GridFunction(space)
    u.Set(prescribed, definedon=mesh.Boundaries(held))
    a.Assemble()
    inverse = a.mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    r = u.vec.CreateVector()
    for _ in range(3):
        r.data = a.mat * u.vec
        u.vec.data -= inverse * r
    r.data = a.mat * u.vec
    return ng.InnerProduct(r, u.vec)


for problem in [stepped_bar, annulus_in_can]:
    for degree, layers in [(4, 4), (6, 6), (8, 8), (10, 10), (12, 12)]:
        print(f"{problem.__name__}: degree {degree}, {layers} layers: {problem(degree, layers):.12e}")
