"""CalculiX on one triangulation: six-node triangles, their mid-side nodes at the tip moved to the quarter points, SPOOLES, ARPACK.

CalculiX has no contour integral: its displacements go through the same interaction integral as those of the other programs, here in
numpy. CPU time is that of the whole program `ccx`, without the integral; its answers are printed with seven digits.
"""
import pathlib
import re
import resource
import subprocess
import tempfile

import numpy

from problems import edges_of, on_edge, weight


def quadratic(points, triangles, tip):
    """(points with mid-side nodes, triangles (m, 6) in the order corner corner corner 12 23 31)."""
    sides = numpy.vstack([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    unique, place = numpy.unique(numpy.sort(sides, axis=1), axis=0, return_inverse=True)
    middle = points[unique].mean(axis=1)
    if tip is not None:
        at_tip = numpy.hypot(*(points - tip).T) < 1e-12
        for k, other in ((0, 1), (1, 0)):
            near = at_tip[unique[:, k]]
            middle[near] = 0.75 * points[unique[near, k]] + 0.25 * points[unique[near, other]]
    mids = len(points) + place.reshape(3, -1).T
    return numpy.vstack([points, middle]), numpy.hstack([triangles, mids])


def deck(problem, points, elements, triangles, corners):
    """The input file of CalculiX, as text."""
    lines = ["*NODE, NSET=ALL"] + [f"{i + 1}, {x:.12e}, {y:.12e}, 0" for i, (x, y) in enumerate(points.tolist())]
    lines += ["*ELEMENT, TYPE=CPE6, ELSET=BODY"] + [", ".join(str(n + 1) for n in [i] + e) for i, e in enumerate(elements.tolist())]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{problem.youngs_modulus!r}, {problem.poisson_ratio!r}"]
    lines += ["*DENSITY", f"{problem.density!r}"] if problem.density else []
    lines += ["*SOLID SECTION, ELSET=BODY, MATERIAL=M", "1.", "*BOUNDARY"]
    for first, last in problem.clamped:
        lines += [f"{i + 1}, 1, 2" for i in numpy.flatnonzero(on_edge(points, first, last))]
    for point, component in problem.pinned:
        lines += [f"{i + 1}, {component + 1}" for i in numpy.flatnonzero(numpy.hypot(*(points - point).T) < 1e-9)]
    if problem.density:
        return "\n".join(lines + ["*STEP", "*FREQUENCY", "4", "*END STEP"]) + "\n"
    middle = {frozenset((e[k], e[(k + 1) % 3])): e[3 + k] for e in elements.tolist() for k in range(3)}
    lines += ["*STEP", "*STATIC", "*CLOAD"]
    for first, last, traction in problem.tractions:
        for a, b in edges_of(points[:corners], triangles, first, last).tolist():
            length = float(numpy.hypot(*(points[b] - points[a])))
            for node, share in ((a, 1 / 6), (middle[frozenset((a, b))], 4 / 6), (b, 1 / 6)):
                lines += [f"{node + 1}, {c + 1}, {share * length * t:.12e}" for c, t in enumerate(traction) if t]
    return "\n".join(lines + ["*NODE PRINT, NSET=ALL", "U", "*END STEP"]) + "\n"


# A rule of degree 8 on the triangle from Gauss points on the square that is folded onto it.
_G, _W = numpy.polynomial.legendre.leggauss(6)
_G, _W = (_G + 1) / 2, _W / 2
RULE = [(s, t * (1 - s), ws * wt * (1 - s)) for s, ws in zip(_G, _W) for t, wt in zip(_G, _W)]


def _shapes(s, t):
    """Values and derivatives (6, 2) of the six-node triangle; corners at (0, 0), (1, 0), (0, 1)."""
    r = 1 - s - t
    n = numpy.array([r * (2 * r - 1), s * (2 * s - 1), t * (2 * t - 1), 4 * r * s, 4 * s * t, 4 * t * r])
    d = numpy.array([[1 - 4 * r, 1 - 4 * r], [4 * s - 1, 0], [0, 4 * t - 1], [4 * (r - s), -4 * s], [4 * t, 4 * s], [-4 * t, 4 * (r - t)]])
    return n, d


def _auxiliary(problem, x, mode):
    """Displacement gradient [..., component, direction] at points x for K = 1 in one mode, crack along +x."""
    mu = problem.youngs_modulus / 2 / (1 + problem.poisson_ratio)
    kappa = 3 - 4 * problem.poisson_ratio
    away = x - numpy.array(problem.crack[1])
    r, t = numpy.hypot(away[:, 0], away[:, 1]), numpy.arctan2(away[:, 1], away[:, 0])
    c, s, C, S = numpy.cos(t / 2), numpy.sin(t / 2), numpy.cos(t), numpy.sin(t)
    if mode == 1:
        pairs = ((c * (kappa - C), -0.5 * s * (kappa - C) + c * S), (s * (kappa - C), 0.5 * c * (kappa - C) + s * S))
    else:
        pairs = ((s * (kappa + 2 + C), 0.5 * c * (kappa + 2 + C) - s * S), (-c * (kappa - 2 + C), 0.5 * s * (kappa - 2 + C) + c * S))
    scale = 1 / (2 * mu * numpy.sqrt(2 * numpy.pi * r))
    return numpy.stack([numpy.stack([scale * (0.5 * C * g - S * d), scale * (0.5 * S * g + C * d)], axis=-1) for g, d in pairs], axis=-2)


def stress_intensity(problem, points, elements, u):
    """K_I and K_II: ∫ (σ_ij a_i,1 + σ^a_ij u_i,1 - σ_kl ε^a_kl δ_1j) q_,j dA · E' / 2."""
    E, nu = problem.youngs_modulus, problem.poisson_ratio
    mu, lam = E / 2 / (1 + nu), E * nu / (1 + nu) / (1 - 2 * nu)

    def stress(gradient):
        strain = (gradient + gradient.swapaxes(-1, -2)) / 2
        return 2 * mu * strain + lam * numpy.trace(strain, axis1=-2, axis2=-1)[..., None, None] * numpy.eye(2), strain
    q = weight(problem, points)
    sloping = elements[numpy.ptp(q[elements[:, :3]], axis=1) > 0]  # none of them touches the tip: straight sides
    corner = points[sloping[:, :3]]
    slope = q[sloping[:, :3]]
    total = numpy.zeros(2)
    jacobian = numpy.stack([corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]], axis=-1)
    inverse, area = numpy.linalg.inv(jacobian), numpy.linalg.det(jacobian)
    q_slope = numpy.einsum("mr,mrd->md", slope[:, 1:] - slope[:, :1], inverse)
    for s, t, w in RULE:
        n, d = _shapes(s, t)
        x = numpy.einsum("n,mnc->mc", n, points[sloping])
        du = numpy.einsum("mnc,nr,mrd->mcd", u[sloping], d, inverse)
        sigma = stress(du)[0]
        for mode in (1, 2):
            da = _auxiliary(problem, x, mode)
            other, strain = stress(da)
            value = numpy.einsum("mij,mi,mj->m", sigma, da[:, :, 0], q_slope) + numpy.einsum("mij,mi,mj->m", other, du[:, :, 0], q_slope) \
                - numpy.einsum("mkl,mkl->m", sigma, strain) * q_slope[:, 0]
            total[mode - 1] += w * (value * area).sum()
    return (total * E / (1 - nu**2) / 2).tolist()


def run(problem, points, triangles, order):
    """(answer, CPU seconds, degrees of freedom); `order` is 2."""
    assert order == 2
    tip = numpy.array(problem.crack[1], dtype=float) if problem.crack else None
    every, elements = quadratic(points, triangles, tip)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "job.inp").write_text(deck(problem, every, elements, triangles, len(points)))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(["ccx", "job"], cwd=folder, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0 or "Job finished" not in done.stdout:
            raise RuntimeError(f"ccx ended with {done.returncode}: {done.stdout[-1500:]}")
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        text = (folder / "job.dat").read_text()
    rows = [line.split() for line in text.splitlines() if re.match(r"\s+\d+\s+[-+0-9.]", line)]
    if problem.density:
        return [float(row[2]) for row in rows[:4]], seconds, 2 * len(every)  # columns: mode, eigenvalue, rad/time
    u = numpy.zeros_like(every)
    for row in rows:
        u[int(row[0]) - 1] = float(row[1]), float(row[2])
    return stress_intensity(problem, every, elements, u), seconds, 2 * len(every)
