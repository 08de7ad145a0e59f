"""NGSolve on one mesh: run_ngsolve.py sparsecholesky|umfpack|pardiso disc|open|rubber MESH.npz."""

import sys

import ngsolve as ng
import numpy as np
from netgen.meshing import FaceDescriptor, Mesh

from meshes import load_arrays
from report import HEIGHT, LAMBDA, MU, PRESS, Clock, apparent_modulus

EXACT = ng.dx(bonus_intorder=2)  # to the degree that all programs integrate to: 2 pi r is a factor of its own


def netgen_mesh(points, triangles, edges, labels):
    mesh = Mesh(dim=2)
    mesh.AddPoints(np.c_[points, np.zeros(len(points))])
    mesh.Add(FaceDescriptor(surfnr=1, domin=1, bc=1))
    mesh.AddElements(dim=2, index=1, data=triangles.astype(np.int32), base=0)
    for i, name in enumerate(sorted(set(labels)), start=1):
        mesh.AddElements(dim=1, index=i, data=edges[labels == name].astype(np.int32), base=0)
        mesh.SetBCName(i - 1, str(name))
    mesh.SetMaterial(1, "body")
    return ng.Mesh(mesh)


def electrostatics(mesh, is_open):
    space = ng.H1(mesh, order=2, dirichlet="upper|lower")
    u, v = space.TnT()
    form = ng.BilinearForm(space, symmetric=True)
    form += 2 * np.pi * ng.x * ng.grad(u) * ng.grad(v) * EXACT
    if is_open:
        cap = ng.IfPos(ng.y * ng.y - 24.99999, 0.2, 0.0)
        form += 2 * np.pi * ng.x * (15.0 / (ng.x**2 + ng.y**2) - cap) * u * v * ng.ds("far")
    return space, form, mesh.BoundaryCF({"upper": 0.5, "lower": -0.5}, default=0.0)


def elasticity(mesh):
    space = ng.VectorH1(mesh, order=2, dirichletx="axis|top|bottom", dirichlety="top|bottom")
    u, v = space.TnT()
    def strain(f):
        g = ng.Grad(f)
        return g[0, 0], g[1, 1], f[0] / ng.x, g[0, 1] + g[1, 0]
    e, d = strain(u), strain(v)
    volume = (e[0] + e[1] + e[2]) * (d[0] + d[1] + d[2])
    work = LAMBDA * volume + 2 * MU * (e[0] * d[0] + e[1] * d[1] + e[2] * d[2]) + MU * e[3] * d[3]
    form = ng.BilinearForm(space, symmetric=True)
    form += 2 * np.pi * ng.x * work * EXACT
    pressed = mesh.BoundaryCF({"top": -PRESS * HEIGHT}, default=0.0)
    return space, form, ng.CF((0.0, pressed))


def main(name, problem, file):
    mesh = netgen_mesh(*load_arrays(file))
    clock = Clock()
    space, form, prescribed = elasticity(mesh) if problem == "rubber" else electrostatics(mesh, problem == "open")
    u = ng.GridFunction(space)
    held = "top|bottom" if problem == "rubber" else "upper|lower"
    u.Set(prescribed, definedon=mesh.Boundaries(held))
    form.Assemble()
    clock.mark("assemble")
    residual = u.vec.CreateVector()
    residual.data = form.mat * u.vec
    inverse = form.mat.Inverse(space.FreeDofs(), inverse=name)
    u.vec.data -= inverse * residual
    clock.mark("solve")
    residual.data = form.mat * u.vec
    value = ng.InnerProduct(residual, u.vec)
    clock.mark("evaluate")
    clock.print(sum(space.FreeDofs()), apparent_modulus(value) if problem == "rubber" else value)


ng.SetNumThreads(1)
main(*sys.argv[1:])
