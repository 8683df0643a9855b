"""ci/parts: builds without optional parts. Exit status: 0 all as promised, 1 a promise is broken, 2 unusable."""
import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from benchmarks.costs import counting

CASES = Path("verification/cases")
# A scene that names the part, with what it is told; and the words of the refusal.
NAMED = {
    "contact": ("koyna/model-3.scene.toml", "contact"),
    "crackwater": ("crack-water/crack-45m.scene.toml", "crack water"),
    "foundation": ("foundation/koyna-on-rock.scene.toml", "foundation"),
    "reservoir": ("reservoir/unit-face.scene.toml", "reservoir"),
}
# Scenes that name none of these parts: name, scene, overrides. Small, for they run in callgrind from start to end.
PLAIN = (
    ("static crack", "sif/edge-crack.scene.toml", ("mesh.cells=\"squares\"", "mesh.size=0.25", "mesh.order=2")),
    ("steps", "dynamics/rod.scene.toml", ()),
)
ALLOWED = 0.005


class PartsError(RuntimeError):
    """A build or a run that did not come about."""


def build_without(parts, folder, jobs):
    """The program without these parts."""
    options = [f"-DSUNDER_WITH_{part.upper()}={'OFF' if part in parts else 'ON'}" for part in NAMED]
    for step in (["cmake", "-S", ".", "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSUNDER_TESTS=OFF",
                  "-DSUNDER_BENCHMARKS=OFF", "-DSUNDER_WARNINGS_AS_ERRORS=ON", *options],
                 ["ninja", "-C", folder, "-j", str(jobs), "sunder"]):
        done = subprocess.run(step, capture_output=True, text=True)
        if done.returncode != 0:
            raise PartsError(f"{' '.join(map(str, step))}\n{(done.stdout + done.stderr)[-3000:]}")
    return Path(folder) / "bin" / "sunder"


def refusal_fault(program, part):
    """What is wrong with the refusal of a scene that names `part`; None where it is right."""
    scene, words = NAMED[part]
    for action in ("run", "check"):
        done = subprocess.run([program, action, CASES / scene], capture_output=True, text=True)
        if done.returncode != 2 or f"this build has no {words}" not in done.stderr:
            return f"sunder {action} {scene}: status {done.returncode}, \"{done.stderr.strip()[:200]}\""
    return None


def command_of(program, scene, overrides, output):
    command = [str(Path(program).absolute()), "run", str((CASES / scene).absolute()), "--threads", "1", "--quiet", "--output",
               str(output)]
    for override in overrides:
        command += ["--set", override]
    return command


def quantities(program, scene, overrides):
    """Everything that the run found, as text: the same bits are the same text."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(command_of(program, scene, overrides, folder), capture_output=True, text=True)
        if done.returncode != 0:
            raise PartsError(f"sunder run {scene}: status {done.returncode}: {done.stderr.strip()[-300:]}")
        return json.dumps(json.loads((Path(folder) / "summary.json").read_text())["quantities"], sort_keys=True)


def instructions(program, scene, overrides):
    """Of the whole run, from start to end."""
    with tempfile.TemporaryDirectory(prefix="parts") as folder:
        command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null",
                   *command_of(program, scene, overrides, Path(folder) / "results")]
        done = subprocess.run(command, capture_output=True, text=True, env=counting.ENVIRONMENT)
        found = re.search(r"Collected : (\d+)", done.stderr)
        if done.returncode != 0 or not found:
            raise PartsError(f"{scene}: status {done.returncode}: {done.stderr.strip()[-300:]}")
        return int(found.group(1))


def main(words=None):
    parser = argparse.ArgumentParser(prog="ci/parts", description=__doc__)
    parser.add_argument("parts", nargs="*", choices=[*NAMED, []], help="left out, one build each; none: every one, and all")
    parser.add_argument("--whole", type=Path, required=True, help="the program with all parts")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args(words)
    left_out = [[part] for part in arguments.parts] or [[part] for part in NAMED] + [list(NAMED)]
    broken = False
    try:
        whole = {name: (quantities(arguments.whole, scene, overrides), instructions(arguments.whole, scene, overrides))
                 for name, scene, overrides in PLAIN}
        for parts in left_out:
            label = "all" if len(parts) > 1 else parts[0]
            program = build_without(parts, Path("build/parts") / label, arguments.jobs)
            for part in parts:
                fault = refusal_fault(program, part)
                broken |= fault is not None
                print(f"without {label:11} a scene with {part}: {fault or 'refused by name'}", flush=True)
            for name, scene, overrides in PLAIN:
                bits = quantities(program, scene, overrides) == whole[name][0]
                count = instructions(program, scene, overrides)
                share = whole[name][1] / count - 1.0  # what the part costs a scene that does not use it
                broken |= not bits or share > ALLOWED
                print(f"without {label:11} {name:12} {'same bits' if bits else 'OTHER NUMBERS'}, {count:,} instructions; the "
                      f"whole build has {100 * share:+.4f} %{'  BEYOND 0.5 %' if share > ALLOWED else ''}", flush=True)
    except (PartsError, OSError) as error:
        print(f"ci/parts: {error}", file=sys.stderr)
        return 2
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
