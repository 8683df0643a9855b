#include "solver/results/field_file.hpp"

#include <cmath>
#include <stdexcept>

#include "solver/results/atomic_file.hpp"
#include "solver/results/hdf5_file.hpp"

namespace sunder::results {
namespace {

namespace fs = std::filesystem;
using std::int64_t;

const std::string root = "/VTKHDF";
constexpr std::uint8_t vtk_polygon = 7;

/// Where a snapshot's mesh and values begin in the tables, counted in rows; `mesh` counts the meshes.
struct Step {
  double time = 0.0;
  int64_t mesh = -1, point = 0, polygon = 0, connectivity = 0;
  int64_t point_data = 0, cell_data = 0;
};

std::span<const double> numbers(const Eigen::MatrixXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

void check_mesh(const FieldMesh& mesh) {
  const auto refuse = [](const std::string& what) { throw std::invalid_argument("mesh." + what); };
  const std::vector<int64_t>& offsets = mesh.offsets;
  if (offsets.empty() || offsets.front() != 0 || offsets.back() != static_cast<int64_t>(mesh.connectivity.size())) {
    refuse("offsets: accepted are values from 0 to the length of connectivity, " +
           std::to_string(mesh.connectivity.size()));
  }
  for (std::size_t i = 1; i < offsets.size(); ++i) {
    if (offsets[i] < offsets[i - 1]) refuse("offsets[" + std::to_string(i) + "]: falls; accepted are ascending values");
  }
  for (std::size_t i = 0; i < mesh.connectivity.size(); ++i) {
    const int64_t point = mesh.connectivity[i];
    if (point < 0 || point >= mesh.point_count()) {
      refuse("connectivity[" + std::to_string(i) + "] = " + std::to_string(point) + ", accepted is 0 … " +
             std::to_string(mesh.point_count() - 1));
    }
  }
}

void check_field(const Field& field, int64_t count, const char* where) {
  const std::string name = std::string(where) + " \"" + field.name + "\"";
  if (field.name.empty() || field.name.find_first_of("/.") != std::string::npos) {
    throw std::invalid_argument(name + ": accepted is a name without '/' and '.'");
  }
  if (field.values.rows() < 1 || field.values.cols() != count) {
    throw std::invalid_argument(name + ": " + std::to_string(field.values.rows()) + " x " +
                                std::to_string(field.values.cols()) + " values, accepted is components x " +
                                std::to_string(count));
  }
}

/// Group, name and components of every field.
std::vector<std::pair<std::string, Eigen::Index>> layout_of(const FieldSnapshot& snapshot) {
  std::vector<std::pair<std::string, Eigen::Index>> layout;
  for (const Field& field : snapshot.point_data) layout.emplace_back("point " + field.name, field.values.rows());
  for (const Field& field : snapshot.cell_data) layout.emplace_back("cell " + field.name, field.values.rows());
  return layout;
}

}  // namespace

/// The layout of [Kitware 2025], "UnstructuredGrid" and "Temporal Data", one partition a mesh.
class FieldFile::Writer {
 public:
  explicit Writer(const fs::path& path) : atomic_(path), file_(atomic_) {
    file_.make_group(root);
    file_.set(root, "Type", "UnstructuredGrid");
    file_.set(root, "Version", {1, 0});
    for (const char* name : {"/PointData", "/CellData"}) file_.make_group(root + name);
  }

  void mesh(const FieldMesh& mesh) {
    step_.point += points_;
    step_.polygon += polygons_;
    step_.connectivity += indices_;
    ++step_.mesh;
    points_ = mesh.point_count();
    polygons_ = mesh.polygon_count();
    indices_ = static_cast<int64_t>(mesh.connectivity.size());
    row("/NumberOfPoints", points_);
    row("/NumberOfCells", polygons_);
    row("/NumberOfConnectivityIds", indices_);
    Eigen::MatrixXd places = Eigen::MatrixXd::Zero(3, points_);
    places.topRows<2>() = mesh.points;
    file_.append(root + "/Points", numbers(places), 3);
    file_.append(root + "/Connectivity", mesh.connectivity);
    file_.append(root + "/Offsets", mesh.offsets);
    file_.append(root + "/Types", std::vector(static_cast<std::size_t>(polygons_), vtk_polygon));
  }

  void snapshot(double time, const FieldSnapshot& snapshot) {
    step_.time = time;
    for (const Field& field : snapshot.point_data) values("/PointData/", field);
    for (const Field& field : snapshot.cell_data) values("/CellData/", field);
    if (++written_ == 1) {
      first_ = step_;
    } else {
      if (written_ == 2) begin_steps(snapshot);
      write(step_, snapshot);
    }
    step_.point_data += points_;
    step_.cell_data += polygons_;
  }

  void commit() {
    file_.close();
    atomic_.commit();
  }

 private:
  void row(const std::string& path, int64_t value) { file_.append(root + path, std::span<const int64_t>(&value, 1)); }

  void values(const char* group, const Field& field) {
    file_.append(root + group + field.name, numbers(field.values), static_cast<int>(field.values.rows()));
  }

  /// With its second snapshot the file gets a history.
  void begin_steps(const FieldSnapshot& snapshot) {
    file_.set(root, "Version", {2, 0});
    file_.make_group(root + "/Steps");
    for (const char* name : {"/Steps/PointDataOffsets", "/Steps/CellDataOffsets"}) file_.make_group(root + name);
    write(first_, snapshot);
  }

  void write(const Step& step, const FieldSnapshot& snapshot) {
    file_.append(root + "/Steps/Values", std::span<const double>(&step.time, 1));
    row("/Steps/NumberOfParts", 1);
    row("/Steps/PartOffsets", step.mesh);
    row("/Steps/PointOffsets", step.point);
    row("/Steps/CellOffsets", step.polygon);
    row("/Steps/ConnectivityIdOffsets", step.connectivity);
    for (const Field& field : snapshot.point_data) row("/Steps/PointDataOffsets/" + field.name, step.point_data);
    for (const Field& field : snapshot.cell_data) row("/Steps/CellDataOffsets/" + field.name, step.cell_data);
    file_.set(root + "/Steps", "NSteps", written_);
  }

  AtomicFile atomic_;
  Hdf5File file_;
  Step step_, first_;
  int64_t points_ = 0, polygons_ = 0, indices_ = 0;  // of the present mesh
  int64_t written_ = 0;                              // snapshots
};

FieldFile::FieldFile(fs::path file) : path_(std::move(file)) {}

FieldFile::~FieldFile() = default;

void FieldFile::require_open() const {
  if (!open_) throw std::logic_error(path_.string() + ": nothing can be written after an error or a commit");
}

void FieldFile::begin_mesh(FieldMesh mesh) {
  require_open();
  check_mesh(mesh);
  points_ = mesh.point_count();
  polygons_ = mesh.polygon_count();
  waiting_ = std::move(mesh);
}

void FieldFile::check(double time, const FieldSnapshot& snapshot) const {
  if (points_ < 0) throw std::invalid_argument("mesh: none was begun before the first snapshot");
  if (!std::isfinite(time) || (snapshot_count_ > 0 && time <= last_time_)) {
    throw std::invalid_argument("time = " + std::to_string(time) + ", accepted is a number > " +
                                (snapshot_count_ > 0 ? std::to_string(last_time_) : "-infinity"));
  }
  for (const Field& field : snapshot.point_data) check_field(field, points_, "point data");
  for (const Field& field : snapshot.cell_data) check_field(field, polygons_, "cell data");
  if (snapshot_count_ > 0 && layout_of(snapshot) != layout_) {
    throw std::invalid_argument("snapshot: other fields than in the first one; accepted are the same, in their order");
  }
}

void FieldFile::append(double time, const FieldSnapshot& snapshot) {
  require_open();
  check(time, snapshot);
  open_ = false;
  try {
    if (!writer_) {
      if (path_.has_parent_path()) fs::create_directories(path_.parent_path());
      writer_ = std::make_unique<Writer>(path_);
    }
    if (waiting_) writer_->mesh(*waiting_);
    writer_->snapshot(time, snapshot);
  } catch (...) {
    writer_.reset();
    throw;
  }
  open_ = true;
  waiting_.reset();
  layout_ = layout_of(snapshot);
  last_time_ = time;
  ++snapshot_count_;
}

void FieldFile::commit() {
  require_open();
  open_ = false;
  if (!writer_) return;
  writer_->commit();
  writer_.reset();
}

}  // namespace sunder::results
