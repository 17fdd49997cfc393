"""Checks the meshes of scenes with trimesh and OpenSCAD; see check_meshes.sh, which runs it."""

import json
import math
import os
import re
import subprocess
import sys
import time

import numpy
import trimesh

FORMATS = ["stl", "obj", "ply", "3mf", "gltf", "glb"]
SAMPLES = 20_000
CHIARO = os.environ.get("CHIARO", "target/release/chiaro")


def load(path):
    """The mesh in a file as one surface, with what materials and colours split joined again: as trimesh joins vertices by
    default, and those nearer to each other than a millionth of the size."""
    mesh = trimesh.load(path, force="mesh", process=True)
    mesh = trimesh.Trimesh(mesh.vertices, mesh.faces, process=True)
    mesh.merge_vertices(digits_vertex=math.ceil(6 - math.log10(mesh.scale)))
    return mesh


def inside(scene, points):
    """Which points are inside the scene, by its signed distance."""
    lines = "".join(json.dumps({"p": list(point)}) + "\n" for point in points)
    answer = subprocess.run(
        [CHIARO, "distance", scene, "--points", "-", "--quiet"], input=lines, capture_output=True, text=True, check=True
    )
    return numpy.array([json.loads(line)["f"] < 0 for line in answer.stdout.splitlines()])


def volume(scene, bounds):
    """The scene's volume by random points, and the standard error."""
    low, high = bounds
    points = numpy.random.default_rng(1).uniform(low, high, (SAMPLES, 3))
    part = inside(scene, points).mean()
    return part * numpy.prod(high - low), numpy.sqrt(part * (1 - part) / SAMPLES) * numpy.prod(high - low)


def openscad_facets(stl, work):
    """How many facets OpenSCAD says an STL file has after it was imported, or why it has none."""
    program = os.path.join(work, "import.scad")
    with open(program, "w") as file:
        file.write(f'import("{os.path.abspath(stl)}");')
    result = subprocess.run(
        ["openscad", "-o", os.path.join(work, "again.stl"), program], capture_output=True, text=True, timeout=600
    )
    found = re.search(r"Facets:\s+(\d+)", result.stderr)
    return found.group(1) if result.returncode == 0 and found else "fails"


def check(scene, work):
    name = os.path.splitext(os.path.basename(scene))[0]
    failures = []
    meshes = {}
    for ending in FORMATS:
        path = os.path.join(work, f"{name}.{ending}")
        start = time.monotonic()
        result = subprocess.run([CHIARO, "export", scene, "-o", path, "--quiet"], capture_output=True, text=True)
        if result.returncode != 0:
            print(f"| {name} | | | no mesh: {result.stderr.strip()} | | | |", flush=True)
            # Of a plane scene there must not be one.
            return "the scene is plane" in result.stderr
        seconds = time.monotonic() - start
        mesh = load(path)
        if not (mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0):
            failures.append(ending)
        meshes[ending] = mesh
    volumes = {ending: mesh.volume for ending, mesh in meshes.items()}
    # glTF is in metres.
    volumes["gltf"], volumes["glb"] = volumes["gltf"] * 1e9, volumes["glb"] * 1e9
    own = volumes["stl"]
    failures += [f"{ending} volume" for ending, other in volumes.items() if abs(other - own) > 1e-4 * own]
    expected, error = volume(scene, meshes["stl"].bounds)
    sigmas = (own - expected) / error
    if abs(sigmas) > 4:
        failures.append("volume")
    facets = openscad_facets(os.path.join(work, f"{name}.stl"), work)
    if facets == "fails":
        failures.append("OpenSCAD")
    triangles = len(meshes["stl"].faces)
    verdict = "yes" if not failures else "no: " + ", ".join(failures)
    print(
        f"| {name} | {triangles} | {seconds:.1f} | {verdict} | {own:.1f} | {expected:.1f} ± {error:.1f} | {facets} |",
        flush=True,
    )
    return not failures


def main():
    work, scenes = sys.argv[1], sys.argv[2:]
    print("| scene | triangles | seconds | closed, oriented | volume, mm³ | by random points | facets in OpenSCAD |")
    print("|---|---|---|---|---|---|---|", flush=True)
    passed = [check(scene, work) for scene in scenes]
    sys.exit(0 if all(passed) else 1)


main()
