"""Water and rock around a dam: spectra, impulse responses, impedances, convolution costs, and the linear dam shaken.

Everything shown comes from the runs of surroundings_runs, the references that the cases name, the bars of these cases, and
the records of the benchmarks.
"""
import csv
import json
import re
import tomllib
from dataclasses import dataclass

from reports import surroundings_figures as draw
from reports import surroundings_runs as made
from reports import words
from reports.scenes import Scene
from reports.studies import LayoutError

BOTTOM_WORDS = {"rigid": "rigid bottom, α = 1", "absorbing": "absorbing bottom, α = 0.75"}
DAMS = {"empty": "empty reservoir, rigid rock", "incompressible": "incompressible water, rigid rock",
        "compressible": "compressible water, α = 0.75, rigid rock", "rock": "empty reservoir, elastic rock"}
# The cases whose references these dams have.
DAM_CASES = {"empty": "dynamics/koyna-linear", "incompressible": "dynamics/koyna-incompressible"}
METHODS = r"(?P<method>blocked_direct|block_fft|state_space)/n:20/N:(?P<steps>\d+)/threads:1/iterations:1"


@dataclass(frozen=True)
class Spectrum:
    name: str
    series: list
    face: list
    points: list
    series_bar: float
    face_bar: float


@dataclass(frozen=True)
class Impulse:
    name: str
    exact: list
    face: list
    points: list


@dataclass(frozen=True)
class Impedance:
    name: str
    values: list
    points: list


@dataclass(frozen=True)
class History:
    name: str
    times: list
    displacements: list  # mm, from where the crest stood
    range: tuple         # mm, of the independent program


@dataclass(frozen=True)
class Sources:
    """Where the figures' numbers are: run folders, case files, benchmarks as records.Benchmark, reference tables."""
    runs: object
    cases: object
    benchmarks: list
    references: object = made.REFERENCES


def _quantities(sources, name):
    path = sources.runs / name / "summary.json"
    if not path.is_file():
        raise LayoutError(f"layout: surroundings: {path} is not there; ci/report makes it")
    run = json.loads(path.read_text(encoding="utf-8"))
    if run["status"] != "completed":
        raise LayoutError(f"layout: surroundings: {name}: {run['status']}")
    return run["quantities"]


def _matched(name, values, places):
    if len(values) != len(places):
        raise LayoutError(f"layout: surroundings: {name}: {len(values)} values for {len(places)} places; was it run by this version?")
    return values


def _history(sources, name):
    path = sources.runs / name / "history.csv"
    if not path.is_file():
        raise LayoutError(f"layout: surroundings: {path} is not there; ci/report makes it")
    with path.open(newline="", encoding="utf-8") as file:
        rows = [row for row in csv.reader(file) if row and not row[0].startswith("#")]
    # a heading may carry its unit: time [s]
    return {head.split(" ")[0]: [float(row[i]) for row in rows[1:]] for i, head in enumerate(rows[0])}


def _case(sources, identity):
    path = sources.cases / f"{identity}.case.toml"
    if not path.is_file():
        raise LayoutError(f"layout: surroundings: there is no case {identity!r}")
    return tomllib.loads(path.read_text(encoding="utf-8"))


def _bar(sources, identity):
    """The tolerance of the real part of a force. The cases compare 2F."""
    return 0.5 * next(c for c in _case(sources, identity)["check"] if c["name"] == "real")["tolerance"]


def _complex(pairs):
    return [complex(*pair) for pair in pairs]


def spectrum(sources, caption):
    ratios, table = made.frequency_ratios(), made.reference(made.SPECTRUM, sources.references)
    curves, rows = [], []
    for bottom, name in BOTTOM_WORDS.items():
        series, face = (_matched(run, _complex(_quantities(sources, run)["force"]), ratios) for run in (f"spectrum-{bottom}", f"spectrum-{bottom}-face"))
        points = [(r, 0.5 * complex(a, b)) for r, a, b in zip(table["r"], table[f"{bottom}_real"], table[f"{bottom}_imaginary"])]
        curves.append(Spectrum(name, series, face, points, _bar(sources, f"reservoir/spectrum-{bottom}"), _bar(sources, f"reservoir/face-{bottom}")))
        at = dict(zip(ratios, zip(series, face)))
        largest = lambda which: max(max(abs((at[r][which] - f).real), abs((at[r][which] - f).imag)) for r, f in points)
        rows += [(f"{name}: formula, off by at most", f"{words.error(largest(0))}; bar {words.error(curves[-1].series_bar)}"),
                 (f"{name}: {made.FACE_ELEMENTS} elements", f"{words.error(largest(1))}; bar {words.error(curves[-1].face_bar)}")]
    return draw.force_spectrum("surroundings-spectrum", ratios, curves, caption), rows


def impulse(sources, caption):
    table, curves, rows = made.reference(made.IMPULSE, sources.references), [], []
    for bottom, name in BOTTOM_WORDS.items():
        exact = _quantities(sources, f"impulse-{bottom}")["impulse_force"]
        face = _quantities(sources, f"impulse-{bottom}-face")["impulse_force"]
        exact = list(zip(_matched(f"impulse-{bottom}", made.impulse_times(20.0 if bottom == "rigid" else 1.0), exact), exact))
        face = list(zip(_matched(f"impulse-{bottom}-face", made.impulse_times(20.0), face), face))
        points = list(zip(table["T"], table[bottom]))
        curves.append(Impulse(name, exact, face, points))
        for what, line in (("formula", dict(exact)), (f"{made.FACE_ELEMENTS} elements", dict(face))):
            off = max(abs(line[t] - v) for t, v in points if t in line)
            rows.append((f"{name}: {what}, off by at most", words.error(off)))
    return draw.impulse_response("surroundings-impulse", curves, caption), rows


def impedance(sources, caption):
    frequencies, table = made.strip_frequencies(), made.reference(made.STRIP, sources.references)
    found, curves, rows = _matched("strip", _quantities(sources, "strip")["impedance"], frequencies), [], []
    for letter, name in (("H", "H, horizontal"), ("V", "V, vertical"), ("R", "R, rocking, / b²")):
        values = _complex(f[letter] for f in found)
        points = [(a, complex(x, y)) for a, x, y in zip(table["a0"], table[f"{letter}_re"], table[f"{letter}_im"])]
        at = dict(zip(frequencies, values))
        off = max(abs(at[a] - v) / abs(v) for a, v in points if a in at)
        curves.append(Impedance(name, values, points))
        rows.append((f"{letter}: furthest from the independent solution", f"{words.error(100 * off)} % of its size"))
    return draw.impedance("surroundings-impedance", frequencies, curves, caption), rows


def convolution(sources, caption):
    series, plain = {}, {}
    for b in sources.benchmarks:
        match = re.fullmatch(METHODS, b.name)
        if match:
            steps = int(match["steps"])
            line = series.setdefault({"block_fft": "block FFT"}.get(match["method"], match["method"].replace("_", " ")), [])
            line.append((steps, b.cpu_seconds, b.counters["error"], b.counters["stated"]))
            plain.setdefault(steps, b.counters["plain_seconds"])
    if len(series) < 3:
        raise LayoutError("layout: surroundings: the records have no convolution_benchmark of all three methods; ci/benchmark makes it")
    rows = []
    for name, line in series.items():
        line.sort()
        steps, seconds, _, _ = line[-1]
        rows.append((f"{name}, {steps:g} steps", f"{words.seconds(seconds)}, 1/{words.number(plain[steps] / seconds, 2)} of the plain sum"))
    return draw.convolution("surroundings-convolution", series, sorted(plain.items()), caption), rows


def crest(sources, caption):
    curves, rows = [], []
    for dam, name in DAMS.items():
        columns = _history(sources, f"koyna-{dam}")
        moved = [1e3 * (u - columns["crest_displacement_x"][0]) for u in columns["crest_displacement_x"]]
        independent = ()
        if dam in DAM_CASES:
            independent = tuple(1e3 * v for v in next(r for r in _case(sources, DAM_CASES[dam])["reference"] if r["name"] == "extremes")["value"])
        curves.append(History(name, columns["time"], moved, independent))
        rows.append((name, f"{words.number(min(moved), 4)} … {words.number(max(moved), 4)} mm"))
        if independent:
            rows.append(("the same, independent program", f"{words.number(independent[0], 4)} … {words.number(independent[1], 4)} mm"))
    return draw.crest_histories("surroundings-crest", curves, caption), rows


def energy(sources, caption):
    """What came in from ground and water is stored or damped. Water that shakes with the ground also pushes the dam, so its
    work counts with what came in."""
    columns, found = _history(sources, "koyna-compressible"), _quantities(sources, "koyna-compressible")
    mega = lambda name: [1e-6 * v for v in columns[f"{name}_energy"]]
    stored = [k + s for k, s in zip(mega("kinetic"), mega("strain"))]
    parts = {"damped": mega("damped"), "stored in the dam": [s - stored[0] for s in stored]}
    ground, water = mega("input"), [load - lost for load, lost in zip(mega("load"), mega("radiated"))]
    came_in = [a + b for a, b in zip(ground, water)]
    off = max(abs(sum(v) - whole) for whole, *v in zip(came_in, *parts.values()))
    rows = [(f"at the end: {name}", f"{words.number(values[-1], 6)} MJ/m") for name, values in
            {"from the ground": ground, "from the water": water, **parts}.items()]
    rows += [("largest gap between parts and whole at any step", f"{words.error(off)} MJ/m"),
             ("the program's own, of the largest energy", words.error(found["energy_balance_error"]))]
    return draw.energy_account("surroundings-energy", columns["time"], parts, ground, came_in, caption), rows


SECTIONS = {"spectrum": spectrum, "impulse": impulse, "impedance": impedance, "convolution": convolution, "crest": crest, "energy": energy}


def read(sources, layout):
    """The sections that [[surroundings]] of the layout asks for, in its order; none without."""
    shown = []
    for wanted in layout.get("surroundings", []):
        if wanted["figure"] not in SECTIONS:
            raise LayoutError(f"layout: surroundings: there is no figure {wanted['figure']!r}; there are {', '.join(SECTIONS)}")
        figure, rows = SECTIONS[wanted["figure"]](sources, wanted["caption"])
        shown.append(Scene(wanted["title"], wanted["words"], figure.svg, wanted["caption"], rows))
    return shown
