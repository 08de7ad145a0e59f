"""Loads GLB files with trimesh and checks what it finds: python trimesh_check.py FILE.glb...

Set up once: python3 -m venv .venv && .venv/bin/pip install trimesh==5.2.0 numpy==2.4.6
"""
import sys

import numpy
import trimesh


def check(path: str) -> bool:
    scene = trimesh.load(path)
    fine = len(scene.geometry) > 0
    meta = scene.metadata
    print(f"{path}: trimesh {trimesh.__version__}, {len(scene.geometry)} parts, "
          f"extents {numpy.array2string(1e3 * scene.extents, precision=4)} mm, "
          f"fields {[f['name'] for f in meta.get('fields', [])]}, made by {meta.get('provenance', {}).get('command')!r}")
    for name, mesh in scene.geometry.items():
        transform = scene.graph.get(scene.graph.geometry_nodes[name][0])[0]
        solid = mesh.copy()
        solid.merge_vertices(merge_tex=True, merge_norm=True)
        volume = solid.volume * numpy.linalg.det(transform[:3, :3])
        # With a material present, trimesh keeps COLOR_0 beside it.
        colours = mesh.visual.vertex_attributes.get("color")
        values = mesh.vertex_attributes.get("_FIELD_0")
        coloured = "no field" if values is None else f"field {values.min():.6g} to {values.max():.6g}"
        fine &= (colours is None) == (values is None) and bool(solid.is_watertight and volume > 0)
        print(f"  {name}: {len(mesh.faces)} triangles, watertight {solid.is_watertight}, volume {1e9 * volume:.6g} mm3, {coloured}")
    return fine


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(0 if all([check(path) for path in sys.argv[1:]]) else 1)
