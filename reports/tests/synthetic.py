"""Records of an invented catalogue, in the format of verification/harness/record.schema.json: nothing here was computed.

Holds what a real catalogue holds on its best and on its worst days: sweeps, ladders with and without a failing rung, a
wrong value, a known limit, loose and tight tolerances, a refusal, numbers that are not numbers.
"""
import json

SCHEMA = 1
FAMILIES = {"patch": 4, "sif": 8, "modal": 4, "stability": 6}


def reference(name="answer", kind="exact", **more):
    return {"name": name, "class": kind, "unit": "1", "source": "Timoshenko 1951", "locator": "Eq. (24)", "uncertainty": 0.0,
            "uncertainty_is_relative": True, **more}


def check(name, error=1e-12, tolerance=1e-11, **more):
    return {"name": name, "kind": "value", "gates": True, "status": "pass" if error <= tolerance else "wrong value",
            "evidence": "exact", "basis": "round-off", "reason": "rounding of a 32 × 32 system, a factor of ten above it",
            "reference_name": "answer", "value": 1.0 + error, "reference": 1.0, "error": error, "tolerance": tolerance,
            "compared": 1, "setting": 0, "message": "", "orders": [], **more}


def own_check(name, kind):
    """A check that the harness adds to a case: it has no entry in the case file."""
    return check(name, 0.0, 0.0, kind=kind, evidence="law", basis="specification")


def order_check(name, order):
    return check(name, abs(order - 2.0), 0.15, kind="order", evidence="order", basis="discretisation", value=order, reference=2.0,
                 reason="order 2 of the mass of static modes", compared=4,
                 orders=[{"convergence": "monotone", "order": order, "pairwise": [1.9, 1.97, order], "extrapolated": 9.87,
                          "convergence_index": 2e-4, "levels_used": 4}])


def setting(keys, seconds, errors, standard=False, status="pass", message="", dofs=98):
    return {"keys": keys, "default": standard, "status": status, "message": message, "errors": errors,
            "cpu_seconds": seconds, "cpu_spread": 0.04, "repeats": 9, "dofs": dofs,
            "peak_bytes": 12_000_000, "parts": [], "counts": []}


def case(identity, **more):
    family = identity.split("/")[0]
    record = {
        "record": SCHEMA, "id": identity, "version": 1, "family": family, "tier": "quick",
        "title": identity.split("/")[1].replace("-", " ").capitalize(),
        "requirement": f"The {family} of {identity.split('/')[1].replace('-', ' ')} shall agree with its answer within the tolerance.",
        "why": "Whoever changes the coefficient matrices learns here whether a known field still comes out.",
        "modules": ["mesh", "sbfem"], "status": "pass", "message": "",
        "references": [reference()], "checks": [check("displacement", 3e-13), check("stress", 4e-12)],
        "settings": [setting({}, 0.004, {"displacement": 3e-13})], "sweep": {"error": "", "series": []}, "pins": {},
        "negatives": [], "cpu_seconds": 0.02, "peak_bytes": 12_000_000,
    }
    return {**record, **more}


def sweep_case(identity, kind, quantity="K_I", scale=1.0):
    settings, rows = [], [(1, .13, .0008), (2, 7e-3, .0011), (3, 2e-4, .0015), (4, 2e-5, .0021), (6, 3e-8, .0062),
                          (8, 5e-10, .0138), (10, 6e-11, .028), (12, 1.5e-11, .051)]
    for p, error, seconds in rows:
        settings.append(setting({"mesh.cells": '"one"', "mesh.degree": "2 … 12", "mesh.order": str(p)}, scale * seconds, {quantity: error}, p == 6,
                                dofs=24 * p + 2))
    for p, n, error, seconds in [(1, 8, .066, .004), (1, 16, .016, .013), (1, 32, 4e-3, .05), (2, 4, 4e-3, .003), (2, 8, 2.3e-4, .01),
                                 (2, 16, 1.4e-5, .04), (4, 4, 9e-6, .009), (4, 8, 1.3e-8, .04)]:
        settings.append(setting({"mesh.cells": '"squares"', "mesh.degree": str(p), "mesh.size": str(1 / n)}, scale * seconds,
                                {quantity: error}, dofs=2 * n * n * p))
    settings.append(setting({"mesh.cells": '"one"', "mesh.degree": "2 … 12", "mesh.order": "64"}, 1.4, {}, status="not converged", message="32 merges"))
    return case(identity, references=[reference(kind=kind)], checks=[check(quantity, 5e-10, 1e-8, evidence=kind, compared=17)],
                settings=settings, sweep={"error": quantity, "series": ["mesh.cells", "mesh.degree"]},
                negatives=[negative("sbfem/side-face-load-sign", [quantity])])


def ladder_case(identity, failing=None, wrong=False):
    rungs = [setting({"parameters.aspect": f"1e{k}"}, .001, {"force": 10.0 ** (k - 15)}) for k in range(9)]
    if failing is not None:
        for rung in rungs[failing:]:
            rung.update(status="refused", message="polygon 0: aspect ratio above 1e7", errors={})
    if wrong:
        rungs[failing].update(status="wrong value", message="not a number", errors={"force": None})
    reached = len(rungs) if failing is None else failing
    return case(identity, status="wrong value" if wrong else "pass", settings=rungs, first_failing_rung=reached,
                checks=[check("force", 1e-7, 1e-6, compared=9), own_check("ladder", "ladder"), own_check("parts", "contract")])


def negative(fault, checks, verdict="killed"):
    return {"fault": fault, "checks": checks, "red": checks if verdict == "killed" else [], "reached": True, "verdict": verdict}


def catalogue(good=True):
    """Records of a catalogue; on a bad day (`good` false) with failures."""
    cases = [case(f"patch/polynomial-order-{p}", references=[reference()],
                  negatives=[negative("sbfem/e1-transposed", ["displacement", "stress"])]) for p in (1, 2, 3, 8)]
    cases += [
        sweep_case("sif/edge-crack", "high-precision"), sweep_case("sif/edge-crack-shear", "cross-code", scale=6),
        case("sif/centre-crack", references=[reference(kind="published", source="isida-1971", locator="Table 2", uncertainty=5e-4)],
             checks=[check("K_I", 4.1e-5, 5e-4, evidence="published", basis="uncertainty", gates=False), check("K_II", 1e-11, 1e-9)]),
        case("sif/extractions-agree", references=[], checks=[
            check("projection is M-integral", 8.5e-12, 1e-11, kind="invariant", evidence="law", reference_name="")]),
        case("sif/face-pressure", negatives=[negative("sbfem/particular-part-dropped", ["displacement"])]),
        case("sif/negative-size", references=[], checks=[
            check("named", 0.0, 0.0, kind="refused", evidence="refusal", basis="specification", reference_name="",
                  message="scene.toml:9:8: mesh.size: -1 is not > 0")], settings=[]),
        case("modal/roller-square", checks=[order_check("omega_1 squared", 2.02), check("omega_1", 2.66e-3, 3e-3)],
             settings=[setting({"mesh.size": str(1 / n)}, 2e-4 * n * n, {"omega_1": .68 / n**2}, n == 8) for n in (2, 4, 8, 16)],
             sweep={"error": "omega_1", "series": []},
             negatives=[negative("sbfem/mass-factor-two", ["omega_1"])]),
        case("modal/cantilever"), case("modal/koyna-empty"),
        ladder_case("stability/slivers", 7, wrong=not good), ladder_case("stability/short-edges"), ladder_case("stability/centre-near-an-edge"),
    ]
    if not good:
        cases.append(case("sif/arc-crack", status="wrong value", message="K_II", checks=[check("K_I", 1e-9, 1e-6),
                                                                                 check("K_II", 2e-3, 1e-6)]))
        cases.append(case("sif/kinked-crack", status="wrong value", message="not a number",
                          checks=[{**check("K_I"), "value": None, "error": None, "status": "wrong value", "message": "not a number"}]))
        cases.append(case("sif/unfinished", status="checked nothing", message="there is no study", checks=[], settings=[]))
        cases.append(case("modal/wave", status="known limit", message="needs an interior mode; until 2027-06-30",
                          checks=[check("omega_9", 4e-2, 1e-2, status="known limit", message="needs an interior mode; until 2027-06-30")],
                          negatives=[negative("sbfem/mass-factor-two", ["omega_9"], "survived")]))
    return cases


def benchmark_file():
    def row(name, seconds, threads=1, **counters):
        return {"name": name, "run_type": "iteration", "iterations": 100, "real_time": seconds * 1e9, "cpu_time": seconds * 1e9,
                "time_unit": "ns", "threads": threads, **counters}
    rows = [row(f"stiffness/{route}/nodes:{n}", factor * 1.2e-8 * n**2.7, nodes=n, relative_error=1e-14)
            for route, factor in (("ring_doubling", 1), ("matrix_sign", 2.6), ("ordered_schur", 7)) for n in (4, 8, 16, 32, 64, 128, 256)]
    rows += [row(f"polygons_718/cores:{c}", s, cores=c) for c, s in ((1, .0021), (2, .0013))]
    rows += [row("static/koyna_718", .043)]
    return {"context": {"date": "2026-01-01T00:00:00+00:00", "host_name": "invented", "num_cpus": 2, "mhz_per_cpu": 2000,
                        "library_build_type": "release"}, "benchmarks": rows}


def environment():
    return {"commit": "0123abc", "compiler": "gcc 12.2.0", "machine": "x86-64, 2 cores", "threads": 1}


def case_file(record):
    """The case file that belongs to a record, as far as the report reads it."""
    lines = [f"{key} = {json.dumps(record[key], ensure_ascii=False)}" for key in ("version", "title", "requirement", "why", "family", "tier",
                                                                                 "modules")]
    for c in record["checks"]:
        if c["kind"] not in ("ladder", "contract"):
            lines += ["[[check]]"] + [f"{key} = {json.dumps(c[source], ensure_ascii=False)}" for key, source in (
                ("name", "name"), ("reason", "reason"), ("reference", "reference_name")) if c[source]]
            if c["kind"] == "value":
                lines += [f"tolerance = {c['tolerance']}"]
            if c["kind"] == "order":
                lines += ['over = "mesh.size"']
    return "\n".join(lines) + "\n"


def write(folder, good=True, cases=None):
    """Writes the records below `folder` (a pathlib.Path), and the case files in its folder `cases`."""
    (folder / "benchmarks").mkdir(parents=True, exist_ok=True)
    plain, faulted = [], []
    for record in catalogue(good) if cases is None else cases:
        path = folder / "cases" / f"{record['id']}.case.toml"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(case_file(record), encoding="utf-8")
        checks = [{k: v for k, v in c.items() if k not in ("reason", "reference_name")} for c in record["checks"]]
        record = {k: v for k, v in record.items() if k not in ("why", "modules")}
        plain.append({**record, "checks": checks, "negatives": [], "environment": {**environment(), "faulted": False}})
        if record["negatives"]:
            faulted.append({**record, "checks": checks, "environment": {**environment(), "faulted": True}})
    for name, lines in (("catalogue.jsonl", plain), ("faults.jsonl", faulted)):
        (folder / name).write_text("".join(json.dumps(line, ensure_ascii=False) + "\n" for line in lines), encoding="utf-8")
    (folder / "scenes/dam").mkdir(parents=True, exist_ok=True)
    (folder / "scenes/dam.svg").write_text('<svg viewBox="0 0 10 10"><rect width="10" height="10" fill="#fff"/>'
                                           '<path d="M1 1L9 1L9 9Z" stroke="#0072b2" fill="none"/></svg>')
    (folder / "scenes/dam/summary.json").write_text(json.dumps({
        "status": "completed", "mesh": {"polygons": 2, "nodes": 4}, "quantities": {"tips": [{"K_I": -1.56e6}]}}))
    (folder / "benchmarks" / "sbfem_benchmark.json").write_text(json.dumps(benchmark_file()))
