#pragma once
/// results.h5: fields on meshes of polygons at several instants, as a VTKHDF unstructured grid [Kitware 2025], which
/// ParaView opens.
///
/// A mesh is written once and serves all snapshots that follow; a crack that grows brings a new mesh. Snapshots go to
/// the disk one by one. A file with one snapshot is VTKHDF 1.0, which old readers know as well (VTK 9.1); from the
/// second on it is 2.0 with the group `Steps`, before which VTK 9.1 warns: it shows the first snapshot alone. The same
/// values give the same bytes.

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sunder::results {

struct FieldMesh {
  Eigen::Matrix2Xd points;                  ///< (2, points) [m]
  std::vector<std::int64_t> offsets = {0};  ///< (polygons + 1), from 0, ascending: where each begins in `connectivity`
  std::vector<std::int64_t> connectivity;   ///< points of each polygon, counter-clockwise

  std::int64_t point_count() const { return points.cols(); }
  std::int64_t polygon_count() const { return static_cast<std::int64_t>(offsets.size()) - 1; }
};

struct Field {
  std::string name;        ///< without '/' and '.'
  Eigen::MatrixXd values;  ///< (components, points or polygons), SI. Three components are a vector, six a symmetric
                           ///< tensor xx, yy, zz, xy, yz, xz. What is not finite is written as it is.
};

struct FieldSnapshot {
  std::vector<Field> point_data, cell_data;
};

/// Appears under its name whole or not at all (AtomicFile). Folder and temporary file are made by the first `append`:
/// a run that comes to nothing before it leaves nothing. Throws std::filesystem::filesystem_error with the system's
/// reason where the file cannot be written; it is then given up, and every further call throws std::logic_error.
class FieldFile {
 public:
  explicit FieldFile(std::filesystem::path file);
  ~FieldFile();  ///< without `commit()`: nothing is left
  FieldFile(const FieldFile&) = delete;
  FieldFile& operator=(const FieldFile&) = delete;

  /// The mesh of the snapshots that follow. Throws std::invalid_argument where offsets or indices are out of range.
  void begin_mesh(FieldMesh mesh);

  /// `time` [s], or the number of a mode: greater than that of the snapshot before. The first snapshot says which
  /// fields there are; all others have the same, in the same order. Throws std::invalid_argument, with nothing
  /// written, where that is not so, where a field does not fit the mesh or where there is no mesh.
  void append(double time, const FieldSnapshot& snapshot);

  int snapshot_count() const { return snapshot_count_; }
  const std::filesystem::path& path() const { return path_; }

  /// Gives the file its name, where there is a snapshot in it. Once, and nothing is written after it.
  void commit();

 private:
  class Writer;
  void require_open() const;
  void check(double time, const FieldSnapshot& snapshot) const;

  std::filesystem::path path_;
  std::unique_ptr<Writer> writer_;
  std::optional<FieldMesh> waiting_;          // goes to the disk with the next snapshot
  std::int64_t points_ = -1, polygons_ = -1;  // of the present mesh
  std::vector<std::pair<std::string, Eigen::Index>> layout_;
  int snapshot_count_ = 0;
  double last_time_ = 0.0;
  bool open_ = true;
};

}  // namespace sunder::results
