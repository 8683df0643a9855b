#include "solver/results/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>

namespace sunder::results {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, removed afterwards.
class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "sunder-atomic-XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string content(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, MakesTheFolderAndLeavesOneFile) {
  const fs::path file = folder_ / "a" / "b" / "summary.json";
  write_atomically(file, "whole");
  EXPECT_EQ(content(file), "whole");
  EXPECT_EQ(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()), 1);
}

TEST_F(AtomicFileTest, ReplacesAnEarlierFile) {
  write_atomically(folder_ / "summary.json", "a long first version");
  write_atomically(folder_ / "summary.json", "second");
  EXPECT_EQ(content(folder_ / "summary.json"), "second");
}

TEST_F(AtomicFileTest, IsReadableLikeAnyOtherFile) {
  write_atomically(folder_ / "summary.json", "");
  std::ofstream(folder_ / "plain") << "";
  EXPECT_EQ(fs::status(folder_ / "summary.json").permissions(), fs::status(folder_ / "plain").permissions());
}

TEST_F(AtomicFileTest, LeavesNothingWithoutCommit) {
  {
    AtomicFile file(folder_ / "history.csv");
    file.write("half");
    EXPECT_FALSE(fs::exists(folder_ / "history.csv"));
  }
  EXPECT_EQ(files(), 0u);
}

TEST_F(AtomicFileTest, KeepsTheEarlierFileWhereTheNewOneIsAbandoned) {
  write_atomically(folder_ / "summary.json", "first");
  { AtomicFile(folder_ / "summary.json").write("half"); }
  EXPECT_EQ(content(folder_ / "summary.json"), "first");
}

TEST_F(AtomicFileTest, LeavesNoHalfFileUnderItsNameWhereTheProgramIsKilled) {
  const fs::path file = folder_ / "summary.json";
  write_atomically(file, "first");
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    AtomicFile half(file);
    half.write("half of the sec");
    ::raise(SIGKILL);
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(content(file), "first");
}

TEST_F(AtomicFileTest, NamesTheFileWhereTheFolderIsMissing) {
  try {
    AtomicFile file(folder_ / "missing" / "summary.json");
    FAIL() << "a file without a folder was accepted";
  } catch (const fs::filesystem_error& error) {
    EXPECT_NE(std::string(error.what()).find("summary.json"), std::string::npos);
  }
}

TEST_F(AtomicFileTest, RefusesAFolderThatIsAFile) {
  std::ofstream(folder_ / "taken") << "x";
  EXPECT_THROW(write_atomically(folder_ / "taken" / "summary.json", "x"), fs::filesystem_error);
}

}  // namespace
}  // namespace sunder::results
