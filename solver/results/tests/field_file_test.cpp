// Files are read back with the plain C interface, as the VTKHDF specification says a reader finds a step.
#include "solver/results/field_file.hpp"

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>

namespace sunder::results {
namespace {

namespace fs = std::filesystem;

/// A file of HDF5, read.
class Reading {
 public:
  explicit Reading(const fs::path& file) : file_(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
  ~Reading() { H5Fclose(file_); }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  bool has(const std::string& path) const { return H5Lexists(file_, ("/VTKHDF/" + path).c_str(), H5P_DEFAULT) > 0; }

  std::vector<hsize_t> shape(const std::string& path) const {
    const hid_t data = H5Dopen2(file_, ("/VTKHDF/" + path).c_str(), H5P_DEFAULT), space = H5Dget_space(data);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    H5Sclose(space);
    H5Dclose(data);
    return sizes;
  }

  template <typename T>
  std::vector<T> all(const std::string& path) const {
    std::size_t count = 1;
    for (const hsize_t size : shape(path)) count *= size;
    std::vector<T> values(count);
    const hid_t data = H5Dopen2(file_, ("/VTKHDF/" + path).c_str(), H5P_DEFAULT);
    const hid_t type = std::is_same_v<T, double> ? H5T_NATIVE_DOUBLE : H5T_NATIVE_INT64;
    EXPECT_GE(H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << path;
    H5Dclose(data);
    return values;
  }

  std::int64_t entry(const std::string& path, int i) const {
    return all<std::int64_t>(path).at(static_cast<std::size_t>(i));
  }

  /// The integers of an attribute of a group.
  std::vector<std::int64_t> attribute(const std::string& group, const char* name, std::size_t count) const {
    std::vector<std::int64_t> values(count);
    const hid_t at = H5Aopen_by_name(file_, group.c_str(), name, H5P_DEFAULT, H5P_DEFAULT);
    EXPECT_GE(H5Aread(at, H5T_NATIVE_INT64, values.data()), 0);
    H5Aclose(at);
    return values;
  }

  hid_t id() const { return file_; }

 private:
  hid_t file_;
};

template <typename T>
std::vector<T> part(const std::vector<T>& all, std::int64_t from, std::int64_t count) {
  return {all.begin() + from, all.begin() + from + count};
}

struct Seen {
  std::vector<double> points, displacement, stress;
  std::vector<std::int64_t> offsets, connectivity, types;
};

/// Step `i` by the offsets of the group Steps: Offsets has one entry more a part than there are cells.
Seen step_of(const Reading& file, int i) {
  const std::int64_t mesh = file.entry("Steps/PartOffsets", i), point = file.entry("Steps/PointOffsets", i);
  const std::int64_t cell = file.entry("Steps/CellOffsets", i), index = file.entry("Steps/ConnectivityIdOffsets", i);
  const std::int64_t points = file.entry("NumberOfPoints", static_cast<int>(mesh));
  const std::int64_t cells = file.entry("NumberOfCells", static_cast<int>(mesh));
  const std::int64_t indices = file.entry("NumberOfConnectivityIds", static_cast<int>(mesh));
  EXPECT_EQ(file.entry("Steps/NumberOfParts", i), 1);
  return {.points = part(file.all<double>("Points"), 3 * point, 3 * points),
          .displacement = part(file.all<double>("PointData/displacement"),
                               3 * file.entry("Steps/PointDataOffsets/displacement", i), 3 * points),
          .stress = part(file.all<double>("CellData/stress"), file.entry("Steps/CellDataOffsets/stress", i), cells),
          .offsets = part(file.all<std::int64_t>("Offsets"), cell + mesh, cells + 1),
          .connectivity = part(file.all<std::int64_t>("Connectivity"), index, indices),
          .types = part(file.all<std::int64_t>("Types"), cell, cells)};
}

class FieldFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "sunder-fields-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()); }
  static std::string bytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

/// Two squares side by side.
FieldMesh squares() {
  FieldMesh mesh;
  mesh.points.resize(2, 6);
  mesh.points << 0, 1, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1;
  mesh.offsets = {0, 4, 8};
  mesh.connectivity = {0, 1, 4, 3, 1, 2, 5, 4};
  return mesh;
}

/// The first of them and a pentagon, after a cut.
FieldMesh after_growth() {
  FieldMesh mesh;
  mesh.points.resize(2, 8);
  mesh.points << 0, 1, 2, 0, 1, 2, 1.5, 1, 0, 0, 0, 1, 1, 1, 0.5, 0.5;
  mesh.offsets = {0, 4, 9, 12};
  mesh.connectivity = {0, 1, 4, 3, 1, 2, 5, 6, 7, 5, 4, 7};
  return mesh;
}

FieldSnapshot snapshot_of(const FieldMesh& mesh, double value) {
  const auto ramp = [value](int components, std::int64_t count) {
    Eigen::MatrixXd values(components, count);
    for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = value + 0.1 * static_cast<double>(i);
    return values;
  };
  return {.point_data = {{"displacement", ramp(3, mesh.point_count())}},
          .cell_data = {{"stress", ramp(1, mesh.polygon_count())}}};
}

TEST_F(FieldFileTest, OneSnapshotIsAGridOfTheFirstVersionThatOldReadersOpen) {
  const FieldMesh mesh = squares();
  const FieldSnapshot snapshot = snapshot_of(mesh, 0.25);
  FieldFile file(folder_ / "made" / "results.h5");
  file.begin_mesh(mesh);
  EXPECT_FALSE(fs::exists(folder_ / "made")) << "before the first snapshot nothing is made";
  file.append(0.0, snapshot);
  EXPECT_FALSE(fs::exists(file.path())) << "before commit() the name is not there";
  file.commit();

  const Reading reading(file.path());
  EXPECT_EQ(reading.attribute("/VTKHDF", "Version", 2), (std::vector<std::int64_t>{1, 0}));
  const hid_t type = H5Aopen_by_name(reading.id(), "/VTKHDF", "Type", H5P_DEFAULT, H5P_DEFAULT),
              kind = H5Aget_type(type);
  char word[17] = {};
  EXPECT_EQ(H5Tget_class(kind), H5T_STRING);
  EXPECT_FALSE(H5Tis_variable_str(kind));
  EXPECT_EQ(H5Tget_cset(kind), H5T_CSET_ASCII);
  EXPECT_EQ(H5Tget_size(kind), 16u);
  EXPECT_GE(H5Aread(type, kind, word), 0);
  EXPECT_STREQ(word, "UnstructuredGrid");
  H5Tclose(kind);
  H5Aclose(type);

  EXPECT_FALSE(reading.has("Steps"));
  EXPECT_EQ(reading.all<std::int64_t>("NumberOfPoints"), std::vector<std::int64_t>{6});
  EXPECT_EQ(reading.all<std::int64_t>("NumberOfCells"), std::vector<std::int64_t>{2});
  EXPECT_EQ(reading.all<std::int64_t>("NumberOfConnectivityIds"), std::vector<std::int64_t>{8});
  EXPECT_EQ(reading.all<std::int64_t>("Connectivity"), mesh.connectivity);
  EXPECT_EQ(reading.all<std::int64_t>("Offsets"), mesh.offsets);
  EXPECT_EQ(reading.all<std::int64_t>("Types"), (std::vector<std::int64_t>{7, 7})) << "VTK_POLYGON";
  EXPECT_EQ(reading.shape("Points"), (std::vector<hsize_t>{6, 3}));
  EXPECT_EQ(part(reading.all<double>("Points"), 15, 3), (std::vector<double>{2, 1, 0}));
  EXPECT_EQ(reading.shape("PointData/displacement"), (std::vector<hsize_t>{6, 3})) << "three components: a vector";
  EXPECT_EQ(reading.shape("CellData/stress"), std::vector<hsize_t>{2});
  const double* written = snapshot.point_data[0].values.data();
  EXPECT_EQ(reading.all<double>("PointData/displacement"), std::vector<double>(written, written + 18));
}

TEST_F(FieldFileTest, EveryStepIsFoundByItsOffsetsAlsoWhereTheMeshChanges) {
  const FieldMesh before = squares(), after = after_growth();
  FieldFile file(folder_ / "results.h5");
  file.begin_mesh(before);
  file.append(0.0, snapshot_of(before, 0.0));
  file.append(0.5, snapshot_of(before, 1.0));
  file.begin_mesh(before);  // a mesh that no snapshot sees leaves no trace
  file.begin_mesh(after);
  file.append(1.0, snapshot_of(after, 2.0));
  file.append(1.5, snapshot_of(after, 3.0));
  EXPECT_EQ(file.snapshot_count(), 4);
  file.commit();

  const Reading reading(file.path());
  EXPECT_EQ(reading.attribute("/VTKHDF", "Version", 2), (std::vector<std::int64_t>{2, 0}));
  EXPECT_EQ(reading.attribute("/VTKHDF/Steps", "NSteps", 1), std::vector<std::int64_t>{4});
  EXPECT_EQ(reading.all<double>("Steps/Values"), (std::vector<double>{0.0, 0.5, 1.0, 1.5}));
  EXPECT_EQ(reading.shape("NumberOfPoints"), std::vector<hsize_t>{2}) << "each mesh is written once";
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const FieldMesh& mesh = i < 2 ? before : after;
    const FieldSnapshot written = snapshot_of(mesh, i);
    const Seen seen = step_of(reading, i);
    EXPECT_EQ(seen.connectivity, mesh.connectivity);
    EXPECT_EQ(seen.offsets, mesh.offsets);
    EXPECT_EQ(seen.types, std::vector<std::int64_t>(mesh.offsets.size() - 1, 7));
    for (Eigen::Index p = 0; p < mesh.points.cols(); ++p) {
      EXPECT_EQ(part(seen.points, 3 * p, 3), (std::vector<double>{mesh.points(0, p), mesh.points(1, p), 0.0}));
    }
    const Eigen::MatrixXd &u = written.point_data[0].values, &s = written.cell_data[0].values;
    EXPECT_EQ(seen.displacement, std::vector<double>(u.data(), u.data() + u.size()));
    EXPECT_EQ(seen.stress, std::vector<double>(s.data(), s.data() + s.size()));
  }
}

TEST_F(FieldFileTest, IsTheSameBytesEachTime) {
  for (const char* name : {"first.h5", "second.h5"}) {
    FieldFile file(folder_ / name);
    file.begin_mesh(squares());
    for (int i = 0; i < 40; ++i) file.append(i, snapshot_of(squares(), i));  // more than one chunk of steps
    file.commit();
  }
  const std::string first = bytes(folder_ / "first.h5");
  EXPECT_FALSE(first.empty());
  EXPECT_TRUE(first == bytes(folder_ / "second.h5"));
}

TEST_F(FieldFileTest, LeavesNothingWithoutCommitAndKeepsTheEarlierFile) {
  std::ofstream(folder_ / "results.h5") << "earlier";
  {
    FieldFile file(folder_ / "results.h5");
    file.begin_mesh(squares());
    file.append(0.0, snapshot_of(squares(), 0.0));
  }
  EXPECT_EQ(bytes(folder_ / "results.h5"), "earlier");
  EXPECT_EQ(entries(), 1);
}

TEST_F(FieldFileTest, LeavesNoFileWhereThereIsNoSnapshot) {
  FieldFile file(folder_ / "none" / "results.h5");
  file.begin_mesh(squares());
  file.commit();
  EXPECT_EQ(entries(), 0);
}

TEST_F(FieldFileTest, LeavesNoHalfFileUnderItsNameWhereTheProgramIsKilled) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    FieldFile file(folder_ / "results.h5");
    file.begin_mesh(squares());
    file.append(0.0, snapshot_of(squares(), 0.0));
    ::raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_FALSE(fs::exists(folder_ / "results.h5"));
}

// A disk that is full fails in `write`, as does a file that has reached the limit of its size.
TEST_F(FieldFileTest, SaysWhyWhereTheDiskTakesNoMoreAndLeavesNothing) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const rlimit limit = {.rlim_cur = 4'000'000, .rlim_max = 4'000'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
    int problems = 1;
    try {
      FieldFile file(folder_ / "results.h5");
      try {
        FieldMesh mesh = squares();
        mesh.points = Eigen::Matrix2Xd::Random(2, 5000);
        file.begin_mesh(mesh);
        for (int i = 0; i < 100; ++i) {
          FieldSnapshot snapshot = snapshot_of(mesh, 0.0);
          snapshot.point_data[0].values.setRandom();
          file.append(i, snapshot);
        }
      } catch (const fs::filesystem_error& error) {
        const std::string said = error.what();
        problems = said.find("results.h5") == std::string::npos || said.find("File too large") == std::string::npos;
        if (problems != 0) std::fprintf(stderr, "%s\n", error.what());
        try {
          file.append(1000.0, snapshot_of(squares(), 0.0));
          problems += 2;
        } catch (const std::logic_error&) {
        }
      }
    } catch (...) {
      problems += 4;
    }
    ::exit(problems);  // with what the library does at exit
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(entries(), 0);
}

TEST_F(FieldFileTest, RefusesAFolderThatIsAFile) {
  std::ofstream(folder_ / "taken") << "x";
  FieldFile file(folder_ / "taken" / "results.h5");
  file.begin_mesh(squares());
  EXPECT_THROW(file.append(0.0, snapshot_of(squares(), 0.0)), fs::filesystem_error);
}

struct Wrong {
  const char* description;
  void (*act)(FieldFile&);
  const char* said;
};

TEST_F(FieldFileTest, RefusesWhatDoesNotFit) {
  const Wrong cases[] = {
      {"an index beyond the points",
       [](FieldFile& file) {
         FieldMesh mesh = squares();
         mesh.connectivity[5] = 6;
         file.begin_mesh(mesh);
       },
       "mesh.connectivity[5] = 6, accepted is 0 … 5"},
      {"offsets that end too early",
       [](FieldFile& file) {
         FieldMesh mesh = squares();
         mesh.offsets.back() = 7;
         file.begin_mesh(mesh);
       },
       "mesh.offsets"},
      {"offsets that fall",
       [](FieldFile& file) {
         FieldMesh mesh = squares();
         mesh.offsets = {0, 9, 8};
         file.begin_mesh(mesh);
       },
       "mesh.offsets[2]: falls"},
      {"a time that does not advance", [](FieldFile& file) { file.append(0.0, snapshot_of(squares(), 0.0)); },
       "accepted is a number > 0"},
      {"a time that is none",
       [](FieldFile& file) { file.append(std::numeric_limits<double>::quiet_NaN(), snapshot_of(squares(), 0.0)); },
       "time = nan"},
      {"other fields than before",
       [](FieldFile& file) {
         FieldSnapshot snapshot = snapshot_of(squares(), 0.0);
         snapshot.cell_data.clear();
         file.append(1.0, snapshot);
       },
       "snapshot: other fields"},
      {"a field of another mesh", [](FieldFile& file) { file.append(1.0, snapshot_of(after_growth(), 0.0)); },
       "point data \"displacement\": 3 x 8 values, accepted is components x 6"},
      {"a name that is a path",
       [](FieldFile& file) {
         FieldSnapshot snapshot = snapshot_of(squares(), 0.0);
         snapshot.cell_data[0].name = "a/b";
         file.append(1.0, snapshot);
       },
       "cell data \"a/b\""},
  };
  FieldFile file(folder_ / "results.h5");
  EXPECT_THROW(file.append(0.0, {}), std::invalid_argument) << "no mesh yet";
  file.begin_mesh(squares());
  file.append(0.0, snapshot_of(squares(), 0.0));
  for (const Wrong& wrong : cases) {
    try {
      wrong.act(file);
      ADD_FAILURE() << wrong.description << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(wrong.said), std::string::npos)
          << wrong.description << ": " << error.what();
    }
  }
  file.append(1.0, snapshot_of(squares(), 1.0));  // nothing of it has harmed the file
  file.commit();
  EXPECT_EQ(Reading(folder_ / "results.h5").shape("Steps/Values"), std::vector<hsize_t>{2});
  EXPECT_THROW(file.append(2.0, snapshot_of(squares(), 2.0)), std::logic_error);
}

}  // namespace
}  // namespace sunder::results
