"""Convolution and flux search on one and two threads: the records of benchmarks/two_cores_benchmark.cpp -> figure, rows."""
import json
import re
from dataclasses import dataclass

import matplotlib.pyplot as plt

from reports.figures import INK, SERIES, SIZE, STYLE, Figure, FigureError, element

NAMES = {"convolution_phases": "convolution", "flux_search_phases": "flux search"}


@dataclass(frozen=True)
class Profile:
    """One program on some threads; phases in the order of the record."""
    name: str
    threads: int
    wall: dict   # phase -> seconds
    cpu: dict


def read(path):
    """[Profile] of a file of Google Benchmark; a benchmark that found a wrong answer is an error."""
    profiles = []
    for entry in json.loads(path.read_text(encoding="utf-8"))["benchmarks"]:
        if entry.get("error_occurred"):
            raise FigureError(f"{path.name}: {entry['name']}: {entry.get('error_message', 'failed')}")
        threads = re.search(r"threads:(\d+)", entry["name"])
        name = NAMES.get(entry["name"].split("/")[0])
        if threads is None or name is None:
            continue
        phases = [key[:-5] for key in entry if key.endswith("_wall")]
        profiles.append(Profile(name, int(threads.group(1)), {p: entry[f"{p}_wall"] for p in phases},
                                {p: entry[f"{p}_cpu"] for p in phases}))
    return profiles


def rows(profiles):
    """[(name, phase, wall on one, wall on two, speed-up, efficiency, useful share of the work)] where both were run.

    Efficiency is speed-up over threads. The useful share is CPU(1) / CPU(2): it does not feel what else the machine does,
    and two free cores give at most twice that as a speed-up."""
    found = []
    for one in (p for p in profiles if p.threads == 1):
        two = next((p for p in profiles if p.name == one.name and p.threads == 2), None)
        if two is None:
            raise FigureError(f"{one.name}: no record on two threads")
        for phase in [*one.wall, "all"]:
            wall = [sum(p.wall.values()) if phase == "all" else p.wall[phase] for p in (one, two)]
            cpu = [sum(p.cpu.values()) if phase == "all" else p.cpu[phase] for p in (one, two)]
            found.append((one.name, phase.replace("_", ", "), *wall, wall[0] / wall[1], wall[0] / wall[1] / 2.0, cpu[0] / cpu[1]))
    return found


def phase_chart(key, profiles, caption):
    """Wall time of each phase, one bar a number of threads; the speed-up stands beside the second."""
    if not profiles:
        raise FigureError(f"{key}: no profile")
    names = list(dict.fromkeys(p.name for p in profiles))
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(len(names), 1, figsize=(SIZE[0], 1.5 * len(names)), layout="constrained", squeeze=False)
        for axes, name in zip(panels[:, 0], names):
            shown = sorted((p for p in profiles if p.name == name), key=lambda p: p.threads)
            alone = sum(shown[0].wall.values())
            for row, profile in enumerate(shown):
                start = 0.0
                for i, (phase, seconds) in enumerate(profile.wall.items()):
                    axes.barh(row, 1e3 * seconds, left=1e3 * start, color=SERIES[i], height=0.6,
                              label=phase.replace("_", ", ") if row == 0 else None)
                    start += seconds
                if row > 0:
                    axes.text(1e3 * start, row, f"  × {alone / start:.2f}", va="center", color=INK)
            axes.set_yticks(range(len(shown)), [f"{p.threads} thread{'s' if p.threads > 1 else ''}" for p in shown])
            axes.invert_yaxis()
            axes.set_title(name, loc="left", fontsize=8.5)
            axes.set_xlabel("wall time, ms")
            axes.grid(axis="y", visible=False)
            axes.margins(x=0.12)
            axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.45), ncols=3, handlelength=1.2)
        return Figure(key, element(figure, key, caption), caption)
