"""ci/compare REV: is the present tree slower than REV? Both programs, timed in turn on this machine, by CPU time.

Exit status: 0 nowhere slower, 1 slower somewhere, 2 unusable, 3 the machine is too noisy to tell."""
import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from benchmarks.costs import statistics
from benchmarks.costs.statistics import FASTER, NOISY, SAME, SLOWER

CASES = Path("verification/cases")
# Scenes of half a second or so, one for each kind of run: name, scene, overrides.
WORKLOADS = (
    ("static dam", "modal/koyna-section.scene.toml", ("mesh.size=1.5",)),
    ("linear steps", "dynamics/koyna-linear.scene.toml", ("mesh.size=6", "dynamics.duration=4")),
    ("coupled steps", "koyna/model-3.scene.toml", ("mesh.size=6", "dynamics.duration=1.5")),
    ("growth at rest", "propagation/kink-angle.scene.toml", ()),
    ("crack water", "crack-water/crack-45m.scene.toml", ("crack_line.segments=20000",)),
)
UNUSABLE = "not comparable"


class CompareError(RuntimeError):
    """A commit that cannot be built, a scene that cannot be run."""


def cpu_seconds(command):
    """User and system seconds of one run of `command`, and its exit status."""
    with open(os.devnull, "w") as nowhere:
        process = subprocess.Popen(command, stdout=nowhere, stderr=nowhere)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime + usage.ru_stime, process.returncode


def quadruple(a, b, timer=cpu_seconds):
    """The four times of A B B A."""
    times = []
    for command in (a, b, b, a):
        seconds, status = timer(command)
        if status != 0:
            raise CompareError(f"status {status}: {' '.join(map(str, command))}")
        times.append(seconds)
    return times


def judge(a, b, pairs, timer=cpu_seconds):
    """(word, interval of ln(B/A)) from a control of A against itself and two batches, their quadruples taken in turn so
    that all three see the same machine."""
    batches = [[], [], []]
    for _ in range(pairs):
        for batch, (left, right) in zip(batches, ((a, a), (a, b), (a, b))):
            batch.append(statistics.log_ratio(quadruple(left, right, timer)))
    return statistics.verdict(*batches)


def build(tree, folder, jobs):
    """The program `sunder` of the sources in `tree`, compiled in `folder`."""
    steps = (["cmake", "-S", tree, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DSUNDER_TESTS=OFF",
              "-DSUNDER_BENCHMARKS=OFF"], ["ninja", "-C", folder, "-j", str(jobs), "sunder"])
    for step in steps:
        done = subprocess.run(step, capture_output=True, text=True)
        if done.returncode != 0:
            raise CompareError(f"{' '.join(map(str, step))}\n{(done.stdout + done.stderr)[-2000:]}")
    return Path(folder) / "bin" / "sunder"


def commit_of(revision):
    done = subprocess.run(["git", "rev-parse", "--verify", "--quiet", revision + "^{commit}"], capture_output=True, text=True)
    if done.returncode != 0:
        raise CompareError(f"there is no commit {revision}")
    return done.stdout.strip()


def programs(revision, folder, jobs):
    """(program of the revision, program of the present tree)."""
    commit = commit_of(revision)
    tree = folder / commit[:10]
    if not tree.exists():
        done = subprocess.run(["git", "worktree", "add", "--detach", tree, commit], capture_output=True, text=True)
        if done.returncode != 0:
            raise CompareError(done.stderr.strip())
    return build(tree, folder / f"build-{commit[:10]}", jobs), build(Path.cwd(), folder / "build-present", jobs)


def commands(before, after, scene, overrides, folder):
    """The scene's command with either program; None with the reason where one refuses it."""
    both = []
    for name, program in (("before", before), ("after", after)):
        command = [program, "run", scene, "--threads", "1", "--quiet", "--output", folder / name]
        for override in overrides:
            command += ["--set", override]
        _, status = cpu_seconds(command)
        if status != 0:
            return None, f"the program of {'REV' if name == 'before' else 'the present tree'} ends with status {status}"
        both.append(command)
    return both, None


def main(words=None):
    parser = argparse.ArgumentParser(prog="ci/compare", description=__doc__)
    parser.add_argument("revision", metavar="REV")
    parser.add_argument("--pairs", type=int, default=10, help="quadruples A B B A in each batch, at least 8")
    parser.add_argument("--scene", type=Path, help="time this scene instead of the usual ones")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE", help="with --scene")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args(words)
    if arguments.pairs < 8:
        parser.error("--pairs: 8 are needed for an interval of 99 %")
    folder = Path("build/compare").absolute()
    folder.mkdir(parents=True, exist_ok=True)
    workloads = [("scene", arguments.scene, tuple(arguments.set))] if arguments.scene else \
        [(name, CASES / scene, overrides) for name, scene, overrides in WORKLOADS]
    seen = []
    try:
        before, after = programs(arguments.revision, folder, arguments.jobs)
        for name, scene, overrides in workloads:
            with tempfile.TemporaryDirectory() as results:
                both, reason = commands(before, after, scene, overrides, Path(results))
                if both is None:
                    seen.append(UNUSABLE)
                    print(f"{name:16} {UNUSABLE}: {reason}")
                    continue
                word, interval = judge(*both, arguments.pairs)
            seen.append(word)
            print(f"{name:16} {word:20} {100 * interval.median:+6.2f} % CPU, 99 % between {100 * interval.low:+.2f} and "
                  f"{100 * interval.high:+.2f} %", flush=True)
    except CompareError as error:
        print(f"ci/compare: {error}", file=sys.stderr)
        return 2
    if SLOWER in seen:
        return 1
    return 3 if NOISY in seen else 0 if SAME in seen or FASTER in seen else 2


if __name__ == "__main__":
    sys.exit(main())
