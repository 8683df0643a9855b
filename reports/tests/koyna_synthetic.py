"""Runs of an invented dam, as reports.koyna_runs leaves them: nothing here was computed."""
import csv
import json
import math

import h5py
import numpy

from reports import koyna_runs

TIMES = [round(0.01 * i, 9) for i in range(501)]

LAYOUT = {"koyna": {
    "title": "Koyna dam", "words": "An invented dam.", "times": [4.05, 4.45], "scene": "model-3",
    "model": [{"number": n, "run": f"model-{n}", "scene": f"model-{n}", "name": f"{n}: model"} for n in (1, 2, 3)],
    "film": {"model": 3, "steps": 10, "every": 0.1, "until": 0.5, "exaggeration": 100, "start": 0.3},
    "printed": [{"time": 4.05, "model": 2, "quantity": "crack_length", "printed": 10.0, "independent": "length_4.05", "why": "longer"},
                {"time": 4.05, "model": 3, "quantity": "uplift_force", "printed": 2136, "why": "drier"}],
    "change": [{"name": "level-103", "words": "level 103 m", "set": ["reservoir.level=103"]},
               {"name": "rock", "words": "rock", "scene": "flexible", "set": [], "model_2": ['crack_water.model="uniform"']},
               {"name": "gap", "words": "gap", "models": [3], "set": ["crack_water.minimum_aperture=0.01"]}],
    "stationary": {"scene": "model-1", "set": ["propagation.fracture_toughness=1e12"],
                   "case": [{"name": "level-91.75", "words": "91.75 m", "set": []}]},
}}


def history(model, until=5.0):
    """A crack that grows from 1 m at 2 s to the length of its model at 4.2 s; an account that closes."""
    rows, end = [], {1: 8.0, 2: 13.0, 3: 12.0}[model]
    for t in (t for t in TIMES if t <= until):
        length = 1.0 + (end - 1.0) * min(1.0, max(0.0, (t - 2.0) / 2.2))
        uplift = {1: 4e5, 2: 4e5, 3: 2e5 if t < 4.2 else 19e5}[model] * length
        work, damped = 1e6 * (1.0 + math.sin(t)), 1e5 * t
        rows.append({"time [s]": t, "crack_mouth_opening [m]": 0.01 * math.sin(6 * t) - (0.05 if model == 1 else 0.0),
                     "K_I [Pa sqrt(m)]": 8e6 * math.sin(t), "crack_length [m]": length, "uplift_force [N/m]": uplift,
                     "mouth_pressure [Pa]": 4e5, "wet_length [m]": 0.6 * length, "penetration [m]": 0.1 if model == 1 and t > 4 else 5e-5,
                     "kinetic_energy [J/m]": 0.25 * work - 0.25e6, "strain_energy [J/m]": 0.75 * work + 1e5 - damped,
                     "input_energy [J/m]": work - 1e6, "load_energy [J/m]": 0.25e6 - 0.25e6 * (t == 0), "damped_energy [J/m]": damped,
                     "radiated_energy [J/m]": 0.0, "contact_energy [J/m]": -0.25e6 + 0.25e6 * (t == 0), "water_energy [J/m]": 0.0,
                     "growth_energy [J/m]": 0.0})
    return rows


def profile(time, model):
    peak = 4e5 if model < 3 else 3e5 + 1e5 * math.sin(time)
    return {"time": time, "crack": 0, "position": [0.0, 5.0, 10.0], "pressure": [peak, peak if model < 3 else 0.5 * peak, peak if model < 3 else 0.0],
            "pair_position": [0.0, 5.0], "opening": [0.01, 0.005]}


def write_run(folder, name, model, until=5.0, status="completed"):
    (folder / name).mkdir(parents=True, exist_ok=True)
    rows = history(model, until)
    with (folder / name / "history.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)
    times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 4.05, 4.45]
    (folder / name / "summary.json").write_text(json.dumps({"status": status, "quantities": {
        "crack_path": [[1, 60], [1 + 3 * model, 60 - model]], "profiles": [profile(t, model) for t in times]}}))


def write_fields(path, displacement=0.001):
    """Two triangles, from the third picture on a third one; written as VTKHDF 2.0 with one part a mesh."""
    points = [numpy.array([[0, 0, 0], [70, 0, 0], [0, 103, 0], [15, 103, 0]], float)]
    points.append(numpy.vstack([points[0], [[35, 60, 0]]]))
    cells = [[(0, 1, 2), (1, 3, 2)], [(0, 1, 4), (0, 4, 2), (1, 3, 2)]]
    part_of = [0, 0, 0, 1, 1, 1]
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["Points"] = numpy.vstack(points)
        root["NumberOfPoints"] = [len(p) for p in points]
        root["NumberOfCells"] = [len(c) for c in cells]
        root["NumberOfConnectivityIds"] = [3 * len(c) for c in cells]
        root["Connectivity"] = [corner for part in cells for cell in part for corner in cell]
        root["Offsets"] = [3 * i for part in cells for i in range(len(part) + 1)]
        steps = root.create_group("Steps")
        steps["Values"] = [0.1 * i for i in range(6)]
        for name, size in (("PartOffsets", None), ("PointOffsets", len(points[0])), ("CellOffsets", len(cells[0])),
                           ("ConnectivityIdOffsets", 3 * len(cells[0]))):
            steps[name] = [part * (1 if size is None else size) for part in part_of]
        moved = [numpy.full((len(points[part]), 3), displacement * i) for i, part in enumerate(part_of)]
        steps["PointDataOffsets/displacement"] = numpy.cumsum([0] + [len(m) for m in moved[:-1]])
        root["PointData/displacement"] = numpy.vstack(moved)


def write(folder, layout=LAYOUT):
    """Every run of the layout below `folder`."""
    for job in koyna_runs.jobs(layout):
        model = 2 if "model-2" in job.name else 3 if "model-3" in job.name else 1
        write_run(folder, job.name, model)
    write_fields(folder / "model-3/results.h5")
    (folder / "mesh.svg").write_text('<svg viewBox="0 0 10 10"><path d="M1 1L9 1L9 9Z" stroke="#0072b2" fill="none"/></svg>')
