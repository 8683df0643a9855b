"""The three problems that every program solves, and the triangulations that the finite-element programs share.

Plane strain throughout. A triangulation is graded: its triangles are `tip` long at each singular point and grow by
`growth` of the distance to it, up to `far`. The crack is a slit: its nodes but the tip are doubled.
"""
import dataclasses
import math
import time

import numpy


@dataclasses.dataclass(frozen=True)
class Problem:
    name: str
    title: str
    scene: str                 # of Sunder, below verification/cases
    outline: tuple             # counter-clockwise, m
    singular: tuple            # points to which the triangulation is graded
    youngs_modulus: float
    poisson_ratio: float
    far: float                 # largest triangle, m
    quantity: str
    reference: tuple           # K_I and K_II, or angular frequencies in rad/s
    source: str
    crack: tuple = ()          # (mouth, tip)
    tractions: tuple = ()      # (first outline point, last, traction) of straight edges
    clamped: tuple = ()        # (first outline point, last)
    pinned: tuple = ()         # (point, component)
    density: float = 0.0
    integral: tuple = ()       # radii between which the integral's weight falls from 1 to 0


PROBLEMS = {p.name: p for p in (
    Problem("edge-crack", "Edge crack in tension", "sif/edge-crack.scene.toml", ((0, -1), (1, -1), (1, 1), (0, 1)), ((0.5, 0),),
            1.0, 0.25, 0.4, "K_I", (2.8254653223 * math.sqrt(math.pi * 0.5), 0.0),
            "verification/cases/sif/edge-crack-one-polygon.case.toml",
            crack=((0, 0), (0.5, 0)), tractions=(((1, 1), (0, 1), (0, 1)), ((0, -1), (1, -1), (0, -1))),
            pinned=(((1, -1), 0), ((1, -1), 1), ((1, 1), 0)), integral=(0.1, 0.45)),
    Problem("edge-crack-shear", "Edge crack in shear", "sif/edge-crack-shear.scene.toml", ((0, 0), (7, 0), (7, 16), (0, 16)),
            ((3.5, 8), (0, 0), (7, 0)), 1.0, 0.25, 2.5, "K_I and K_II", (34.04254, 4.53694),
            "verification/cases/sif/edge-crack-shear.case.toml",
            crack=((0, 8), (3.5, 8)), tractions=(((7, 16), (0, 16), (1, 0)),), clamped=(((0, 0), (7, 0)),), integral=(0.7, 3.0)),
    Problem("koyna-section", "Frequencies of the Koyna section", "modal/koyna-section.scene.toml",
            ((0, 0), (70, 0), (19.25, 66.5), (14.8, 103), (0, 103)), ((0, 0), (70, 0), (19.25, 66.5)), 25e9, 0.2, 15.0,
            "the four lowest frequencies", (17.97443097, 47.4840137, 64.87319720, 93.3078469), "benchmarks/peers/README.md",
            clamped=(((0, 0), (70, 0)),), density=2450.0),
)}


def error_of(problem, answer):
    """The largest relative error of the numbers that are not zero by symmetry."""
    return max(abs(a / r - 1.0) for a, r in zip(answer, problem.reference) if r != 0.0)


def triangulate(problem, tip, growth):
    """(points (n, 2), triangles (m, 3) counter-clockwise, CPU seconds of the mesh generator)."""
    import gmsh
    gmsh.initialize(["gmsh", "-v", "0", "-nt", "1"], readConfigFiles=False)
    begin = time.process_time()
    gmsh.option.setNumber("Geometry.Tolerance", 1e-12)
    gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
    gmsh.option.setNumber("Mesh.MeshSizeFromPoints", 0)
    gmsh.option.setNumber("Mesh.Algorithm", 5)  # Delaunay: the one for steep gradings
    corners = [tuple(map(float, p)) for p in problem.outline]
    crack = [tuple(map(float, p)) for p in problem.crack]
    loop = corners + crack[:1]  # the mouth lies on the last edge
    tags = {p: gmsh.model.geo.addPoint(*p, 0.0) for p in dict.fromkeys(loop + crack + [tuple(map(float, p)) for p in problem.singular])}
    lines = [gmsh.model.geo.addLine(tags[a], tags[b]) for a, b in zip(loop, loop[1:] + loop[:1])]
    surface = gmsh.model.geo.addPlaneSurface([gmsh.model.geo.addCurveLoop(lines)])
    face = gmsh.model.geo.addLine(tags[crack[0]], tags[crack[1]]) if crack else None
    gmsh.model.geo.synchronize()
    if face:
        gmsh.model.mesh.embed(1, [face], 2, surface)
    distances = ", ".join(f"sqrt((x-{x!r})^2+(y-{y!r})^2)" for x, y in problem.singular)
    nearest = distances.split(", ")
    expression = nearest[0]
    for other in nearest[1:]:
        expression = f"min({expression}, {other})"
    field = gmsh.model.mesh.field.add("MathEval")
    gmsh.model.mesh.field.setString(field, "F", f"min({problem.far!r}, {tip!r}+{growth!r}*{expression})")
    gmsh.model.mesh.field.setAsBackgroundMesh(field)
    gmsh.model.mesh.generate(2)
    identities, coordinates, _ = gmsh.model.mesh.getNodes()
    _, _, connected = gmsh.model.mesh.getElements(2, surface)
    seconds = time.process_time() - begin
    gmsh.finalize()
    points = numpy.asarray(coordinates).reshape(-1, 3)[:, :2]
    place = numpy.zeros(int(max(identities)) + 1, dtype=int)
    place[numpy.asarray(identities, dtype=int)] = numpy.arange(len(identities))
    triangles = place[numpy.asarray(connected[0], dtype=int)].reshape(-1, 3)
    a, b, c = (points[triangles[:, i]] for i in range(3))
    area = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    longest = numpy.max([numpy.hypot(*(p - q).T) for p, q in ((a, b), (b, c), (c, a))], axis=0)
    turned = area < 0
    triangles[turned] = triangles[turned][:, [0, 2, 1]]
    if (abs(area) < 0.1 * longest**2).any():
        raise ValueError(f"{problem.name}, tip {tip}: the mesh generator left a sliver; the grading is too steep for it")
    used, triangles = numpy.unique(triangles, return_inverse=True)
    points, triangles = points[used], triangles.reshape(-1, 3)
    return (*_slit(points, triangles, crack), seconds) if crack else (points, triangles, seconds)


def _slit(points, triangles, crack):
    """Doubles the nodes of the crack (a horizontal one) but its tip: triangles above it get the new ones."""
    (x0, y0), (x1, _) = crack
    size = x1 - x0
    on = numpy.flatnonzero((abs(points[:, 1] - y0) < 1e-12 * size) & (points[:, 0] < x1 - 1e-12 * size))
    doubled = numpy.arange(len(points))
    doubled[on] = len(points) + numpy.arange(len(on))
    above = points[triangles].mean(axis=1)[:, 1] > y0
    triangles = triangles.copy()
    triangles[above] = doubled[triangles[above]]
    return numpy.vstack([points, points[on]]), triangles


def on_edge(points, first, last):
    """Which points lie on the straight edge between two outline points."""
    first, last = numpy.asarray(first, dtype=float), numpy.asarray(last, dtype=float)
    along = last - first
    away = points - first
    length = numpy.hypot(*along)
    t = away @ along / length**2
    return (abs(away[:, 0] * along[1] - away[:, 1] * along[0]) < 1e-9 * length**2) & (t > -1e-9) & (t < 1 + 1e-9)


def boundary_edges(triangles):
    """Edges (k, 2) that belong to one triangle only, in its direction."""
    edges = numpy.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    _, first, counts = numpy.unique(numpy.sort(edges, axis=1), axis=0, return_index=True, return_counts=True)
    return edges[first[counts == 1]]


def edges_of(points, triangles, first, last):
    edges = boundary_edges(triangles)
    on = on_edge(points, first, last)
    return edges[on[edges].all(axis=1)]


def weight(problem, points):
    """The weight of the interaction integral at points (n, 2): 1 at the tip, falling linearly to 0 between its radii."""
    inner, outer = problem.integral
    distance = numpy.hypot(points[:, 0] - problem.crack[1][0], points[:, 1] - problem.crack[1][1])
    return numpy.clip((outer - distance) / (outer - inner), 0.0, 1.0)
