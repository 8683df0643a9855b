"""/usr/bin/python3 benchmarks/peers/compare.py [--rounds 5] [--program NAME …] [--problem NAME …]

Runs every program with every setting on the three problems, interleaved, one thread, and writes records/<problem>.json:
answers, errors, and the median CPU seconds of the rounds. Programs that are not installed are an error: ci/peers installs them.
"""
import argparse
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

os.environ.update(OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")  # before numpy is loaded

import numpy  # noqa: E402

import calculix_peer  # noqa: E402
import freefem_peer  # noqa: E402
from problems import PROBLEMS, error_of, triangulate  # noqa: E402

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parent.parent

# (tip length over the largest triangle, growth) of the shared triangulations, from coarse to fine; beyond the last the mesh
# generator leaves slivers at clamped corners.
GRADINGS = ((1e-1, 0.6), (1e-2, 0.5), (1e-3, 0.4), (1e-4, 0.35))
ORDERS = {"FreeFEM": (2, 3, 4), "dolfinx": (2, 3, 4), "CalculiX": (2,)}
PACKAGES = {"FreeFEM": "freefem++", "dolfinx": "python3-dolfinx", "CalculiX": "calculix-ccx", "gmsh": "python3-gmsh"}

# Sunder's own settings: (series, scene keys).
OURS = {
    "edge-crack": [("Sunder, one polygon", {"mesh.order": p}) for p in (2, 3, 4, 5, 6, 7, 8)]
    + [("Sunder, mesh", {"mesh.cells": '"dual"', "mesh.order": p, "mesh.size": h}) for p in (1, 2, 3, 4) for h in (0.25, 0.125, 0.0625)],
    "edge-crack-shear": [("Sunder, one polygon", {"mesh.order": p}) for p in (2, 3, 4, 5, 6, 8)]
    + [("Sunder, mesh", {"mesh.cells": '"dual"', "mesh.grade": "[]", "mesh.edge_size": 100, "mesh.order": p, "mesh.size": h})
       for p in (1, 2, 3, 4) for h in (1.75, 0.875, 0.4375)],
    "koyna-section": [("Sunder, mesh", {"mesh.order": p, "mesh.size": h, "modal.interior_order": q})
                      for p, q in ((1, 0), (2, 0), (2, 2), (3, 3), (4, 4)) for h in (9.6, 4.8, 2.4)],
}


def sunder(problem, keys):
    """(answer, CPU seconds of the solution, of the mesh, degrees of freedom) as the program's own account has them."""
    with tempfile.TemporaryDirectory() as folder:
        call = [ROOT / "build/release/bin/sunder", "run", ROOT / "verification/cases" / problem.scene, "--quiet", "--threads", "1", "--output", folder]
        for key, value in keys.items():
            call += ["--set", f"{key}={value}"]
        done = subprocess.run(call, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"sunder ended with {done.returncode}: {done.stderr}")
        summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
    parts = {p["part"]: p["seconds"] for p in summary["parts"]}
    found = summary["quantities"]
    answer = [found["tips"][0][k] for k in ("K_I", "K_II")] if problem.crack else [2 * numpy.pi * f for f in found["frequencies"][:4]]
    return answer, sum(parts.values()) - parts["mesh"], parts["mesh"], summary["mesh"]["dofs"]


def dolfinx(problem, points, triangles, order):
    with tempfile.TemporaryDirectory() as folder:
        mesh = pathlib.Path(folder) / "mesh.npz"
        numpy.savez(mesh, points=points, triangles=triangles)
        done = subprocess.run([sys.executable, "-B", HERE / "dolfinx_peer.py", problem.name, mesh, str(order)], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"dolfinx ended with {done.returncode}: {done.stderr[-1500:]}")
    found = json.loads(done.stdout.splitlines()[-1])
    return found["answer"], found["seconds"], found["dofs"]


RUN = {"FreeFEM": freefem_peer.run, "CalculiX": calculix_peer.run, "dolfinx": dolfinx}


def one_round(problem, programs, rows, failed):
    """Every setting once; appends times to `rows`, what a program said to `failed`, both keyed by (series, setting)."""
    def keep(series, setting, answer, seconds, mesh, dofs):
        row = rows.setdefault((series, setting), {"series": series, "setting": setting, "answer": answer, "dofs": dofs,
                                                  "error": error_of(problem, answer), "times": [], "mesh_times": []})
        row["times"].append(seconds)
        row["mesh_times"].append(mesh)
    for tip, growth in GRADINGS:
        points, triangles, mesh = triangulate(problem, tip * problem.far, growth)
        for program in programs:
            for order in ORDERS.get(program, ()):
                series, setting = f"{program}, order {order}", f"smallest triangle {tip * problem.far:g} m, growth {growth:g}"
                try:
                    answer, seconds, dofs = RUN[program](problem, points, triangles, order)
                    keep(series, setting, answer, seconds, mesh, dofs)
                except RuntimeError as error:
                    failed[series, setting] = " ".join(str(error).split())[:300]
    if "Sunder" in programs:
        for series, keys in OURS[problem.name]:
            answer, seconds, mesh, dofs = sunder(problem, keys)
            told = ", ".join(f"{key.rsplit('.', 1)[-1].replace('_', ' ')} {value}" for key, value in keys.items()
                             if key in ("mesh.order", "mesh.size", "modal.interior_order"))
            keep(series, told, answer, seconds, mesh, dofs)


def versions(programs):
    found = {}
    for program in (*programs, "gmsh"):
        if program == "Sunder":
            done = subprocess.run(["git", "rev-parse", "--short=10", "HEAD"], cwd=ROOT, capture_output=True, text=True)
            found[program] = done.stdout.strip()
        else:
            done = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", PACKAGES[program]], capture_output=True, text=True, check=True)
            found[program] = done.stdout
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--program", nargs="+", default=["FreeFEM", "dolfinx", "CalculiX", "Sunder"])
    parser.add_argument("--problem", nargs="+", default=list(PROBLEMS))
    parser.add_argument("--output", type=pathlib.Path, default=HERE / "records")
    options = parser.parse_args()
    for name in options.problem:
        problem, rows, failed = PROBLEMS[name], {}, {}
        for _ in range(options.rounds):
            one_round(problem, options.program, rows, failed)
        found = [{"series": r["series"], "setting": r["setting"], "error": r["error"], "answer": r["answer"], "dofs": r["dofs"],
                  "cpu_seconds": statistics.median(r["times"]), "mesh_seconds": statistics.median(r["mesh_times"]),
                  "cpu_least": min(r["times"]), "cpu_most": max(r["times"])} for r in rows.values()]
        record = {"problem": name, "title": problem.title, "quantity": problem.quantity, "reference": problem.reference,
                  "source": problem.source, "rounds": options.rounds, "threads": 1,
                  "machine": f"{platform.machine()}, {os.cpu_count()} cores", "versions": versions(options.program), "rows": found,
                  "failed": [{"series": series, "setting": setting, "message": message} for (series, setting), message in failed.items()]}
        options.output.mkdir(exist_ok=True)
        (options.output / f"{name}.json").write_text(json.dumps(record, indent=1) + "\n")
        for row in found:
            print(f"{name:18} {row['series']:22} {row['setting']:44} {row['dofs']:7} {row['error']:9.2e} {row['cpu_seconds'] * 1e3:9.1f} ms + mesh {row['mesh_seconds'] * 1e3:.1f} ms")


if __name__ == "__main__":
    main()
