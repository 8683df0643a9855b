"""Limits of counts: reading, judging, writing benchmarks/counts/limits.toml."""
import re
import tomllib
from dataclasses import dataclass

from benchmarks.costs import statistics
from benchmarks.costs.counting import KINDS


class LimitError(ValueError):
    """The file of limits cannot be used."""


@dataclass(frozen=True)
class Excess:
    region: str
    kind: str
    limit: float
    found: float

    def __str__(self):
        return (f"{self.region}: {self.kind}: limit {self.limit:.0f}, found {self.found:.0f} "
                f"({100.0 * (self.found / self.limit - 1.0) if self.limit else float('inf'):+.2f} %)")


def read(path):
    with open(path, "rb") as file:
        limits = tomllib.load(file)
    for table in limits.get("region", []):
        lacking = [key for key in ("name", "reason", *KINDS) if key not in table]
        if lacking:
            raise LimitError(f"{path}: region {table.get('name', '?')}: {', '.join(lacking)} is missing")
    for table in limits.get("exponent", []):
        lacking = [key for key in ("region", "sizes", "at_least", "at_most", "reason") if key not in table]
        if lacking:
            raise LimitError(f"{path}: exponent {table.get('region', '?')}: {', '.join(lacking)} is missing")
    lacking = [kind for kind in KINDS if kind not in limits.get("slack", {})]
    if lacking or not limits["slack"].get("reason"):
        raise LimitError(f"{path}: [slack] needs a number for each of {', '.join(KINDS)}, and a reason")
    return limits


def excesses(limits, region, found):
    """What of the counts `found` lies beyond `region`'s limit, that is its recorded count and the slack of its kind."""
    table = next((table for table in limits["region"] if table["name"] == region), None)
    if table is None:
        raise LimitError(f"region {region} has no limit")
    beyond = []
    for kind in KINDS:
        limit = table[kind] * (1.0 + limits["slack"][kind])
        if found[kind] > limit:
            beyond.append(Excess(region, kind, limit, found[kind]))
    return beyond


def loose(limits, region, found, share=0.01):
    """Kinds whose count lies so far below the limit that a slow-down of `share` would pass unseen."""
    table = next(table for table in limits["region"] if table["name"] == region)
    return [kind for kind in KINDS[:1] if found[kind] * (1.0 + share) <= table[kind] * (1.0 + limits["slack"][kind])]


def exponent_fault(table, counts):
    """(exponent, complaint or None) of one [[exponent]] table with the counts at its sizes."""
    slope = statistics.exponent(table["sizes"], counts)
    if table["at_least"] <= slope <= table["at_most"]:
        return slope, None
    return slope, (f"{table['region']}: exponent {slope:.3f} over sizes {table['sizes']}, "
                   f"accepted {table['at_least']} ... {table['at_most']}")


def with_counts(text, counts):
    """The file's text with other counts; comments, slacks and reasons stay. `counts`: {region: {kind: count}}."""
    lines, region = [], None
    for line in text.splitlines():
        stripped = line.strip()
        if stripped.startswith("["):
            region = None
        elif stripped.startswith("name ="):
            region = stripped.split('"')[1]
        key = stripped.split(" =")[0]
        if region in counts and key in counts[region]:
            line = f"{key} = {counts[region][key]}"
        lines.append(line)
    return "\n".join(lines) + "\n"


def with_version(text, name, version):
    """The file's text with another version of `name` in [surroundings]."""
    return re.sub(rf'^"?{re.escape(name)}"? = ".*"$', f'"{name}" = "{version}"', text, flags=re.M)
