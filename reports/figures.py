"""The figures, as SVG that goes into the page: same records, same bytes.

Colours are those of the page's style sheet (`var(--…)`), so that a figure follows light and dark; text stays text and takes
the page's font. Series differ in marker and colour, the palette is that of [Okabe & Ito 2008].
"""
from __future__ import annotations

import io
import math
import re
from dataclasses import dataclass

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter, NullLocator  # noqa: E402

from reports import words  # noqa: E402
from reports.front import Point, dominance_front  # noqa: E402

INK, SOFT, RULE, PAPER = "#1b1f24", "#5b6470", "#d5d9de", "#fefefe"
SERIES = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7a7a1f", "#8c564b")
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "<")
BAD = "#c0392b"
VARIABLES = {INK: "ink", SOFT: "soft", RULE: "rule", PAPER: "paper", BAD: "bad",
             **{colour: f"s{i + 1}" for i, colour in enumerate(SERIES)}}

STYLE = {
    "svg.hashsalt": "sunder", "svg.fonttype": "none", "font.family": "DejaVu Sans", "font.size": 8.5,
    "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": SOFT, "xtick.color": SOFT, "ytick.color": SOFT,
    "xtick.labelcolor": INK, "ytick.labelcolor": INK, "axes.linewidth": 0.6, "axes.spines.top": False, "axes.spines.right": False,
    "axes.grid": True, "grid.color": RULE, "grid.linewidth": 0.5, "axes.axisbelow": True, "lines.linewidth": 1.3,
    "lines.markersize": 4.2, "legend.frameon": False, "legend.fontsize": 8, "figure.facecolor": "none", "axes.facecolor": "none",
    "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.major.size": 3, "ytick.major.size": 3,
}
SIZE = (4.8, 3.5)  # inches of 72 units: readable at the width of a phone


@dataclass(frozen=True)
class Figure:
    key: str       # unique in the page
    svg: str       # an <svg> element
    caption: str   # what is seen, in a sentence


class FigureError(RuntimeError):
    """A figure that would show nothing."""


def element(figure, key, caption):
    """The figure as an <svg> element for the page: no metadata, own ids, colours of the style sheet."""
    text = io.StringIO()
    figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    plt.close(figure)
    svg = text.getvalue()
    svg = svg[svg.index("<svg"):]
    svg = re.sub(r"<metadata>.*?</metadata>\s*", "", svg, flags=re.S)
    svg = re.sub(r"<!--.*?-->\s*", "", svg, flags=re.S)
    svg = re.sub(r'<svg [^>]*?(viewBox="[^"]*")[^>]*>', rf'<svg \1 class="figure" role="img" aria-label="{_attribute(caption)}">', svg, 1)
    svg = re.sub(r'\bid="([^"]+)"', rf'id="{key}-\1"', svg)
    svg = re.sub(r'(url\(|href=")#', rf"\1#{key}-", svg).replace("xlink:href", "href")
    svg = re.sub(r"font: ([0-9.]+)px [^;\"]*", r"font-size: \1px", svg)
    for colour, name in VARIABLES.items():
        svg = svg.replace(colour, f"var(--{name})")
    left = re.search(r"#[0-9a-f]{6}\b", svg)
    if left:
        raise FigureError(f"{key}: colour {left.group()} is not in the palette of the page")
    return svg


def standalone(figure):
    """The figure as a file of its own, on white, with the light colours."""
    svg = figure.svg
    for colour, name in VARIABLES.items():
        svg = svg.replace(f"var(--{name})", colour)
    view = re.search(r'viewBox="0 0 ([0-9.]+) ([0-9.]+)"', svg)
    width, height = (float(v) for v in view.groups())
    svg = svg.replace('class="figure"', f'xmlns="http://www.w3.org/2000/svg" width="{2 * width:g}" height="{2 * height:g}" '
                      'font-family="Inter, Helvetica, Arial, DejaVu Sans, sans-serif"', 1)
    cut = svg.index(">") + 1
    return f'<?xml version="1.0" encoding="utf-8"?>\n{svg[:cut]}\n<rect width="100%" height="100%" fill="#ffffff"/>{svg[cut:]}'


def _attribute(text):
    return text.replace("&", "&amp;").replace('"', "&quot;").replace("<", "&lt;")


def _powers(axis):
    axis.set_major_locator(LogLocator(numticks=9))
    axis.set_major_formatter(FuncFormatter(lambda v, _: words.power_of_ten(round(math.log10(v)))))
    axis.set_minor_locator(NullLocator())


def _durations(axis):
    low, high = axis.get_view_interval()
    axis.set_major_locator(LogLocator(subs=(1.0,) if high / low > 30 else (1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda v, _: words.seconds(v, 1)))
    axis.set_minor_formatter(NullFormatter())
    axis.set_minor_locator(NullLocator())


def _pen(i):
    """Colour and marker of curve i; the pairs repeat after 64."""
    return {"color": SERIES[i % len(SERIES)], "marker": MARKERS[(i + i // len(SERIES)) % len(MARKERS)]}


def new_axes(x, y, size=SIZE):
    figure, axes = plt.subplots(figsize=size, layout="constrained")
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    return figure, axes


def legend(axes, columns):
    """Below the axis title, outside the axes: matplotlib 3.6 makes room for it in a constrained layout."""
    axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.15), ncols=columns, handlelength=1.6, columnspacing=1.4,
                borderaxespad=0.2)


def error_against_time(key, points, failed, quantity, floor=1e-16):
    """Every setting's error over its CPU time, the dominance front, the default ringed, failed settings at the top. The line
    of a series joins those of its settings that no other of the series beats."""
    if not points:
        raise FigureError(f"{key}: no setting has an error and a time")
    shown = [Point(p.seconds, max(p.error, floor), p.series, p.label, p.standard) for p in points]
    with plt.rc_context(STYLE):
        figure, axes = new_axes("CPU time", f"error of {quantity}", (SIZE[0], SIZE[1] + 0.35))
        axes.set_xscale("log")
        axes.set_yscale("log")
        names = list(dict.fromkeys(p.series for p in shown))
        front = dominance_front(shown)
        axes.step([p.seconds for p in front], [p.error for p in front], where="post", color=SOFT, linewidth=4.5, alpha=0.22,
                  solid_capstyle="round", label="front", zorder=1)
        for i, name in enumerate(names):
            own = [p for p in shown if p.series == name]
            line, pen = dominance_front(own), _pen(i)
            axes.plot([p.seconds for p in own], [p.error for p in own], linestyle="none", **pen, zorder=3)
            axes.plot([p.seconds for p in line], [p.error for p in line], **pen, label=name or "settings", zorder=3)
        for p in shown:
            if p.standard:
                axes.plot(p.seconds, p.error, "o", markersize=10, markerfacecolor="none", markeredgecolor=INK, markeredgewidth=1.1,
                          linestyle="none", label="default", zorder=4)
        if failed:
            top = max(p.error for p in shown) * 3
            axes.plot(failed, [top] * len(failed), "x", color=BAD, markersize=5.5, markeredgewidth=1.4, label="no answer", zorder=4)
        _powers(axes.yaxis)
        _durations(axes.xaxis)
        legend(axes, 3 if max(map(len, names)) < 26 else 2)
        caption = f"Error of {quantity} against CPU time, {words.count(len(points), 'setting')}"
        return Figure(key, element(figure, key, caption), caption)


def peers(key, programs, quantity, caption):
    """Fronts of several programs on one problem; `programs`: name -> (front, all points)."""
    if not programs or not all(front for front, _ in programs.values()):
        raise FigureError(f"{key}: a program without a point")
    with plt.rc_context(STYLE):
        figure, axes = new_axes("CPU time, mesh and solution", f"error of {quantity}", (SIZE[0], SIZE[1] + 0.35))
        axes.set_xscale("log")
        axes.set_yscale("log")
        for i, (name, (front, points)) in enumerate(programs.items()):
            pen = _pen(i)
            axes.plot([p.seconds for p in points], [p.error for p in points], linestyle="none", alpha=0.3, zorder=2, **pen)
            axes.plot([p.seconds for p in front], [p.error for p in front], label=name, zorder=3, **pen)
        _powers(axes.yaxis)
        _durations(axes.xaxis)
        legend(axes, 3)
        return Figure(key, element(figure, key, caption), caption)


@dataclass(frozen=True)
class Rung:
    label: str
    error: float     # nan where there is no answer
    tolerance: float  # 0 where none is written
    outcome: str     # right, declined, wrong
    series: str = ""


def ladder(key, rungs, quantity, axis_label):
    """The error of every rung under its tolerance, from the lowest up; declined rungs hollow on the tolerance's line, wrong
    ones crossed. The curves of a ladder stand side by side."""
    if not any(r.error >= 0 for r in rungs):
        raise FigureError(f"{key}: no rung has an error")
    floor = 1e-17
    with plt.rc_context(STYLE):
        figure, axes = new_axes(axis_label, f"error of {quantity}", (SIZE[0], 2.7))
        axes.set_yscale("log")
        places = range(len(rungs))
        limits = [r.tolerance if r.tolerance > 0 else math.nan for r in rungs]
        if any(r.tolerance > 0 for r in rungs):
            axes.step([-0.5, *(i + 0.5 for i in places)], [limits[0], *limits], where="pre", color=SERIES[1], linewidth=1.1,
                      label="tolerance")
        for i, name in enumerate(dict.fromkeys(r.series for r in rungs)):
            own = [(x, r) for x, r in zip(places, rungs) if r.series == name]
            axes.plot([x for x, _ in own], [max(r.error, floor) for _, r in own], "-", color=SERIES[0], linewidth=0.9)
        right = [(x, max(r.error, floor)) for x, r in zip(places, rungs) if r.outcome == "right" and r.error >= 0]
        axes.plot([x for x, _ in right], [y for _, y in right], "o", color=SERIES[0], markersize=3.6, label="right")
        present = [r.tolerance if r.tolerance > 0 else r.error for r in rungs if r.tolerance > 0 or r.error > 0]
        base = max(present, default=1.0)
        for outcome, look, label in (("declined", {"marker": "s", "markerfacecolor": PAPER, "markeredgecolor": SOFT}, "refused by name"),
                                     ("wrong", {"marker": "X", "color": BAD, "markersize": 6.5}, "wrong")):
            some = [(x, r) for x, r in zip(places, rungs) if r.outcome == outcome]
            if some:
                heights = [max(r.error, floor) if r.error >= 0 else r.tolerance if r.tolerance > 0 else base for _, r in some]
                axes.plot([x for x, _ in some], heights, linestyle="none", label=label, zorder=4, **look)
        axes.set_xlim(-0.5, len(rungs) - 0.5)
        step = max(1, math.ceil(len(rungs) * max(4, max(len(r.label) for r in rungs)) / 52))
        axes.set_xticks(list(places)[::step], [r.label for r in rungs][::step])
        _powers(axes.yaxis)
        axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.2), ncols=4, handlelength=1.4, columnspacing=1.4, borderaxespad=0.2)
        caption = f"Error of {quantity} over the {words.count(len(rungs), 'rung')} of the ladder, with the tolerance of each"
        return Figure(key, element(figure, key, caption), caption)


def convergence(key, series, quantity, size_label):
    """Error over size h, log-log, with the slope between the two finest levels; `series`: name -> [(h, error)]."""
    if not series or not all(len(line) > 1 for line in series.values()):
        raise FigureError(f"{key}: fewer than two levels with an error")
    with plt.rc_context(STYLE):
        figure, axes = new_axes(size_label, f"error of {quantity}", (SIZE[0], SIZE[1] - 0.3))
        axes.set_xscale("log")
        axes.set_yscale("log")
        for i, (name, line) in enumerate(series.items()):
            line = sorted(line)
            sizes, errors = [h for h, _ in line], [max(e, 1e-17) for _, e in line]
            slope = math.log(errors[1] / errors[0]) / math.log(sizes[1] / sizes[0])
            label = f"{name}: " if name else ""
            axes.plot(sizes, errors, **_pen(i), label=f"{label}slope {words.number(slope, 3)} at the fine end")
        sizes = sorted({h for line in series.values() for h, _ in line})
        step = max(1, math.ceil(len(sizes) / 6))
        axes.set_xticks(sizes[::step], [words.written(repr(h)) for h in sizes[::step]])
        axes.xaxis.set_minor_locator(NullLocator())
        _powers(axes.yaxis)
        legend(axes, 2 if len(series) > 1 else 1)
        caption = f"Error of {quantity} over {size_label}"
        return Figure(key, element(figure, key, caption), caption)


def pressure_along_crack(key, curves, caption):
    """Pressures in MPa over the distance from the upstream mouth, all of them above, the low ones by themselves below;
    `curves`: with name, positions, pressures."""
    if not curves or not all(max(c.pressures) > 0 for c in curves):
        raise FigureError(f"{key}: a curve without pressure")
    ordered = sorted((max(c.pressures) for c in curves), reverse=True)
    with plt.rc_context(STYLE):
        figure, (whole, low) = plt.subplots(2, 1, figsize=(SIZE[0], SIZE[1] + 1.2), layout="constrained", sharex=True)
        for axes, limit in ((whole, ordered[0]), (low, next((p for p in ordered if p < 0.5 * ordered[0]), ordered[0]))):
            for i, c in enumerate(curves):
                if max(c.pressures) > limit:
                    continue
                axes.plot(c.positions, c.pressures, color=SERIES[i], linestyle=("-", "--", "-.", ":")[i % 4], linewidth=1.8, label=c.name)
            axes.set_ylim(0, 1.08 * limit)
            axes.set_xlim(0, curves[0].positions[-1])
            axes.set_ylabel("pressure, MPa")
        low.set_xlabel("distance from the upstream mouth, m")
        low.legend(*whole.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.45, -0.25), ncols=3, handlelength=2.4, columnspacing=1.4, borderaxespad=0.2)
        return Figure(key, element(figure, key, caption), caption)


def cost(key, series, x_label, y_label, caption):
    """Time over size, log-log; `series`: name -> [(size, seconds)]."""
    if not series or not all(series.values()):
        raise FigureError(f"{key}: no measurement")
    with plt.rc_context(STYLE):
        figure, axes = new_axes(x_label, y_label, (SIZE[0], SIZE[1] + 0.1))
        axes.set_xscale("log")
        axes.set_yscale("log")
        sizes = sorted({x for line in series.values() for x, _ in line})
        for i, (name, line) in enumerate(series.items()):
            axes.plot([x for x, _ in sorted(line)], [y for _, y in sorted(line)], **_pen(i), label=name)
        axes.set_xticks(sizes, [f"{x:g}" for x in sizes])
        axes.xaxis.set_minor_locator(NullLocator())
        _durations(axes.yaxis)
        legend(axes, 3)
        return Figure(key, element(figure, key, caption), caption)
