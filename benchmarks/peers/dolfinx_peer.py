"""dolfinx on one triangulation: Lagrange elements of a given order, MUMPS (Cholesky), SLEPc for frequencies.

Called as `python3 dolfinx_peer.py PROBLEM MESH.npz ORDER`; prints one JSON object. The solution runs once on a small mesh
first, so that compiling and loading the forms is not in the time.
"""
import json
import sys
import time

import numpy
import ufl
from dolfinx import fem, mesh
from mpi4py import MPI
from petsc4py import PETSc
from slepc4py import SLEPc

from problems import PROBLEMS, on_edge, triangulate, weight


def elasticity(problem):
    E, nu = problem.youngs_modulus, problem.poisson_ratio
    mu, lam = E / 2 / (1 + nu), E * nu / (1 + nu) / (1 - 2 * nu)
    strain = lambda u: ufl.sym(ufl.grad(u))  # noqa: E731
    return mu, (lambda u: 2 * mu * strain(u) + lam * ufl.tr(strain(u)) * ufl.Identity(2)), strain


def solver_of(matrix):
    ksp = PETSc.KSP().create(MPI.COMM_SELF)
    ksp.setOperators(matrix)
    ksp.setType("preonly")
    ksp.getPC().setType("cholesky")
    ksp.getPC().setFactorSolverType("mumps")
    return ksp


def auxiliary(domain, problem, mode):
    """The displacement at the tip of a crack along +x for K = 1 in one mode."""
    x = ufl.SpatialCoordinate(domain)
    tip = problem.crack[1]
    dx, dy = x[0] - tip[0], x[1] - tip[1]
    r, angle = ufl.sqrt(dx * dx + dy * dy), ufl.atan_2(dy, dx)
    mu = elasticity(problem)[0]
    kappa = 3 - 4 * problem.poisson_ratio
    c, s = ufl.cos(angle / 2), ufl.sin(angle / 2)
    scale = ufl.sqrt(r / (2 * numpy.pi)) / (2 * mu)
    if mode == 1:
        u = ufl.as_vector([scale * c * (kappa - ufl.cos(angle)), scale * s * (kappa - ufl.cos(angle))])
    else:
        u = ufl.as_vector([scale * s * (kappa + 2 + ufl.cos(angle)), -scale * c * (kappa - 2 + ufl.cos(angle))])
    return u


def weight_of(domain, problem):
    """Falls linearly from 1 to 0 between the radii of the integral, a number a vertex."""
    q = fem.Function(fem.FunctionSpace(domain, ("Lagrange", 1)))
    q.interpolate(lambda x: weight(problem, x.T))
    return q


def stress_intensity(domain, problem, u, order):
    """K_I and K_II by the domain form of the interaction integral."""
    _, stress, strain = elasticity(problem)
    q = weight_of(domain, problem)
    modulus = problem.youngs_modulus / (1 - problem.poisson_ratio**2)
    found = []
    for mode in (1, 2):
        a = auxiliary(domain, problem, mode)
        sigma, other = stress(u), stress(a)
        integrand = sum((sigma[i, j] * a[i].dx(0) + other[i, j] * u[i].dx(0)) * q.dx(j) for i in range(2) for j in range(2)) \
            - ufl.inner(sigma, strain(a)) * q.dx(0)
        value = fem.assemble_scalar(fem.form(integrand * ufl.dx(metadata={"quadrature_degree": 2 * order + 4})))
        found.append(float(value) * modulus / 2)
    return found


def solve(problem, points, triangles, order):
    cell = ufl.Mesh(ufl.VectorElement("Lagrange", ufl.triangle, 1))
    domain = mesh.create_mesh(MPI.COMM_SELF, triangles.astype(numpy.int64), points, cell)
    space = fem.VectorFunctionSpace(domain, ("Lagrange", order))
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    _, stress, strain = elasticity(problem)
    conditions = []
    zero = numpy.zeros(2, dtype=PETSc.ScalarType)
    for first, last in problem.clamped:
        conditions.append(fem.dirichletbc(zero, fem.locate_dofs_geometrical(space, lambda x: on_edge(x[:2].T, first, last)), space))
    for point, component in problem.pinned:
        sub = space.sub(component)
        collapsed, _ = sub.collapse()
        dofs = fem.locate_dofs_geometrical((sub, collapsed), lambda x: numpy.hypot(x[0] - point[0], x[1] - point[1]) < 1e-9)
        value = fem.Function(collapsed)
        conditions.append(fem.dirichletbc(value, dofs, sub))
    stiffness = fem.form(ufl.inner(stress(u), strain(v)) * ufl.dx)
    K = fem.petsc.assemble_matrix(stiffness, conditions)
    K.assemble()
    dofs = space.dofmap.index_map.size_global * 2
    if problem.density:
        mass = fem.form(problem.density * ufl.inner(u, v) * ufl.dx)
        M = fem.petsc.assemble_matrix(mass, conditions, diagonal=0.0)
        M.assemble()
        eigen = SLEPc.EPS().create(MPI.COMM_SELF)
        eigen.setOperators(K, M)
        eigen.setProblemType(SLEPc.EPS.ProblemType.GHEP)
        eigen.setDimensions(4)
        eigen.setTolerances(1e-11)
        transform = eigen.getST()
        transform.setType("sinvert")
        transform.setKSP(solver_of(K))
        eigen.setTarget(0.0)
        eigen.setWhichEigenpairs(SLEPc.EPS.Which.TARGET_MAGNITUDE)
        eigen.solve()
        return sorted(float(numpy.sqrt(eigen.getEigenvalue(i).real)) for i in range(4)), dofs
    load, tags = [], []
    for i, (first, last, _) in enumerate(problem.tractions):
        facets = mesh.locate_entities_boundary(domain, 1, lambda x: on_edge(x[:2].T, first, last))
        load.append(facets)
        tags.append(numpy.full(len(facets), i, dtype=numpy.int32))
    facets, tags = numpy.concatenate(load), numpy.concatenate(tags)
    place = numpy.argsort(facets)
    ds = ufl.Measure("ds", domain=domain, subdomain_data=mesh.meshtags(domain, 1, facets[place], tags[place]))
    work = sum(ufl.dot(fem.Constant(domain, PETSc.ScalarType(traction)), v) * ds(i) for i, (_, _, traction) in enumerate(problem.tractions))
    b = fem.petsc.assemble_vector(fem.form(work))
    fem.petsc.apply_lifting(b, [stiffness], [conditions])
    fem.petsc.set_bc(b, conditions)
    found = fem.Function(space)
    solver_of(K).solve(b, found.vector)
    return stress_intensity(domain, problem, found, order), dofs


def main():
    problem, order = PROBLEMS[sys.argv[1]], int(sys.argv[3])
    data = numpy.load(sys.argv[2])
    small = triangulate(problem, problem.far / 4, 0.5)
    solve(problem, small[0], small[1], order)
    begin = time.process_time()
    answer, dofs = solve(problem, data["points"], data["triangles"], order)
    print(json.dumps({"answer": answer, "seconds": time.process_time() - begin, "dofs": dofs}))


if __name__ == "__main__":
    main()
