"""Error against run time: which settings no other setting beats, and what the default costs beside them."""
from __future__ import annotations

import math
from dataclasses import dataclass

LEVELS = ((1e-2, "1 %"), (1e-3, "0.1 %"), (1e-6, "10⁻⁶"))

# A default that needs more than this many times the best setting's time for its error is explained in its case.
ACCEPTED_FACTOR = 1.5


@dataclass(frozen=True)
class Point:
    seconds: float   # CPU seconds, > 0
    error: float     # >= 0
    series: str
    label: str       # the setting, in words
    standard: bool = False


def dominance_front(points):
    """The points that no other beats in both error and time, from the fastest to the most accurate.

    A point that only equals another in both is not on the front twice; the first one given stays.
    """
    front, best = [], math.inf
    for point in sorted(points, key=lambda p: (p.seconds, p.error)):
        if point.error < best:
            front.append(point)
            best = point.error
    return front


def time_to(points, error):
    """The fastest point whose error is at most `error`; None where there is none."""
    return min((p for p in points if p.error <= error), key=lambda p: p.seconds, default=None)


def default_factor(points, known=0.0):
    """CPU time of the default over that of the fastest setting with an error no larger; None without a default. The answer is
    known to `known`: errors below it are equally good."""
    default = next((p for p in points if p.standard), None)
    return default.seconds / time_to(points, max(default.error, known)).seconds if default else None
