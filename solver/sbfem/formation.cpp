#include "solver/sbfem/formation.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "solver/numerics/lanes.hpp"
#include "solver/sbfem/polygon_batch.hpp"
#include "solver/sbfem/reference_edge.hpp"

namespace sunder::sbfem {
namespace {

using numerics::Lanes;

/// Polygons that are solved together: `count` of `order` from `first` on.
struct Task {
  int first, count;
  double cost;
};

struct Plan {
  std::vector<int> order;   // polygons, those of one pattern side by side
  std::vector<Task> tasks;  // in descending cost
  int largest_batch = 0;    // degrees of freedom of the largest batched polygon
};

bool same_pattern(const mesh::NodalPolygon& a, const mesh::NodalPolygon& b) {
  return a.open == b.open && std::ranges::equal(a.orders, b.orders);
}

/// Sorts the polygons that are to be formed (same[i] < 0) into patterns in the order of their first appearance, and
/// cuts each into fours.
Plan plan_of(const mesh::NodalMesh& mesh, const FormationOptions& options, std::span<const int> same) {
  const int count = mesh.polygon_count();
  std::vector<std::vector<int>> groups;
  std::unordered_multimap<std::uint64_t, std::size_t> known;
  for (int i = 0; i < count; ++i) {
    if (same[static_cast<std::size_t>(i)] >= 0) continue;
    const mesh::NodalPolygon polygon = mesh.polygon(i);
    std::uint64_t hash = polygon.open ? 0x9e3779b97f4a7c15u : 0xcbf29ce484222325u;  // FNV-1a over the orders
    for (const int p : polygon.orders) hash = (hash ^ static_cast<std::uint64_t>(p)) * 0x100000001b3u;
    const auto [begin, end] = known.equal_range(hash);
    const auto found = std::find_if(begin, end, [&](const auto& entry) {
      return same_pattern(polygon, mesh.polygon(groups[entry.second].front()));
    });
    if (found == end) {
      known.emplace(hash, groups.size());
      groups.push_back({i});
    } else {
      groups[found->second].push_back(i);
    }
  }
  Plan plan;
  plan.order.reserve(static_cast<std::size_t>(count));
  for (const std::vector<int>& group : groups) {
    const int N = 2 * static_cast<int>(mesh.polygon(group.front()).nodes.size());
    const bool batched = options.route == Route::ring_doubling && N <= options.largest_batched_size;
    if (batched) plan.largest_batch = std::max(plan.largest_batch, N);
    const int step = batched ? Lanes::count : 1, size = static_cast<int>(group.size());
    const double cost = static_cast<double>(N) * N * N;
    for (int k = 0; k < size; k += step) {
      plan.tasks.push_back({static_cast<int>(plan.order.size()) + k, std::min(step, size - k), cost});
    }
    plan.order.insert(plan.order.end(), group.begin(), group.end());
  }
  std::ranges::stable_sort(plan.tasks, [](const Task& a, const Task& b) { return a.cost > b.cost; });
  return plan;
}

/// Whether the scaling centre sees every edge from inside.
bool sees_all_edges(const mesh::NodalMesh& mesh, const mesh::NodalPolygon& polygon) {
  const std::size_t n = polygon.nodes.size();
  std::size_t start = 0;
  for (const int p : polygon.orders) {
    const std::size_t next = start + static_cast<std::size_t>(p), end = next == n ? 0 : next;
    const Eigen::Vector2d first = mesh.coordinates().col(polygon.nodes[start]) - polygon.scaling_centre;
    const Eigen::Vector2d last = mesh.coordinates().col(polygon.nodes[end]) - polygon.scaling_centre;
    const Eigen::Vector2d along = last - first;
    if (!(first.x() * along.y() - first.y() * along.x() > 0.0)) return false;
    start = next;
  }
  return true;
}

}  // namespace

/// What one thread needs to work through its tasks.
struct FormationAccess {
  const mesh::NodalMesh& mesh;
  std::span<const material::Isotropic> materials;
  const FormationOptions& options;
  const Plan& plan;
  std::span<const ReferenceEdge> references;
  std::span<const BatchMaterial<double>> moduli;
  Formation& formation;

  /// Sizes and places of all blocks; those of unchanged polygons are filled.
  static Formation laid_out(const mesh::NodalMesh& mesh, bool with_mass, const Formation& earlier,
                            std::span<const int> same);
  static void summarise(Formation& formation);
  void solve_single(int polygon) const;
  void solve_batch(PolygonBatch<Lanes>& batch, const Task& task) const;
  void store(PolygonBatch<Lanes>& batch, const Task& task) const;
  void mark_failed(int polygon, PolygonStatus status) const;
};

void FormationAccess::mark_failed(int polygon, PolygonStatus status) const {
  const auto i = static_cast<std::size_t>(polygon);
  const auto length = static_cast<std::size_t>(formation.sizes_[i]) * static_cast<std::size_t>(formation.sizes_[i]);
  formation.statuses_[i] = status;
  std::fill_n(formation.stiffness_.data() + formation.offsets_[i], length, std::numeric_limits<double>::quiet_NaN());
  if (options.with_mass) {
    std::fill_n(formation.mass_.data() + formation.offsets_[i], length, std::numeric_limits<double>::quiet_NaN());
  }
}

void FormationAccess::solve_single(int polygon) const {
  const auto i = static_cast<std::size_t>(polygon);
  const int N = formation.sizes_[i];
  const auto& material = materials[static_cast<std::size_t>(mesh.polygon(polygon).material)];
  const Coefficients c = coefficients(boundary_of(mesh, polygon), material);
  const PolygonSolution solution = solve_polygon(c, options.route);
  formation.asymmetries_[i] = solution.asymmetry;
  formation.iterations_[i] = solution.iterations;
  if (solution.status != PolygonStatus::converged) return mark_failed(polygon, solution.status);
  Eigen::Map<Eigen::MatrixXd>(formation.stiffness_.data() + formation.offsets_[i], N, N) = solution.K;
  if (!options.with_mass) return;
  const Eigen::MatrixXd M = mass(c, solution);
  if (!M.allFinite()) return mark_failed(polygon, PolygonStatus::not_converged);
  Eigen::Map<Eigen::MatrixXd>(formation.mass_.data() + formation.offsets_[i], N, N) = M;
}

void FormationAccess::solve_batch(PolygonBatch<Lanes>& batch, const Task& task) const {
  const mesh::NodalPolygon pattern = mesh.polygon(plan.order[static_cast<std::size_t>(task.first)]);
  const auto n = pattern.nodes.size();
  batch.size = 2 * static_cast<int>(n);
  bool any_density = false;
  for (int lane = 0; lane < Lanes::count; ++lane) {
    // Lanes that are left over repeat the last polygon; nobody reads them.
    const int k = task.first + std::min(lane, task.count - 1);
    const mesh::NodalPolygon polygon = mesh.polygon(plan.order[static_cast<std::size_t>(k)]);
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d x = mesh.coordinates().col(polygon.nodes[i]) - polygon.scaling_centre;
      batch.x[i].set(lane, x.x());
      batch.y[i].set(lane, x.y());
    }
    const BatchMaterial<double>& moduli_of_lane = moduli[static_cast<std::size_t>(polygon.material)];
    batch.material.direct.set(lane, moduli_of_lane.direct);
    batch.material.coupled.set(lane, moduli_of_lane.coupled);
    batch.material.shear.set(lane, moduli_of_lane.shear);
    batch.material.density.set(lane, moduli_of_lane.density);
    any_density = any_density || moduli_of_lane.density > 0.0;
  }
  fill_coefficients(batch, pattern.orders, references);
  solve_stiffness(batch);
  if (options.with_mass && any_density) solve_mass(batch, pattern.orders, references);
  if (options.with_mass && !any_density) std::fill_n(batch.M.data(), batch.size * batch.size, Lanes(0.0));
  store(batch, task);
}

void FormationAccess::store(PolygonBatch<Lanes>& batch, const Task& task) const {
  const int N = batch.size;
  std::vector<Lanes>& stretch = batch.inverse;
  for (int i = 0; i < N; ++i) stretch[i] = Lanes(1.0) / batch.scale[i];
  const auto unpack = [&](const std::vector<Lanes>& scaled, std::vector<double>& values) {
    double* target[Lanes::count];
    for (int lane = 0; lane < Lanes::count; ++lane) {
      const int polygon = plan.order[static_cast<std::size_t>(task.first + std::min(lane, task.count - 1))];
      target[lane] = values.data() + formation.offsets_[static_cast<std::size_t>(polygon)];
    }
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j <= i; ++j) {
        const Lanes value = scaled[i * N + j] * stretch[i] * stretch[j];
        for (int lane = 0; lane < task.count; ++lane) target[lane][i * N + j] = target[lane][j * N + i] = value[lane];
      }
    }
  };
  unpack(batch.K, formation.stiffness_);
  if (options.with_mass) unpack(batch.M, formation.mass_);
  for (int lane = 0; lane < task.count; ++lane) {
    const int polygon = plan.order[static_cast<std::size_t>(task.first + lane)];
    const auto i = static_cast<std::size_t>(polygon);
    formation.iterations_[i] = static_cast<int>(batch.iterations[lane]);
    const auto K = formation.stiffness(polygon);
    const bool sound =
        K.allFinite() && K.diagonal().minCoeff() > 0.0 && (!options.with_mass || formation.mass(polygon).allFinite());
    // What the lanes cannot do is tried again by itself, with everything solve_polygon falls back on.
    if (!sound || batch.converged[lane] == 0.0) solve_single(polygon);
  }
}

namespace {

/// Tasks by thread, the dearest first to whoever has least: a fixed rule, and every task writes to its own polygons
/// only.
std::vector<std::vector<int>> shares_of(const std::vector<Task>& tasks, int threads) {
  std::vector<std::vector<int>> shares(static_cast<std::size_t>(threads));
  std::vector<double> load(static_cast<std::size_t>(threads), 0.0);
  for (std::size_t t = 0; t < tasks.size(); ++t) {
    const auto least = static_cast<std::size_t>(std::ranges::min_element(load) - load.begin());
    shares[least].push_back(static_cast<int>(t));
    load[least] += tasks[t].cost;
  }
  return shares;
}

/// Refuses what no polygon can be formed from; fills the layout of the results on the way. Returns the largest order.
int check_polygons(const mesh::NodalMesh& mesh, std::span<const material::Isotropic> materials,
                   std::span<const int> same) {
  int largest_order = 1;
  for (int i = 0; i < mesh.polygon_count(); ++i) {
    if (same[static_cast<std::size_t>(i)] >= 0) continue;
    const mesh::NodalPolygon polygon = mesh.polygon(i);
    const std::string name = "polygon " + std::to_string(i);
    if (polygon.material < 0 || static_cast<std::size_t>(polygon.material) >= materials.size()) {
      throw std::invalid_argument(name + ": material " + std::to_string(polygon.material) +
                                  ", accepted is 0 <= material < " + std::to_string(materials.size()));
    }
    if (!sees_all_edges(mesh, polygon)) {
      try {
        coefficients(boundary_of(mesh, i), materials[static_cast<std::size_t>(polygon.material)]);
      } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ": " + error.what());
      }
    }
    largest_order = std::max(largest_order, std::ranges::max(polygon.orders));
  }
  return largest_order;
}

}  // namespace

Formation FormationAccess::laid_out(const mesh::NodalMesh& mesh, bool with_mass, const Formation& earlier,
                                    std::span<const int> same) {
  Formation formation;
  const auto count = static_cast<std::size_t>(mesh.polygon_count());
  formation.sizes_.resize(count);
  formation.offsets_.resize(count + 1, 0);
  formation.statuses_.resize(count, PolygonStatus::converged);
  formation.asymmetries_.resize(count, 0.0);
  formation.iterations_.resize(count, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t N = 2 * mesh.polygon(static_cast<int>(i)).nodes.size();
    formation.sizes_[i] = static_cast<int>(N);
    formation.offsets_[i + 1] = formation.offsets_[i] + N * N;
  }
  formation.stiffness_.resize(formation.offsets_.back());
  if (with_mass) formation.mass_.resize(formation.offsets_.back());
  for (std::size_t i = 0; i < count; ++i) {
    if (same[i] < 0) continue;
    const auto from = static_cast<std::size_t>(same[i]);
    if (from >= earlier.sizes_.size() || earlier.sizes_[from] != formation.sizes_[i]) {
      throw std::invalid_argument("form_again: polygon " + std::to_string(i) + " is not of the size of polygon " +
                                  std::to_string(same[i]) + " of the earlier formation");
    }
    const auto length = static_cast<std::ptrdiff_t>(formation.offsets_[i + 1] - formation.offsets_[i]);
    const auto begin = static_cast<std::ptrdiff_t>(earlier.offsets_[from]);
    const auto target = static_cast<std::ptrdiff_t>(formation.offsets_[i]);
    std::copy_n(earlier.stiffness_.begin() + begin, length, formation.stiffness_.begin() + target);
    if (with_mass) std::copy_n(earlier.mass_.begin() + begin, length, formation.mass_.begin() + target);
    formation.statuses_[i] = earlier.statuses_[from];
    formation.asymmetries_[i] = earlier.asymmetries_[from];
    formation.iterations_[i] = earlier.iterations_[from];
    ++formation.summary_.reused_count;
  }
  return formation;
}

void FormationAccess::summarise(Formation& formation) {
  FormationSummary& summary = formation.summary_;
  for (int i = 0; i < formation.polygon_count(); ++i) {
    const PolygonStatus status = formation.status(i);
    if (status != PolygonStatus::converged) ++summary.failed_count;
    if (static_cast<int>(status) > static_cast<int>(summary.worst_status)) {
      summary.worst_status = status;
      summary.worst_polygon = i;
    }
    summary.largest_asymmetry =
        std::max(summary.largest_asymmetry, formation.asymmetries_[static_cast<std::size_t>(i)]);
    summary.most_iterations = std::max(summary.most_iterations, formation.iterations_[static_cast<std::size_t>(i)]);
  }
}

Formation form(const mesh::NodalMesh& mesh, std::span<const material::Isotropic> materials,
               const FormationOptions& options) {
  const std::vector<int> none(static_cast<std::size_t>(mesh.polygon_count()), -1);
  return form_again(mesh, materials, options, {}, none);
}

Formation form_again(const mesh::NodalMesh& mesh, std::span<const material::Isotropic> materials,
                     const FormationOptions& options, const Formation& earlier, std::span<const int> same) {
  if (std::ssize(same) != mesh.polygon_count()) {
    throw std::invalid_argument("form_again: same has " + std::to_string(same.size()) + " entries, accepted is " +
                                std::to_string(mesh.polygon_count()));
  }
  if (earlier.polygon_count() > 0 && options.with_mass != earlier.has_mass()) {
    throw std::invalid_argument("form_again: with_mass is " + std::to_string(options.with_mass) +
                                ", accepted is what the earlier formation has");
  }
  std::vector<BatchMaterial<double>> moduli;
  for (const material::Isotropic& material : materials) {
    material::check(material);
    const Eigen::Matrix3d D = material::elasticity_matrix(material);
    moduli.push_back({D(0, 0), D(0, 1), D(2, 2), material.density});
  }
  const int largest_order = check_polygons(mesh, materials, same);
  const Plan plan = plan_of(mesh, options, same);
  std::vector<ReferenceEdge> references(1);  // by order; order 0 is none
  for (int p = 1; p <= (plan.largest_batch > 0 ? largest_order : 0); ++p) references.push_back(reference_edge(p));

  Formation formation = FormationAccess::laid_out(mesh, options.with_mass, earlier, same);
  const FormationAccess access{mesh, materials, options, plan, references, moduli, formation};
  const auto work_through = [&](const std::vector<int>& share) {
    PolygonBatch<Lanes> batch(plan.largest_batch);
    for (const int t : share) {
      const Task& task = plan.tasks[static_cast<std::size_t>(t)];
      const int first = plan.order[static_cast<std::size_t>(task.first)];
      const bool batched =
          options.route == Route::ring_doubling && formation.size(first) <= options.largest_batched_size;
      batched ? access.solve_batch(batch, task) : access.solve_single(first);
    }
  };
  const int threads = options.pool == nullptr ? 1 : options.pool->threads();
  const std::vector<std::vector<int>> shares = shares_of(plan.tasks, threads);
  if (options.pool == nullptr) {
    work_through(shares.front());
  } else {
    options.pool->parallel_for(threads, [&](int t) { work_through(shares[static_cast<std::size_t>(t)]); });
  }
  FormationAccess::summarise(formation);
  return formation;
}

}  // namespace sunder::sbfem
