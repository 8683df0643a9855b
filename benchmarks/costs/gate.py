"""ci/counts: the gate of counts and exponents. Exit status: 0 within the limits, 1 beyond one, 2 unusable, 77 not to be
compared (other compiler or libraries than the limits were counted with)."""
import argparse
import random
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from benchmarks.costs import counting, limits

LIMITS = Path(__file__).resolve().parents[1] / "counts" / "limits.toml"
NOT_COMPARABLE = 77


def count_all(programs, names, jobs):
    with ThreadPoolExecutor(jobs) as pool:
        return dict(zip(names, pool.map(lambda name: counting.whole(programs, name), names)))


def other_surroundings(recorded):
    here = counting.surroundings()
    return [f"{name} {here.get(name, 'unknown')} instead of {version}" for name, version in recorded.items()
            if here.get(name) != version]


def check(arguments, known):
    """Counts every region, or the named ones, against its limit."""
    listed = counting.regions(arguments.programs)
    names = arguments.region or [table["name"] for table in known["region"]]
    unlimited = sorted(set(listed) - {table["name"] for table in known["region"]})
    if unlimited and not arguments.region:
        print(f"without a limit: {', '.join(unlimited)}", file=sys.stderr)
        return 2
    beyond = []
    for name, found in count_all(arguments.programs, names, arguments.jobs).items():
        excesses = limits.excesses(known, name, found)
        beyond += excesses
        note = "" if not limits.loose(known, name, found) else "  (limit loose: ci/counts --update tightens it)"
        print(f"{name:20} {found['instructions']:>12,} instructions  {found['d1_misses']:>9,} D1  {found['ll_misses']:>7,} LL  "
              f"{found['allocations']:>6,} blocks  {found['peak_bytes']:>11,} bytes"
              f"{'  BEYOND' if excesses else ''}{note}")
    for excess in beyond:
        print(f"beyond its limit: {excess}", file=sys.stderr)
    return 1 if beyond else 0


def update(arguments, known):
    """Writes the present counts into the limits' file; the reason of each region is for people to revise."""
    names = arguments.region or sorted(counting.regions(arguments.programs))
    text = LIMITS.read_text()
    there = {table["name"] for table in known["region"]}
    lacking = [name for name in names if name not in there]
    if lacking:
        print(f"add [[region]] with a reason for: {', '.join(lacking)}", file=sys.stderr)
        return 2
    counts = count_all(arguments.programs, names, arguments.jobs)
    text = limits.with_counts(text, counts)
    for name, version in counting.surroundings().items():
        text = limits.with_version(text, name, version)
    LIMITS.write_text(text)
    print(f"written: {len(counts)} regions")
    return 0


def exponents(arguments, known):
    """The growth of counts with size."""
    failed = False
    for table in known["exponent"]:
        with ThreadPoolExecutor(arguments.jobs) as pool:
            counts = list(pool.map(
                lambda size: counting.instructions(arguments.programs, table["region"], size)["instructions"],
                table["sizes"]))
        slope, complaint = limits.exponent_fault(table, counts)
        print(f"{table['region']:20} exponent {slope:5.3f} in {table['at_least']} ... {table['at_most']}   "
              f"sizes {table['sizes']}  instructions {counts}")
        if complaint:
            failed = True
            print(f"wrong growth: {complaint}", file=sys.stderr)
    return 1 if failed else 0


def alike(arguments, known):
    """Repeats one region, each time with another size of environment: all counts must be the same to the last digit, and
    no run may raise an alarm."""
    name = (arguments.region or ["water-solve"])[0]
    paddings = [random.Random(7 + i).randrange(4096) for i in range(arguments.alike)]
    with ThreadPoolExecutor(arguments.jobs) as pool:
        counts = list(pool.map(lambda padding: counting.instructions(arguments.programs, name, padding=padding), paddings))
    different = {tuple(found.items()) for found in counts}
    memory = counting.memory(arguments.programs, name)
    alarms = sum(1 for found in counts if limits.excesses(known, name, found | memory))
    print(f"{name}: {len(counts)} runs, {len(different)} different counts, {alarms} alarms: {dict(next(iter(different)))}")
    return 0 if len(different) == 1 and alarms == 0 else 1


def self_test(arguments, known):
    """Would the gate see a slow-down of 1 %, and does it keep still without one? With every region that is short enough to
    be counted three times here: as it is, with another size of environment, and with 1 % of its instructions wasted."""
    failed = False
    sizes = counting.regions(arguments.programs)
    for name in arguments.region or ("water-solve", "contact-solve"):
        size = sizes[name][0]
        plain = counting.whole(arguments.programs, name)
        padded = counting.instructions(arguments.programs, name, size, padding=1111)
        slowed = counting.instructions(arguments.programs, name, size, extra=plain["instructions"] // 100)
        same = plain["instructions"] == padded["instructions"]  # the stack's place moves a few cache misses
        quiet = not limits.excesses(known, name, plain) and not limits.excesses(known, name, plain | padded)
        seen = [str(excess) for excess in limits.excesses(known, name, plain | slowed) if excess.kind == "instructions"]
        failed |= not (same and quiet and seen)
        print(f"{name}: {'the same count' if same else f'OTHER COUNTS: {plain} {padded}'} with another environment, "
              f"{'no alarm' if quiet else 'AN ALARM'} as it is, 1 % slower: {seen[0] if seen else 'UNSEEN'}")
    return 1 if failed else 0


def main(words=None):
    parser = argparse.ArgumentParser(prog="ci/counts", description=__doc__)
    parser.add_argument("--programs", type=Path, required=True, help="folder with sunder-counts")
    parser.add_argument("--region", action="append", help="only this one; may be repeated")
    parser.add_argument("--jobs", type=int, default=2)
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--update", action="store_true", help="write the present counts as limits")
    what.add_argument("--exponents", action="store_true", help="the growth of counts with size instead")
    what.add_argument("--alike", type=int, metavar="N", help="N runs of one region must give one count and no alarm")
    what.add_argument("--self-test", action="store_true", help="a slow-down of 1 % must be caught, none must not")
    arguments = parser.parse_args(words)
    try:
        known = limits.read(LIMITS)
        if arguments.update:
            return update(arguments, known)
        if arguments.exponents:
            return exponents(arguments, known)
        others = other_surroundings(known["surroundings"])
        if others:
            print(f"not compared: {'; '.join(others)}; ci/counts --update counts anew")
            return NOT_COMPARABLE
        if arguments.self_test:
            return self_test(arguments, known)
        return alike(arguments, known) if arguments.alike else check(arguments, known)
    except (counting.CountError, limits.LimitError, OSError) as error:
        print(f"ci/counts: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
