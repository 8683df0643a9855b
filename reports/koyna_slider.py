"""The film of a Koyna run: mesh, crack and deformation of results.h5 and the pressure in the crack, quantised for the page.

The page's script draws any picture of it; the one where it starts is drawn here as well, for paper and for readers without
scripts.
"""
import base64
import json

import numpy

from reports.studies import LayoutError

LENGTH, DISPLACEMENT = 0.005, 1e-5  # m of one unit; 16 bits reach 163 m and 0.33 m
LARGEST = 3_000_000                 # bytes of the film in the page


def _text(values, kind):
    return base64.b64encode(numpy.ascontiguousarray(values, dtype=kind).tobytes()).decode()


def _edges(connectivity, offsets):
    """Edges of the polygons, once each: (those of one polygon only: outline and crack faces; those between two)."""
    corners, starts, ends = connectivity, offsets[:-1], offsets[1:]
    following = numpy.arange(1, len(corners) + 1)
    following[ends - 1] = starts
    pairs = numpy.sort(numpy.stack([corners, corners[following]], axis=1), axis=1)
    unique, count = numpy.unique(pairs, axis=0, return_counts=True)
    return unique[count == 1], unique[count > 1]


def _quantised(values, unit, where):
    steps = numpy.rint(values / unit)
    if not numpy.all(numpy.abs(steps) < 32767):
        raise LayoutError(f"layout: koyna: {where}: beyond {32767 * unit:.3g} m or not a number; the film cannot hold it")
    return steps.astype(int)


def pictures(path):
    """(times, meshes, mesh of each picture, displacements): points in LENGTH, displacements in DISPLACEMENT."""
    import h5py  # Debian's python3-h5py; only the film needs it
    with h5py.File(path, "r") as file:
        root = file["VTKHDF"]
        steps = root["Steps"]
        times = [float(t) for t in steps["Values"][:]]
        points_per_part, ids_per_part, cells_per_part = (root[n][:] for n in ("NumberOfPoints", "NumberOfConnectivityIds", "NumberOfCells"))
        points, connectivity, offsets = root["Points"][:, :2], root["Connectivity"][:], root["Offsets"][:]
        displacement = root["PointData/displacement"]
        meshes, mesh_of, moved, known = [], [], [], {}
        for i in range(len(times)):
            part, first = int(steps["PartOffsets"][i]), int(steps["PointOffsets"][i])
            if part not in known:
                cell, entry = int(steps["CellOffsets"][i]) + part, int(steps["ConnectivityIdOffsets"][i])
                known[part] = len(meshes)
                outer, inner = _edges(connectivity[entry:entry + ids_per_part[part]], offsets[cell:cell + cells_per_part[part] + 1])
                meshes.append((_quantised(points[first:first + points_per_part[part]], LENGTH, path.name), outer, inner))
            at = int(steps["PointDataOffsets/displacement"][i])
            mesh_of.append(known[part])
            moved.append(_quantised(displacement[at:at + points_per_part[part], :2], DISPLACEMENT, path.name))
    return times, meshes, mesh_of, moved


def _path(points, edges):
    """The edges of the SVG, as the page's script writes them: metres, y downwards."""
    return "".join(f"M{points[a][0]:.2f} {-points[a][1]:.2f}L{points[b][0]:.2f} {-points[b][1]:.2f}" for a, b in edges)


def _waters(profiles, times):
    """For each time the pressure along the first crack, [[m, kPa], …]; empty without a profile of that time."""
    found = []
    for time in times:
        near = [p for p in profiles if p["crack"] == 0 and abs(p["time"] - time) < 1e-6]
        found.append([[round(s, 3), round(p / 1e3, 1)] for s, p in zip(near[0]["position"], near[0]["pressure"])] if near else [])
    return found


def film(path, profiles, lengths, wanted):
    """What the template shows; `lengths`: crack length at a time; `wanted`: film of the layout."""
    if not path.is_file():
        raise LayoutError(f"layout: koyna: {path} is not there; reports.koyna_runs makes it")
    times, meshes, mesh_of, moved = pictures(path)
    water = _waters(profiles, times)
    if not any(water):
        raise LayoutError(f"layout: koyna: no pressure at any time of {path.name}; output.profile_times asks for it")
    data = {
        "length": LENGTH, "displacement": DISPLACEMENT, "exaggeration": wanted["exaggeration"],
        "times": [round(t, 6) for t in times], "lengths": [round(lengths(t), 3) for t in times],
        "meshes": [{"points": _text(p, "<i2"), "outer": _text(outer, "<u2"), "inner": _text(inner, "<u2")} for p, outer, inner in meshes],
        "mesh": mesh_of, "moved": [_text(u, "<i2") for u in moved], "water": water,
    }
    text = json.dumps(data, separators=(",", ":"))
    if len(text) > LARGEST:
        raise LayoutError(f"layout: koyna: the film has {len(text)} bytes, more than {LARGEST}; show fewer pictures")
    start = min(range(len(times)), key=lambda i: abs(times[i] - wanted["start"]))
    points, outer, inner = meshes[mesh_of[start]]
    shown = points * LENGTH + wanted["exaggeration"] * DISPLACEMENT * moved[start]
    longest, highest = max([s for line in water for s, _ in line] + [1.0]), max([p for line in water for _, p in line] + [1.0])
    return {"data": text, "start": start, "last": len(times) - 1, "time": times[start], "length": data["lengths"][start],
            "exaggeration": wanted["exaggeration"], "outer": _path(shown, outer), "inner": _path(shown, inner),
            "longest": longest, "highest": highest, "pressure": pressure_path(water[start], longest, highest)}


def pressure_path(line, longest, highest):
    """The pressure curve in a box of 300 × 120, its ground below."""
    if not line:
        return ""
    places = [(300 * s / longest, 120 - 120 * p / highest) for s, p in line]
    return f"M{places[0][0]:.1f} 120" + "".join(f"L{x:.1f} {y:.1f}" for x, y in places) + f"L{places[-1][0]:.1f} 120Z"
