"""FreeFEM on one triangulation: writes the mesh, runs crack.edp or modes.edp, reads what it found.

CPU time is FreeFEM's own clock() around everything after the mesh was read: its start and the compiling of the script are out.
"""
import os
import pathlib
import subprocess
import tempfile

import numpy

from problems import boundary_edges, edges_of, weight

HERE = pathlib.Path(__file__).parent
# Debian's /etc/freefem++.pref names folders of an older version.
FOLDERS = {"FF_LOADPATH": "/usr/lib/freefem++;./"}
ELEMENTS = {2: "P2", 3: "P3", 4: "P4"}


def write_mesh(path, problem, points, triangles):
    """In the format of gmsh 2, whose reader takes the doubled nodes of a slit. Labels 1, 2 for loaded edges in their order, 1001
    (cracks) or 1 (modes) for the clamped one, 9 for others; region 2 where the integral's weight slopes."""
    labels = {}
    for i, (first, last, _) in enumerate(problem.tractions):
        labels.update({tuple(e): i + 1 for e in edges_of(points, triangles, first, last)})
    for first, last in problem.clamped:
        labels.update({tuple(e): 1001 if problem.crack else 1 for e in edges_of(points, triangles, first, last)})
    edges = boundary_edges(triangles)
    weights = weight(problem, points)[triangles] if problem.crack else numpy.zeros(triangles.shape)
    sloping = weights.max(axis=1) > weights.min(axis=1)
    with path.open("w") as file:
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes", len(points), sep="\n", file=file)
        file.writelines(f"{i + 1} {x!r} {y!r} 0\n" for i, (x, y) in enumerate(points.tolist()))
        print("$EndNodes\n$Elements", len(triangles) + len(edges), sep="\n", file=file)
        file.writelines(f"{i + 1} 1 2 {labels.get((a, b), 9)} 1 {a + 1} {b + 1}\n" for i, (a, b) in enumerate(edges.tolist()))
        file.writelines(f"{len(edges) + i + 1} 2 2 {2 if sloping[i] else 1} 1 {a + 1} {b + 1} {c + 1}\n" for i, (a, b, c) in enumerate(triangles.tolist()))
        print("$EndElements", file=file)


def run(problem, points, triangles, order):
    """(answer, CPU seconds, degrees of freedom)."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_mesh(folder / "plate.msh", problem, points, triangles)
        numbers = {"E": problem.youngs_modulus, "nu": problem.poisson_ratio}
        if problem.crack:
            (tipX, tipY), (inner, outer) = problem.crack[1], problem.integral
            (topX, topY), (bottomX, bottomY) = ([t for _, _, t in problem.tractions] + [(0, 0)])[:2]
            numbers |= {"tipX": tipX, "tipY": tipY, "inner": inner, "outer": outer, "topX": topX, "topY": topY, "bottomX": bottomX,
                        "bottomY": bottomY, "clamped": 1 if problem.clamped else 0}
        else:
            numbers |= {"density": problem.density}
        head = "".join(f"real {key} = {value!r};\n" for key, value in numbers.items())
        head += 'string meshName = "plate.msh", result = "result";\n'
        script = (HERE / ("crack.edp" if problem.crack else "modes.edp")).read_text()
        (folder / "run.edp").write_text(head + script.replace("ORDER", ELEMENTS[order]).replace("DEGREE", str(order)))
        call = ["FreeFem++", "-nw", "-v", "0", "run.edp"]
        done = subprocess.run(call, capture_output=True, text=True, cwd=folder, env={**os.environ, **FOLDERS})
        if done.returncode != 0 or not (folder / "result").is_file():
            raise RuntimeError(f"FreeFem++ ended with {done.returncode}: {done.stdout[-2000:]} {done.stderr[-500:]}")
        numbers = [float(word) for word in (folder / "result").read_text().split()]
        return numbers[:-2], numbers[-2], int(numbers[-1])
