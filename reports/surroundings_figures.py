"""The figures of reservoir, foundation, convolution and linear shaking. Curves differ in colour and dashes, points in marker."""
import math

import matplotlib.pyplot as plt

from reports import words
from reports.figures import INK, SERIES, SIZE, SOFT, STYLE, Figure, FigureError, element, _durations, _pen, _powers

DASHES = ("-", "--", "-.", ":")
FLOOR = 1e-12  # below the last digit of the references


def _panels(rows, height, ratios=None):
    return plt.subplots(rows, 1, figsize=(SIZE[0], height), layout="constrained", sharex=True, gridspec_kw={"height_ratios": ratios})


def _below(axes, drop, columns, handles=None):
    drawn, names = handles or axes.get_legend_handles_labels()
    axes.legend(drawn, names, loc="upper center", bbox_to_anchor=(0.45, drop), ncols=columns, handlelength=2.2, columnspacing=1.3, borderaxespad=0.2)


def _done(figure, key, caption):
    return Figure(key, element(figure, key, caption), caption)


def _finite(key, *curves):
    if not curves or not all(len(c) > 0 and all(math.isfinite(v) for v in c) for c in curves):
        raise FigureError(f"{key}: a curve is empty or not finite")


def force_spectrum(key, ratios, curves, caption, top=2.5):
    """|F| / (ρ a H²) over ω/ω1 above; below what the face and the formula are off by, each with the bar of its case.

    `curves`: of one bottom each, with name, series, face (complex forces at `ratios`), points [(ratio, complex)] of the
    reference, series_bar and face_bar, what real or imaginary part may be off by.
    """
    _finite(key, ratios, *([abs(f) for f in c.series] for c in curves), *([abs(f) for f in c.face] for c in curves))
    off = lambda a, b: max(abs((a - b).real), abs((a - b).imag), FLOOR)
    with plt.rc_context(STYLE):
        figure, (force, error) = _panels(2, SIZE[1] + 1.9, (3, 2))
        for i, c in enumerate(curves):
            at, colour = dict(zip(ratios, zip(c.series, c.face))), SERIES[i]
            force.plot(ratios, [abs(f) for f in c.series], DASHES[i], color=colour, label=f"{c.name}, formula")
            some = range(6 + 4 * i, len(ratios), 12)
            force.plot([ratios[j] for j in some], [abs(c.face[j]) for j in some], ("o", "s")[i % 2], markersize=4, markerfacecolor="none",
                       color=colour, label=f"{c.name}, elements")
            force.plot([r for r, _ in c.points], [abs(f) for _, f in c.points], "x", color=INK, markersize=5, zorder=4,
                       label="independent computation" if i == 0 else None)
            error.plot(ratios, [off(a, b) for a, b in zip(c.series, c.face)], DASHES[i], color=colour, linewidth=1)
            error.plot([r for r, _ in c.points], [off(at[r][0], f) for r, f in c.points], ("P", "X")[i % 2], color=colour, markersize=4.5)
            for r, _ in c.points:
                for bar in (c.series_bar, c.face_bar):
                    error.plot([r - 0.09, r + 0.09], [bar, bar], "-", color=INK, linewidth=1.8, solid_capstyle="butt",
                               label="bar of the case" if i == 0 and r == c.points[0][0] and bar == c.series_bar else None)
        force.set_ylim(0, top)
        force.set_ylabel("|F| / (ρ a H²)")
        error.set_yscale("log")
        _powers(error.yaxis)
        error.set_ylabel("off by / (ρ a H²)")
        error.set_xlabel("ω / ω₁")
        error.set_xlim(0, 4)
        drawn, names = (a + b for a, b in zip(force.get_legend_handles_labels(), error.get_legend_handles_labels()))
        _below(error, -0.33, 2, (drawn, names))
        return _done(figure, key, caption)


def impulse_response(key, curves, caption):
    """Force after an impulse of acceleration over c t / H; `curves`: with name, exact and face [(time, force)], points."""
    _finite(key, *([v for _, v in line] for c in curves for line in (c.exact, c.face)))
    with plt.rc_context(STYLE):
        figure, panels = _panels(len(curves), SIZE[1] + 1.3)
        latest = max(t for t, _ in curves[0].face)
        for i, (axes, c) in enumerate(zip(panels, curves)):
            axes.axhline(0, color=SOFT, linewidth=0.6)
            axes.plot(*zip(*c.exact), "-", color=SERIES[5], linewidth=4, alpha=0.55, solid_capstyle="butt", label="formula")
            axes.plot(*zip(*c.face), "-", color=SERIES[0], linewidth=1.1, label="elements")
            axes.plot(*zip(*((t, v) for t, v in c.points if t <= latest)), "D", color=SERIES[1], markersize=4.5, label="independent computation",
                      zorder=4, clip_on=False)
            axes.set_ylabel("force / (ρ c H)")
            axes.set_title(c.name, fontsize=8.5, loc="left")
        panels[-1].set_xlim(0, latest)
        panels[-1].set_xlabel("time after the impulse, c t / H")
        _below(panels[-1], -0.3, 3)
        return _done(figure, key, caption)


def impedance(key, frequencies, curves, caption):
    """Real parts above, imaginary parts below, over a0; `curves`: with name, values (complex) and points [(a0, complex)]."""
    _finite(key, frequencies, *([abs(v) for v in c.values] for c in curves))
    with plt.rc_context(STYLE):
        figure, panels = _panels(2, SIZE[1] + 1.6)
        for axes, part, name in ((panels[0], "real", "real part / G"), (panels[1], "imag", "imaginary part / G")):
            for i, c in enumerate(curves):
                axes.plot(frequencies, [getattr(v, part) for v in c.values], DASHES[i], color=SERIES[i], label=c.name)
                inside = [(a, v) for a, v in c.points if a <= frequencies[-1]]
                axes.plot([a for a, _ in inside], [getattr(v, part) for _, v in inside], ("o", "s", "^")[i], color=SERIES[i], markersize=5, clip_on=False,
                          label=f"{c.name[0]}, independent")
            axes.set_ylim(0, 1.08 * max(getattr(v, part) for c in curves for v in (*c.values, *(v for a, v in c.points if a <= frequencies[-1]))))
            axes.set_ylabel(name)
        panels[1].set_xlim(0, frequencies[-1])
        panels[1].set_xlabel("a₀, frequency × half-width / speed of shear waves")
        _below(panels[1], -0.25, 2)
        return _done(figure, key, caption)


def convolution(key, series, plain, caption):
    """Error of the force over the CPU time of a step, set-up shared out; `series`: name -> [(steps, seconds of the run, error,
    stated error or 0)], `plain`: [(steps, seconds)] of the plain sum, which errors are measured against; it stands at the bottom."""
    if not series or not plain or not all(series.values()):
        raise FigureError(f"{key}: no measurement")
    floor = 1e-17
    lines = {name: [(n, s / n, max(error, floor), stated) for n, s, error, stated in line] for name, line in series.items()}
    lines["plain sum, the measure"] = [(n, s / n, floor, 0.0) for n, s in plain]
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(SIZE[0], SIZE[1] + 0.4), layout="constrained")
        axes.set(xscale="log", yscale="log", xlabel="CPU time of a step, with its share of the set-up", ylabel="error of the force")
        for i, (name, line) in enumerate(lines.items()):
            axes.plot([p[1] for p in line], [p[2] for p in line], **_pen(i), label=name)
            for n, s, error, stated in line:
                power = round(math.log10(n))
                axes.annotate(words.power_of_ten(power) if 10**power == n else f"{n:g}", (s, error), (0, (7, -13)[i % 2]), textcoords="offset points",
                              ha="center", fontsize=7.5, color=SERIES[i])
                if stated > 0:
                    axes.plot([s], [stated], "_", color=INK, markersize=9, markeredgewidth=1.4)
        if any(p[3] > 0 for line in lines.values() for p in line):
            axes.plot([], [], "_", color=INK, markersize=9, markeredgewidth=1.4, label="error that it states")
        axes.margins(0.09)
        _powers(axes.yaxis)
        _durations(axes.xaxis)
        _below(axes, -0.15, 2)
        return _done(figure, key, caption)


def crest_histories(key, curves, caption):
    """Horizontal displacement of the crest in mm, one panel a dam; `curves`: with name, times, displacements and range, the
    extremes of an independent program or ()."""
    _finite(key, *(c.displacements for c in curves))
    largest = 1.1 * max(abs(u) for c in curves for u in c.displacements)
    with plt.rc_context(STYLE):
        figure, panels = _panels(len(curves), 1.15 * len(curves) + 0.9)
        for i, (axes, c) in enumerate(zip(panels, curves)):
            axes.plot(c.times, c.displacements, "-", color=SERIES[i], linewidth=0.9)
            for extreme in c.range:
                axes.axhline(extreme, color=INK, linewidth=0.9, linestyle=(0, (4, 3)), label="extremes of an independent program" if extreme == c.range[0] else None)
            axes.set_title(c.name, fontsize=8.5, loc="left")
            axes.set_ylim(-largest, largest)
        panels[-1].set_xlim(0, curves[0].times[-1])
        panels[-1].set_xlabel("time, s")
        figure.supylabel("crest displacement, mm", fontsize=8.5)
        handles = next((h for h in (a.get_legend_handles_labels() for a in panels) if h[0]), None)
        if handles:
            _below(panels[-1], -0.52, 1, handles)
        return _done(figure, key, caption)


def energy_account(key, times, parts, ground, came_in, caption):
    """What became of the energy, stacked, under the line of what came in, of which `ground` is a share; `parts`: name ->
    values in MJ/m."""
    _finite(key, times, ground, came_in, *parts.values())
    largest = max(abs(v) for v in came_in)
    if not largest > 0:
        raise FigureError(f"{key}: no energy came in")
    for t, whole, *shares in zip(times, came_in, *parts.values()):
        if not abs(sum(shares) - whole) <= 1e-6 * largest:
            raise FigureError(f"{key}: at {t:g} s the parts are {sum(shares):.9g} and not {whole:.9g}")
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(SIZE[0], SIZE[1] + 0.3), layout="constrained")
        axes.set(xlabel="time, s", ylabel="energy, MJ/m")
        base = [0.0] * len(times)
        for i, (name, values) in enumerate(parts.items()):
            top = [b + v for b, v in zip(base, values)]
            axes.fill_between(times, base, top, facecolor=SERIES[i], edgecolor=SERIES[i], alpha=0.55, linewidth=0.6, label=name)
            base = top
        axes.plot(times, came_in, "--", color=INK, linewidth=1.1, label="from ground and water")
        axes.plot(times, ground, ":", color=SERIES[3], linewidth=1.3, label="from the ground alone")
        axes.set_xlim(times[0], times[-1])
        _below(axes, -0.16, 2)
        return _done(figure, key, caption)
