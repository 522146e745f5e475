#pragma once

/// TestFolder: a temporary folder of one test, removed in the destructor. ctest runs tests
/// of a fixture in parallel processes, which would share a fixed name under TempDir().

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
