"""Imports GLB files with Blender's own importer and checks what arrives: python blender_check.py FILE.glb...

Set up once (Python 3.11): python3 -m venv .venv-blender && .venv-blender/bin/pip install bpy==5.0.1
"""
import sys

import bpy


def check(path: str) -> bool:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    meshes = [o for o in bpy.data.objects if o.type == "MESH"]
    cameras = [o for o in bpy.data.objects if o.type == "CAMERA"]
    corners = [o.matrix_world @ v.co for o in meshes for v in o.data.vertices]
    size = [1e3 * (max(c[i] for c in corners) - min(c[i] for c in corners)) for i in range(3)]
    scene = bpy.context.scene
    print(f"{path}: Blender {bpy.app.version_string}, {len(meshes)} parts, {len(cameras)} camera, "
          f"size {size[0]:.4g} x {size[1]:.4g} x {size[2]:.4g} mm, actions {sorted(a.name for a in bpy.data.actions)}, "
          f"scene properties {sorted(k for k in scene.keys() if k != 'cycles')}")
    fine = bool(meshes)
    for part in meshes:
        keys = part.data.shape_keys
        names = [k.name for k in keys.key_blocks] if keys else []
        colours = [a.name for a in part.data.color_attributes]
        fine &= [m.name for m in part.data.materials] == [part.name]
        print(f"  {part.name}: {len(part.data.polygons)} triangles, shape keys {names}, colours {colours}, "
              f"properties {sorted(part.keys())}")
    return fine


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(0 if all([check(path) for path in sys.argv[1:]]) else 1)
