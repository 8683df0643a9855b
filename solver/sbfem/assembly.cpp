#include "solver/sbfem/assembly.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <vector>

namespace sunder::sbfem {
namespace {

/// Where each node appears: entries offsets[i] … offsets[i + 1] - 1, polygons ascending.
struct Incidence {
  std::vector<int> offsets, polygons, locals;
};

Incidence incidence_of(const mesh::NodalMesh& mesh) {
  Incidence incidence;
  incidence.offsets.assign(static_cast<std::size_t>(mesh.node_count()) + 1, 0);
  for (int p = 0; p < mesh.polygon_count(); ++p) {
    for (const int node : mesh.polygon(p).nodes) ++incidence.offsets[static_cast<std::size_t>(node) + 1];
  }
  for (std::size_t i = 1; i < incidence.offsets.size(); ++i) incidence.offsets[i] += incidence.offsets[i - 1];
  incidence.polygons.resize(static_cast<std::size_t>(incidence.offsets.back()));
  incidence.locals.resize(incidence.polygons.size());
  std::vector<int> next(incidence.offsets.begin(), incidence.offsets.end() - 1);
  for (int p = 0; p < mesh.polygon_count(); ++p) {
    int local = 0;
    for (const int node : mesh.polygon(p).nodes) {
      const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(node)]++);
      incidence.polygons[at] = p;
      incidence.locals[at] = local++;
    }
  }
  return incidence;
}

/// For every node the nodes >= itself that share a polygon with it, ascending: one column of 2 × 2 blocks.
struct Pattern {
  std::vector<int> offsets, rows;
};

using Chunks = std::function<void(int, const std::function<void(int, int, int)>&)>;

/// Nodes >= i of the polygons around node i, ascending, into `found`. `mark` remembers for whom a node was seen last.
void upper_neighbours(const mesh::NodalMesh& mesh, const Incidence& incidence, int i, std::vector<int>& mark,
                      std::vector<int>& found) {
  found.clear();
  for (int k = incidence.offsets[i]; k < incidence.offsets[i + 1]; ++k) {
    for (const int node : mesh.polygon(incidence.polygons[k]).nodes) {
      if (node < i || mark[node] == i) continue;
      mark[node] = i;
      found.push_back(node);
    }
  }
  std::ranges::sort(found);
}

Pattern pattern_of(const mesh::NodalMesh& mesh, const Incidence& incidence, const Chunks& chunks) {
  const int nodes = mesh.node_count();
  Pattern pattern;
  pattern.offsets.assign(static_cast<std::size_t>(nodes) + 1, 0);
  std::vector<std::vector<int>> parts;
  std::vector<int> first_of_part;
  // Each chunk of nodes lists its own rows; the parts are joined in the order of the nodes.
  constexpr int part_size = 4096;
  const int part_count = (nodes + part_size - 1) / part_size;
  parts.resize(static_cast<std::size_t>(part_count));
  chunks(part_count, [&](int begin, int end, int) {
    std::vector<int> mark(static_cast<std::size_t>(nodes), -1), found;
    for (int part = begin; part < end; ++part) {
      std::vector<int>& rows = parts[static_cast<std::size_t>(part)];
      for (int i = part * part_size; i < std::min(nodes, (part + 1) * part_size); ++i) {
        upper_neighbours(mesh, incidence, i, mark, found);
        rows.insert(rows.end(), found.begin(), found.end());
        pattern.offsets[static_cast<std::size_t>(i) + 1] = static_cast<int>(found.size());
      }
    }
  });
  for (std::size_t i = 1; i < pattern.offsets.size(); ++i) pattern.offsets[i] += pattern.offsets[i - 1];
  pattern.rows.resize(static_cast<std::size_t>(pattern.offsets.back()));
  chunks(part_count, [&](int begin, int end, int) {
    for (int part = begin; part < end; ++part) {
      std::ranges::copy(parts[static_cast<std::size_t>(part)],
                        pattern.rows.begin() + pattern.offsets[part * part_size]);
    }
  });
  return pattern;
}

/// The pattern of all matrices of one mesh, found once.
class Assembler {
 public:
  Assembler(const mesh::NodalMesh& mesh, numerics::ThreadPool* pool)
      : mesh_(mesh),
        chunks_([pool](int count, const std::function<void(int, int, int)>& body) {
          pool == nullptr ? body(0, count, 0) : pool->chunks(count, body);
        }),
        incidence_(incidence_of(mesh)),
        pattern_(pattern_of(mesh, incidence_, chunks_)) {}

  /// Σ of `matrix_of(polygon)`.
  template <class MatrixOf>
  Eigen::SparseMatrix<double> sum(const MatrixOf& matrix_of) const;

 private:
  /// Column 2i holds both rows of every block, column 2i + 1 lacks the entry above the diagonal.
  int column_start(int i) const { return 4 * pattern_.offsets[i] - i; }

  const mesh::NodalMesh& mesh_;
  Chunks chunks_;
  Incidence incidence_;
  Pattern pattern_;
};

template <class MatrixOf>
Eigen::SparseMatrix<double> Assembler::sum(const MatrixOf& matrix_of) const {
  const int nodes = mesh_.node_count();
  Eigen::SparseMatrix<double> result(2 * nodes, 2 * nodes);
  result.resizeNonZeros(column_start(nodes));
  int* outer = result.outerIndexPtr();
  int* inner = result.innerIndexPtr();
  double* values = result.valuePtr();
  chunks_(nodes, [&](int begin, int end, int) {
    std::vector<int> position(static_cast<std::size_t>(nodes));  // of a row node within the present column
    for (int i = begin; i < end; ++i) {
      const int first = pattern_.offsets[i], blocks = pattern_.offsets[i + 1] - first;
      const int left = column_start(i), right = left + 2 * blocks;  // starts of columns 2i and 2i + 1
      outer[2 * i] = left;
      outer[2 * i + 1] = right;
      for (int b = 0; b < blocks; ++b) {
        const int row = pattern_.rows[first + b];
        position[row] = b;
        inner[left + 2 * b] = 2 * row;
        inner[left + 2 * b + 1] = inner[right + 2 * b] = 2 * row + 1;
        if (b > 0) inner[right + 2 * b - 1] = 2 * row;
      }
      std::fill(values + left, values + right + 2 * blocks - 1, 0.0);
      for (int k = incidence_.offsets[i]; k < incidence_.offsets[i + 1]; ++k) {
        const auto matrix = matrix_of(incidence_.polygons[k]);
        const std::span<const int> around = mesh_.polygon(incidence_.polygons[k]).nodes;
        const double* column = matrix.data() + 2 * incidence_.locals[k] * matrix.rows();
        const double* next = column + matrix.rows();
        for (std::size_t local = 0; local < around.size(); ++local) {
          if (around[local] < i) continue;
          const int b = position[around[local]];
          values[left + 2 * b] += column[2 * local];
          values[left + 2 * b + 1] += column[2 * local + 1];
          if (b > 0) values[right + 2 * b - 1] += next[2 * local];
          values[right + 2 * b] += next[2 * local + 1];
        }
      }
    }
  });
  outer[2 * nodes] = column_start(nodes);
  return result;
}

Eigen::SparseMatrix<double> sum_of_stiffness(const Assembler& assembler, const Formation& formation) {
  return assembler.sum([&formation](int polygon) { return formation.stiffness(polygon); });
}

Eigen::SparseMatrix<double> sum_of_mass(const Assembler& assembler, const Formation& formation) {
  return assembler.sum([&formation](int polygon) { return formation.mass(polygon); });
}

void require_mass(const Formation& formation) {
  if (!formation.has_mass()) throw std::invalid_argument("assemble_mass: the formation was made without mass");
}

}  // namespace

Eigen::SparseMatrix<double> assemble_stiffness(const mesh::NodalMesh& mesh, const Formation& formation,
                                               numerics::ThreadPool* pool) {
  return sum_of_stiffness(Assembler(mesh, pool), formation);
}

Eigen::SparseMatrix<double> assemble_mass(const mesh::NodalMesh& mesh, const Formation& formation,
                                          numerics::ThreadPool* pool) {
  require_mass(formation);
  return sum_of_mass(Assembler(mesh, pool), formation);
}

AssembledMatrices assemble(const mesh::NodalMesh& mesh, const Formation& formation, numerics::ThreadPool* pool) {
  require_mass(formation);
  const Assembler assembler(mesh, pool);
  return {.stiffness = sum_of_stiffness(assembler, formation), .mass = sum_of_mass(assembler, formation)};
}

}  // namespace sunder::sbfem
