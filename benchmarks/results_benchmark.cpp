/// What a snapshot of fields costs: displacement and velocity at the nodes and stress in the polygons of a dam that
/// sways, and what it takes on the disk.
///
/// Every run reads its last displacement back bit by bit before its time counts. `bytes_a_snapshot` is the size of the
/// file over its snapshots, `of_raw` over the values' own size.

#include <benchmark/benchmark.h>
#include <hdf5.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "solver/results/field_file.hpp"

namespace {

using namespace sunder::results;
namespace fs = std::filesystem;

/// A grid of rows x columns squares, 2.4 m each.
FieldMesh grid(int rows, int columns) {
  FieldMesh mesh;
  mesh.points.resize(2, (rows + 1) * (columns + 1));
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c <= columns; ++c) mesh.points.col(r * (columns + 1) + c) << 2.4 * c, 2.4 * r;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const int corner = r * (columns + 1) + c;
      for (const int point : {corner, corner + 1, corner + columns + 2, corner + columns + 1})
        mesh.connectivity.push_back(point);
      mesh.offsets.push_back(static_cast<std::int64_t>(mesh.connectivity.size()));
    }
  }
  return mesh;
}

/// Two modes of a cantilever out of step: smooth, and no two numbers alike.
FieldSnapshot sway(const FieldMesh& mesh, double time) {
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(3, mesh.points.cols()), v = u;
  Eigen::MatrixXd stress = Eigen::MatrixXd::Zero(6, mesh.polygon_count());
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    const double x = mesh.points(0, i), y = mesh.points(1, i) / mesh.points.row(1).maxCoeff();
    const double first = 0.05 * y * y, second = 0.01 * y * std::sin(4.7 * y);
    u(0, i) = first * std::sin(19.0 * time) + second * std::sin(51.0 * time);
    u(1, i) = -2e-4 * x * y * std::sin(19.0 * time);
    v(0, i) = 19.0 * first * std::cos(19.0 * time) + 51.0 * second * std::cos(51.0 * time);
    v(1, i) = -38e-4 * x * y * std::cos(19.0 * time);
  }
  for (Eigen::Index i = 0; i < stress.cols(); ++i) {
    const Eigen::Index corner = mesh.connectivity[static_cast<std::size_t>(mesh.offsets[static_cast<std::size_t>(i)])];
    stress.col(i) << 25e9 * v(1, corner), 25e9 * u(1, corner), 5e9 * (u(1, corner) + v(1, corner)), 1e9 * u(0, corner),
        0.0, 0.0;
  }
  return {.point_data = {{"displacement", u}, {"velocity", v}}, .cell_data = {{"stress", stress}}};
}

bool ends_with(const fs::path& file, const Eigen::MatrixXd& last) {
  const hid_t read = H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(read, "/VTKHDF/PointData/displacement", H5P_DEFAULT), space = H5Dget_space(data);
  hsize_t shape[2] = {};
  H5Sget_simple_extent_dims(space, shape, nullptr);
  Eigen::MatrixXd all(3, static_cast<Eigen::Index>(shape[0]));
  H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(read);
  return all.rightCols(last.cols()) == last;
}

void append_snapshot(benchmark::State& state) {
  const FieldMesh mesh = grid(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const fs::path path = fs::temp_directory_path() / ("sunder-results-benchmark-" + std::to_string(::getpid()) + ".h5");
  FieldFile file(path);
  file.begin_mesh(mesh);
  double time = 0.0;
  FieldSnapshot snapshot;
  for (auto _ : state) {
    state.PauseTiming();
    snapshot = sway(mesh, time += 0.01);
    state.ResumeTiming();
    file.append(time, snapshot);
  }
  file.commit();
  if (!ends_with(path, snapshot.point_data[0].values)) state.SkipWithError("the file does not hold what was written");
  const double each = static_cast<double>(fs::file_size(path)) / file.snapshot_count();
  const auto raw = static_cast<double>(8 * (6 * mesh.point_count() + 6 * mesh.polygon_count()));
  state.counters["bytes_a_snapshot"] = each;
  state.counters["of_raw"] = each / raw;
  fs::remove(path);
}
// 720 polygons are those of the seed paper's dam.
BENCHMARK(append_snapshot)->ArgNames({"rows", "columns"})->Args({36, 20})->Args({200, 50})->Iterations(200);

}  // namespace

BENCHMARK_MAIN();
