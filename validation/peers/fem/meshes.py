"""Meshes that truegap wrote, as arrays and as the files that other programs read.

Reads the linear triangles and lines of a gmsh .msh 4.1 (ASCII). The edges on the axis r = 0 get a name of their own, `axis`, which
truegap does not need: it keeps such nodes on the axis without being told. `meshes.py FILE.msh BASE` writes BASE.npz and BASE.ff.msh.
"""

import sys

import numpy as np

LABELS = {"upper": 11, "lower": 12, "far": 13, "bottom": 21, "top": 22, "axis": 31}  # in FreeFEM's files


def read_msh(file):
    """Points (m), triangles, edges and the name of every edge."""
    with open(file) as f:
        lines = iter(f.read().split("\n"))
    names, points, tags, blocks = {}, [], [], {1: [], 2: []}
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dimension, tag, name = next(lines).split(maxsplit=2)
                names[int(dimension), int(tag)] = name.strip('"')
        elif line == "$Nodes":
            count = int(next(lines).split()[1])
            next(lines)
            tags = [int(next(lines)) for _ in range(count)]
            points = np.array([next(lines).split()[:2] for _ in range(count)], float)
        elif line == "$Elements":
            for _ in range(int(next(lines).split()[0])):
                dimension, tag, _, count = map(int, next(lines).split())
                rows = [next(lines).split()[1:] for _ in range(count)]
                blocks[dimension].append((names[dimension, tag], np.array(rows, int).reshape(count, -1) - 1))
    assert tags == list(range(1, len(tags) + 1)), "nodes are numbered from 1"
    triangles = np.vstack([rows for _, rows in blocks[2]])
    edges = [(name, rows[:, :2]) for name, rows in blocks[1]]
    edges.append(("axis", axis_edges(points, triangles)))
    labels = [name for name, rows in edges for _ in rows]
    return points, triangles, np.vstack([rows for _, rows in edges]), labels


def axis_edges(points, triangles):
    """Edges whose ends both lie on r = 0; empty where the body has none."""
    sides = np.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    return sides[(points[sides][:, :, 0] == 0.0).all(axis=1)]


def save_arrays(file, mesh):
    """Writes a mesh as .npz, which Python's programs read at once."""
    points, triangles, edges, labels = mesh
    np.savez(file, points=points, triangles=triangles, edges=edges, labels=np.array(labels))


def load_arrays(file):
    """Points, triangles, edges and labels from .npz."""
    data = np.load(file)
    return data["points"], data["triangles"], data["edges"], data["labels"]


def save_freefem(file, mesh):
    """Writes a mesh as FreeFEM's own .msh, edges with the numbers of LABELS."""
    points, triangles, edges, labels = mesh
    with open(file, "w") as out:
        out.write(f"{len(points)} {len(triangles)} {len(edges)}\n")
        out.writelines(f"{p[0]!r} {p[1]!r} 0\n" for p in points.tolist())
        out.writelines(f"{a + 1} {b + 1} {c + 1} 1\n" for a, b, c in triangles.tolist())
        out.writelines(f"{a + 1} {b + 1} {LABELS[l]}\n" for (a, b), l in zip(edges.tolist(), labels))


if __name__ == "__main__":
    loaded = read_msh(sys.argv[1])
    save_arrays(f"{sys.argv[2]}.npz", loaded)
    save_freefem(f"{sys.argv[2]}.ff.msh", loaded)
