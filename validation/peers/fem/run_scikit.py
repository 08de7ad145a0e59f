"""scikit-fem on one mesh: run_scikit.py cholmod|pardiso disc|open|rubber MESH.npz."""

import sys

import numpy as np
from scipy.sparse import triu
from skfem import Basis, BilinearForm, ElementTriP2, ElementVector, FacetBasis, MeshTri, condense

from meshes import load_arrays
from report import HEIGHT, LAMBDA, MU, PRESS, Clock, apparent_modulus

TAU = 2 * np.pi


@BilinearForm
def dielectric(u, v, w):
    return TAU * w.x[0] * (u.grad[0] * v.grad[0] + u.grad[1] * v.grad[1])


@BilinearForm
def far_side(u, v, w):
    r, z = w.x
    return TAU * r * (15.0 / (r**2 + z**2) - np.where(abs(z) > 4.999999, 0.2, 0.0)) * u * v


@BilinearForm
def hooke(u, v, w):
    r = w.x[0]
    strain = lambda f: (f.grad[0][0], f.grad[1][1], f.value[0] / r, f.grad[0][1] + f.grad[1][0])
    e, d = strain(u), strain(v)
    volume = (e[0] + e[1] + e[2]) * (d[0] + d[1] + d[2])
    return TAU * r * (LAMBDA * volume + 2 * MU * (e[0] * d[0] + e[1] * d[1] + e[2] * d[2]) + MU * e[3] * d[3])


def solver(name):
    if name == "cholmod":
        from sksparse.cholmod import cholesky

        return lambda a, b: cholesky(a.tocsc())(b)
    from pypardiso import PyPardisoSolver

    direct = PyPardisoSolver(mtype=2)  # symmetric, positive definite: the upper triangle

    def solve(a, b):
        upper = triu(a, format="csr")
        direct.factorize(upper)
        return direct.solve(upper, b)

    return solve


def main(name, problem, file):
    points, triangles, edges, labels = load_arrays(file)
    solve = solver(name)
    clock = Clock()
    mesh = MeshTri(points.T.copy(), triangles.T.copy())
    element = ElementVector(ElementTriP2()) if problem == "rubber" else ElementTriP2()
    basis = Basis(mesh, element, intorder=4)
    facets = {n: facets_of(mesh, edges[labels == n]) for n in set(labels)}
    matrix = (hooke if problem == "rubber" else dielectric).assemble(basis)
    if problem == "open":
        matrix = matrix + far_side.assemble(FacetBasis(mesh, element, facets=facets["far"], intorder=6))
    u = basis.zeros()
    if problem == "rubber":
        plates = [basis.get_dofs(facets[n]) for n in ("bottom", "top")]
        u[plates[1].all("u^2")] = -PRESS * HEIGHT
        axis = basis.get_dofs(facets["axis"]).all("u^1")
        fixed = np.unique(np.concatenate([plates[0].all(), plates[1].all(), axis]))
    else:
        discs = [basis.get_dofs(facets[n]).all() for n in ("upper", "lower")]
        u[discs[0]], u[discs[1]] = 0.5, -0.5
        fixed = np.concatenate(discs)
    a, b, u, free = condense(matrix, x=u, D=fixed)
    clock.mark("assemble")
    u[free] = solve(a, b)
    clock.mark("solve")
    value = u @ (matrix @ u)
    clock.mark("evaluate")
    clock.print(len(free), apparent_modulus(value) if problem == "rubber" else value)


def facets_of(mesh, edges):
    """Numbers of the mesh's facets with these ends."""
    code = lambda e: np.sort(e, axis=1) @ np.array([len(mesh.p[0]), 1])
    return np.flatnonzero(np.isin(code(mesh.facets.T), code(edges)))


main(*sys.argv[1:])
