"""What run times say: order statistics only, for run times are not normally distributed.

`median_interval` is the twin of verification/harness/statistics.cpp and is tested on the same numbers."""
import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Interval:
    """A median and the bounds that hold the true one with `confidence` (below the wanted one for few values)."""
    median: float
    low: float
    high: float
    confidence: float

    @property
    def half_width(self):
        return 0.5 * (self.high - self.low)

    def excludes_zero(self):
        return self.low > 0.0 or self.high < 0.0


def median_interval(sample, confidence=0.95):
    """The sample's median with its distribution-free interval x_(k) ... x_(n+1-k) [Conover 1999]."""
    x = sorted(sample)
    n = len(x)
    if n == 0:
        raise ValueError("median_interval: the sample is empty")
    median = x[n // 2] if n % 2 else 0.5 * (x[n // 2 - 1] + x[n // 2])
    term = below = 0.5 ** n  # P(B = 0), P(B <= k)
    k = 0
    while 2 * (k + 1) < n:
        term *= (n - k) / (k + 1)
        if 1.0 - 2.0 * (below + term) < confidence:
            break
        below += term
        k += 1
    return Interval(median, x[k], x[n - 1 - k], 1.0 - 2.0 * below)


def log_ratio(quadruple):
    """ln(B/A) of four times in the order A B B A: a steady drift of the machine cancels."""
    a1, b1, b2, a2 = quadruple
    if min(quadruple) <= 0.0:
        raise ValueError("log_ratio: a time is not positive")
    return math.log((b1 + b2) / (a1 + a2))


NOISY, SLOWER, FASTER, SAME = "machine too noisy", "slower", "faster", "no difference"
CONFIDENCE = 0.99
WIDEST_CONTROL = 0.02  # half-width of the control's interval: beyond, a step of 2 % would be invisible


def verdict(control, first, second, widest=WIDEST_CONTROL):
    """(word, interval) from three batches of ln(B/A): the control times A against itself, the other two time the change.

    A step counts where both batches exclude 0 on the same side with 99 %, and where it is larger than what the control
    shows for no change at all. A control that sees a step, or that is too wide to see one, ends the judgement."""
    nothing = median_interval(control, CONFIDENCE)
    both = median_interval(list(first) + list(second), CONFIDENCE)
    if nothing.excludes_zero() or nothing.half_width > widest or nothing.confidence < CONFIDENCE:
        return NOISY, both
    batches = [median_interval(batch, CONFIDENCE) for batch in (first, second)]
    if any(batch.confidence < CONFIDENCE for batch in batches):
        return NOISY, both
    beyond_control = abs(both.median) > max(abs(nothing.low), abs(nothing.high))
    if beyond_control and all(batch.low > 0.0 for batch in batches):
        return SLOWER, both
    if beyond_control and all(batch.high < 0.0 for batch in batches):
        return FASTER, both
    return SAME, both


def exponent(sizes, counts):
    """The least-squares slope of ln(count) over ln(size)."""
    if len(sizes) != len(counts) or len(sizes) < 3:
        raise ValueError("exponent: three sizes with a count each are needed")
    x, y = [math.log(size) for size in sizes], [math.log(count) for count in counts]
    x_mean, y_mean = sum(x) / len(x), sum(y) / len(y)
    return (sum((a - x_mean) * (b - y_mean) for a, b in zip(x, y)) / sum((a - x_mean) ** 2 for a in x))
