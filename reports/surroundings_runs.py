"""python3 -m reports.surroundings_runs --program build/release/bin/sunder --output build/records/surroundings

Makes the runs behind the figures of reservoir, foundation and linear shaking, one after the other: each leaves a folder with
summary.json, and history.csv where time passes. Exit status 1 where a run did not complete.
"""
import argparse
import csv
import math
import pathlib
import subprocess
import sys
import time
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).parent.parent
CASES = ROOT / "verification/cases"
REFERENCES = ROOT / "reference-data"
SPECTRUM, IMPULSE, STRIP = (f"{name}.csv" for name in ("independent-reservoir-2026/force-spectrum", "independent-reservoir-2026/impulse",
                                                       "independent-foundation-2026/strip"))
BOTTOMS = {"rigid": 1.0, "absorbing": 0.75}  # column of the references: reflection coefficient
FACE_ELEMENTS = 10                           # of the cases face-rigid and face-absorbing

DAM = {"mesh.size": 3.5, "dynamics.time_step": 0.002}
# The program matches damping at the first mode of the dam by itself, the independent program at that of the dam in water:
# 17.97 and 16.41 rad/s (references of the cases modal/koyna-section and reservoir/koyna-incompressible).
WATER = {"reservoir.boundary": '"upstream"', "reservoir.level": 91.75, "dynamics.damping_ratio": round(0.05 * 17.975 / 16.407, 4)}
ROCK = {"support": [], "dynamics.time_step": 0.01, "foundation.boundary": '"base"', "foundation.youngs_modulus": 25e9, "foundation.poisson_ratio": 0.2, "foundation.density": 2450}


@dataclass(frozen=True)
class Run:
    name: str       # of its folder
    scene: str      # in CASES, without the suffix
    settings: dict  # key: value as TOML writes it


def reference(name, folder=REFERENCES):
    """Column -> values of a table of the reference data."""
    with (folder / name).open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {column: [float(row[column]) for row in rows] for column in rows[0]}


def frequency_ratios():
    """ω/ω1 of the spectra: 0.02 apart, none at a resonance of the rigid bottom (1, 3), and those of the reference."""
    return sorted({round(0.01 + 0.02 * i, 2) for i in range(200)} | set(reference(SPECTRUM)["r"]))


def impulse_times(latest):
    """c t / H of the impulse responses, 0.05 apart."""
    return [round(0.05 * i, 2) for i in range(round(latest / 0.05) + 1)]


def strip_frequencies():
    """a0 of the strip: 0.1 apart, up to the last that its case checks."""
    return [round(0.1 * i, 1) for i in range(1, 21)]


def runs():
    found = []
    for bottom, reflection in BOTTOMS.items():
        water = {"reservoir.reflection_coefficient": reflection}
        spectrum = {**water, "response.frequencies": [0.5 * math.pi * r for r in frequency_ratios()]}
        # as a formula there is a response for all times over a rigid bottom, up to the first echo over another
        exact = {**water, "response.times": impulse_times(20.0 if reflection == 1.0 else 1.0)}
        face = {"response.face_elements": FACE_ELEMENTS}
        scene = "reservoir/unit-face"
        found += [Run(f"spectrum-{bottom}", scene, spectrum), Run(f"spectrum-{bottom}-face", scene, {**spectrum, **face}),
                  Run(f"impulse-{bottom}", scene, exact),
                  Run(f"impulse-{bottom}-face", scene, {**exact, "response.times": impulse_times(20.0), **face})]
    found.append(Run("strip", "foundation/rigid-strip", {"response.frequencies": strip_frequencies()}))
    for name, more in (("empty", {}), ("incompressible", {**WATER, "reservoir.model": '"incompressible"'}),
                       ("compressible", WATER), ("rock", ROCK)):
        found.append(Run(f"koyna-{name}", "dynamics/koyna-linear", {**DAM, **more}))
    return found


def make(program, output, run):
    """The program's message where the run did not complete, else nothing."""
    command = [program, "run", CASES / f"{run.scene}.scene.toml", "--quiet", "--output", output / run.name]
    for key, value in run.settings.items():
        command += ["--set", f"{key}={value}"]
    (output / run.name / "summary.json").unlink(missing_ok=True)
    done = subprocess.run(command, capture_output=True, text=True)
    return f"{run.name}: {done.stderr.strip() or f'exit status {done.returncode}'}" if done.returncode else ""


def main():
    parser = argparse.ArgumentParser(prog="python3 -m reports.surroundings_runs", description="Makes the runs of the report's figures of surroundings.")
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--only", default="", help="runs whose name begins like this")
    options = parser.parse_args()
    begin = time.monotonic()
    options.output.mkdir(parents=True, exist_ok=True)
    wanted = [run for run in runs() if run.name.startswith(options.only)]
    failures = [f for f in (make(options.program, options.output, run) for run in wanted) if f]
    for failure in failures:
        print(f"surroundings: {failure}", file=sys.stderr)
    print(f"surroundings: {len(wanted) - len(failures)} of {len(wanted)} runs, in {time.monotonic() - begin:.0f} s")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
