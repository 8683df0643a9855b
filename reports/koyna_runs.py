"""python3 -m reports.koyna_runs --program build/release/bin/sunder --output build/records/koyna

Runs the scenes of the chapter "Koyna", two at a time with one thread each: the paper's three models, the crack that keeps
its length, and every run that changes one choice. Each leaves a folder with summary.json and history.csv. A run that ends
early is a finding and is shown as one; exit status 1 where a run left nothing.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import time
from dataclasses import dataclass

from reports import page

SCENES = page.HERE.parent / "verification/cases/koyna"


@dataclass(frozen=True)
class Job:
    name: str         # of its folder
    scene: str        # in SCENES, without the suffix
    settings: tuple   # "key=value", replacing what the scene says


def change_name(model, change):
    return f"model-{model}-{change['name']}"


def scene_of(model, change):
    """(scene, settings) of a change for one model; a change on another scene says what makes that scene the model."""
    if "scene" not in change:
        return f"model-{model}", tuple(change["set"])
    return change["scene"], (*change["set"], *change.get(f"model_{model}", ()))


def film_settings(wanted):
    """Fields and pressure at every picture of the film, and pressure at the times of the paper's figure."""
    film = wanted["film"]
    times = [round(i * film["every"], 9) for i in range(round(film["until"] / film["every"]) + 1)]
    return (f"output.fields_every={film['steps']}", f"output.profile_times={sorted({*times, *wanted['times']})}")


def jobs(layout):
    """Every run of the chapter, the longest first."""
    wanted = layout["koyna"]
    found = [Job(m["run"], m["scene"], film_settings(wanted) if m["number"] == wanted["film"]["model"] else ()) for m in wanted["model"]]
    for change in wanted["change"]:
        for model in change.get("models", (2, 3)):
            scene, settings = scene_of(model, change)
            found.append(Job(change_name(model, change), scene, settings))
    fixed = wanted["stationary"]
    found += [Job(f"stationary-{c['name']}", fixed["scene"], (*fixed["set"], *c["set"])) for c in fixed["case"]]
    names = [job.name for job in found]
    for name in names:
        if names.count(name) > 1:
            raise page.LayoutError(f"layout: koyna: two runs have the name {name!r}")
    return found


def run(program, output, job):
    """The program's message where the run left no summary, else nothing."""
    command = [program, "run", SCENES / f"{job.scene}.scene.toml", "--quiet", "--threads", "1", "--output", output / job.name]
    for setting in job.settings:
        command += ["--set", setting]
    summary = output / job.name / "summary.json"
    summary.unlink(missing_ok=True)
    done = subprocess.run(command, capture_output=True, text=True)
    return "" if summary.is_file() else f"{job.name}: {done.stderr.strip() or f'exit status {done.returncode}'}"


def main():
    parser = argparse.ArgumentParser(prog="python3 -m reports.koyna_runs", description="Runs the scenes of the chapter Koyna.")
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--layout", type=pathlib.Path, default=page.HERE / "layout.toml")
    options = parser.parse_args()
    begin = time.monotonic()
    wanted = jobs(page.read_layout(options.layout))
    options.output.mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        failures = [f for f in pool.map(lambda job: run(options.program, options.output, job), wanted) if f]
    for failure in failures:
        print(f"koyna: {failure}", file=sys.stderr)
    print(f"koyna: {len(wanted) - len(failures)} of {len(wanted)} runs, in {time.monotonic() - begin:.0f} s")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
