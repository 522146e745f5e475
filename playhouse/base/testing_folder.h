#pragma once

/// TestFolder: a folder of one test's own, removed with it. ctest runs the tests of a fixture side by side,
/// each in a process of its own, so a fixed name under TempDir() would be shared by them.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace playhouse {

class TestFolder {
 public:
  TestFolder() {
    std::string name = testing::TempDir() + "playhouse_test_XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("no folder can be made in " + testing::TempDir());
    path_ = name;
  }
  ~TestFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace playhouse
