"""Figures of the chapter "Koyna", in the look of all others."""
import matplotlib.pyplot as plt

from reports.figures import INK, SERIES, SIZE, SOFT, STYLE, Figure, FigureError, element

DASHES = ("-", "--", "-.", ":")
MARKS = ("o", "s", "^")


def _stack(count, heights, **more):
    figure, axes = plt.subplots(count, 1, figsize=(SIZE[0], sum(heights)), layout="constrained", height_ratios=heights, **more)
    return figure, list(axes)


def _below(axes, source, columns=2):
    axes.legend(*source.get_legend_handles_labels(), loc="upper center", bbox_to_anchor=(0.45, -0.3), ncols=columns, handlelength=2.2,
                columnspacing=1.4, borderaxespad=0.2)


def _require(key, lines):
    if not lines or not all(len(x) > 1 for x in lines):
        raise FigureError(f"{key}: a curve without points")


def ground_motion(key, components, caption):
    """Acceleration over time; `components`: (name, times [s], values [m/s²])."""
    _require(key, [t for _, t, _ in components])
    with plt.rc_context(STYLE):
        figure, panels = _stack(len(components), [1.55] * len(components), sharex=True, sharey=True)
        for axes, (name, times, values) in zip(panels, components):
            axes.plot(times, values, color=SERIES[0], linewidth=0.8)
            axes.set_ylabel(f"{name}, m/s²")
            axes.set_xlim(times[0], times[-1])
        panels[-1].set_xlabel("time, s")
        return Figure(key, element(figure, key, caption), caption)


def mouth_opening(key, curves, caption):
    """Opening of the mouth, all models above, those whose faces cannot overlap below; `curves`: (name, times, openings [mm])."""
    _require(key, [t for _, t, _ in curves])
    with plt.rc_context(STYLE):
        figure, (whole, low) = _stack(2, [1.7, 1.9], sharex=True)
        for i, (name, times, openings) in enumerate(curves):
            for axes in (whole, low):
                axes.plot(times, openings, color=SERIES[i], linewidth=0.9, label=name)
        highest = max(max(o) for _, _, o in curves)
        low.set_ylim(-0.2 * highest, 1.08 * highest)
        low.set_xlim(curves[0][1][0], curves[0][1][-1])
        for axes in (whole, low):
            axes.set_ylabel("opening, mm")
        low.set_xlabel("time, s")
        _below(low, whole, 1)
        return Figure(key, element(figure, key, caption), caption)


def crack_paths(key, outline, paths, caption):
    """The section with the cracks, and the cracks by themselves; `paths`: (name, [(x, y)])."""
    _require(key, [p for _, p in paths])
    with plt.rc_context(STYLE):
        figure, (whole, near) = plt.subplots(1, 2, figsize=(SIZE[0], 3.5), width_ratios=(1, 1.5))
        figure.subplots_adjust(left=0.1, right=0.98, top=0.98, bottom=0.36, wspace=0.2)
        closed = [*outline, outline[0]]
        for axes in (whole, near):
            axes.plot(*zip(*closed), color=INK, linewidth=1.0)
            for i, (name, path) in enumerate(paths):
                axes.plot(*zip(*path), color=SERIES[i], linestyle=DASHES[i], linewidth=1.4, label=name)
            axes.set_aspect("equal")
            axes.set_xlabel("x, m")
        xs, ys = ([p[k] for _, path in paths for p in path] for k in (0, 1))
        middle, half = 0.5 * (min(ys) + max(ys)), 0.5 * max(max(ys) - min(ys), 0.9 * (max(xs) - min(xs))) + 1.5
        near.set_xlim(min(xs) - 1.0, max(xs) + 2.0)
        near.set_ylim(middle - half, middle + half)
        whole.set_ylabel("y, m")
        figure.legend(*near.get_legend_handles_labels(), loc="lower center", ncols=1, handlelength=2.2, borderaxespad=0.4)
        return Figure(key, element(figure, key, caption), caption)


def lengths(key, curves, printed, caption):
    """Crack length over time; `printed`: (model's place in curves, time, length) of the paper."""
    _require(key, [t for _, t, _ in curves])
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(SIZE[0], 3.3), layout="constrained")
        for i, (name, times, values) in enumerate(curves):
            axes.plot(times, values, color=SERIES[i], linestyle=DASHES[i], label=name)
        for i, time, length in printed:
            axes.plot([time], [length], color=SERIES[i], marker=MARKS[i], markersize=6, markerfacecolor="none", linestyle="none",
                      label=f"printed, model {curves[i][0].split(':')[0]}" if time == printed[0][1] else None)
        axes.set_xlim(curves[0][1][0], curves[0][1][-1])
        axes.set_ylim(0, None)
        axes.set_xlabel("time, s")
        axes.set_ylabel("crack length, m")
        axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.17), ncols=2, handlelength=2.2, columnspacing=1.4, borderaxespad=0.2)
        return Figure(key, element(figure, key, caption), caption)


def pressures(key, instants, caption):
    """Pressure along the crack; `instants`: (time, [(name, colour's place, positions [m], pressures [kPa])])."""
    if not instants or not all(curves for _, curves in instants):
        raise FigureError(f"{key}: a time without a curve")
    longest = max(positions[-1] for _, curves in instants for _, _, positions, _ in curves)
    with plt.rc_context(STYLE):
        figure, panels = _stack(len(instants), [1.9] * len(instants), sharex=True)
        for axes, (time, curves) in zip(panels, instants):
            for name, i, positions, values in curves:
                axes.plot(positions, values, color=SERIES[i], linestyle=DASHES[i], linewidth=1.6, label=name)
            axes.set_ylabel("pressure, kPa")
            axes.set_title(f"{time:g} s", loc="left", fontsize=8.5)
            axes.set_ylim(0, None)
            axes.set_xlim(0, longest)
        panels[-1].set_xlabel("distance from the mouth, m")
        _below(panels[-1], panels[0], 1)
        return Figure(key, element(figure, key, caption), caption)


def energy(key, times, works, stored, caption):
    """Works into and out of the body, their sum, and what is stored in it [MJ/m]; `works`: (name, values)."""
    _require(key, [times])
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(SIZE[0], 3.6), layout="constrained")
        for i, (name, values) in enumerate(works):
            axes.plot(times, values, color=SERIES[i], linestyle=DASHES[i % 4], linewidth=1.1, label=name)
        axes.plot(times, [sum(v) for v in zip(*(values for _, values in works))], color=SOFT, linewidth=3.4, alpha=0.5, label="sum of all works")
        axes.plot(times, stored, color=INK, linewidth=0.8, label="stored: kinetic and strain")
        axes.set_xlim(times[0], times[-1])
        axes.set_xlabel("time, s")
        axes.set_ylabel("energy, MJ/m")
        axes.legend(loc="upper center", bbox_to_anchor=(0.45, -0.16), ncols=2, handlelength=2.2, columnspacing=1.4, borderaxespad=0.2)
        return Figure(key, element(figure, key, caption), caption)
