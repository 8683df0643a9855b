"""Counts of one region of `sunder-counts`: instructions and simulated cache misses by callgrind, blocks and bytes natively.

A count depends on the program, the compiler and the libraries; not on the machine, its load, the environment's size or
address randomisation. For that, valgrind places everything itself, the environment is emptied, the simulated caches
are fixed, and whatever picks code by the processor at hand is told which one: OpenBLAS its kernels, glibc its copies."""
import json
import re
import subprocess
from pathlib import Path

# A cache like those of today's small cores; what matters is that it never changes.
CACHES = ("--I1=32768,8,64", "--D1=32768,8,64", "--LL=8388608,16,64")
ENVIRONMENT = {
    "LC_ALL": "C",
    "PATH": "/usr/bin:/bin",
    "OPENBLAS_CORETYPE": "Haswell",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "GLIBC_TUNABLES": "glibc.cpu.x86_data_cache_size=32768:glibc.cpu.x86_shared_cache_size=1048576:"
                      "glibc.cpu.x86_non_temporal_threshold=786432:glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-ERMS,-FSRM",
}
KINDS = ("instructions", "d1_misses", "ll_misses", "allocations", "peak_bytes")


class CountError(RuntimeError):
    """A region that did not run, or whose answer was wrong."""


def events_of(text):
    """Totals of a callgrind output file by event name."""
    names = re.search(r"^events: (.*)$", text, re.M)
    totals = re.findall(r"^(?:totals|summary): (.*)$", text, re.M)
    if not names or not totals:
        raise CountError("callgrind wrote no totals")
    values = [int(value) for value in totals[-1].split()]
    return dict(zip(names.group(1).split(), values + [0] * 9))


def run(command, folder, environment):
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode != 0:
        raise CountError(f"{' '.join(map(str, command[-3:]))}: status {done.returncode}: {done.stderr.strip()[-300:]}")
    return json.loads(done.stdout.strip().splitlines()[-1])


def instructions(programs, region, size=None, extra=0, padding=0):
    """Instructions and misses of a region. `extra`: instructions wasted inside; `padding`: bytes more of environment."""
    arguments = [region, *([str(size if size is not None else 0)] if size is not None or extra else []),
                 *([str(extra)] if extra else [])]
    if extra and size is None:
        raise CountError("extra instructions need a size")
    environment = ENVIRONMENT | ({"PADDING": "x" * padding} if padding else {})
    # The output goes to a descriptor that is the same in every run: a name would change the length of the command.
    command = ["valgrind", "--tool=callgrind", "--instr-atstart=no", "--cache-sim=yes", *CACHES,
               "--callgrind-out-file=counts.%p.out", "./sunder-counts", *arguments]
    process = subprocess.Popen(command, cwd=programs, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               text=True)
    out, err = process.communicate()
    written = Path(programs) / f"counts.{process.pid}.out"
    try:
        if process.returncode != 0:
            raise CountError(f"{region}: status {process.returncode}: {err.strip()[-300:]}")
        events = events_of(written.read_text())
    finally:
        written.unlink(missing_ok=True)
    return {"instructions": events["Ir"], "d1_misses": events["D1mr"] + events["D1mw"],
            "ll_misses": events["DLmr"] + events["DLmw"] + events["ILmr"]}


def memory(programs, region, size=None):
    """Blocks asked for inside the region, and bytes held at once beyond those at its start; no valgrind."""
    library = next(Path(programs).parent.rglob("libsunder_heap_counter.so"), None)
    if library is None:
        raise CountError("libsunder_heap_counter.so is not built")
    told = run(["./sunder-counts", region, *([str(size)] if size is not None else [])], programs,
               ENVIRONMENT | {"LD_PRELOAD": str(library.absolute())})
    return {"allocations": told["allocations"], "peak_bytes": told["peak_bytes"]}


def regions(programs):
    """{name: (size, meaning)} as the program lists them."""
    done = subprocess.run(["./sunder-counts", "--list"], cwd=programs, env=ENVIRONMENT, capture_output=True, text=True)
    if done.returncode != 0:
        raise CountError(f"sunder-counts --list: {done.stderr.strip()}")
    rows = [line.split("\t") for line in done.stdout.splitlines()]
    return {name: (int(size), meaning) for name, size, meaning in rows}


def whole(programs, region):
    return instructions(programs, region) | memory(programs, region)


def surroundings():
    """What a count depends on beside the sources: compiler and libraries."""
    names = {"g++": "g++-12", "libc": "libc6", "openblas": "libopenblas0-pthread", "cholmod": "libcholmod3",
             "fftw": "libfftw3-double3", "eigen": "libeigen3-dev", "gmsh": "libgmsh4.8", "valgrind": "valgrind"}
    found = {}
    for name, package in names.items():
        done = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True)
        found[name] = done.stdout.strip() or "unknown"
    return found
