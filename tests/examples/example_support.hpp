// What the examples of the headers have around them: their own folder, and what they write to
// standard output.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "changeover/changeover.hpp"

namespace changeover::test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// An example that names files: it runs in a new folder, which goes with it.
class InAFolder : public testing::Test {
 protected:
  InAFolder() {
    std::string name = testing::TempDir() + "exampleXXXXXX";
    folder_ = ::mkdtemp(name.data());
    std::filesystem::current_path(folder_);
  }
  ~InAFolder() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }

  static void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  std::filesystem::path folder_;
};

/// The lines of an example of a format, which stand in the test with a line before them and four
/// blanks in front.
inline std::string without_margin(const std::string& text) {
  std::istringstream lines(text.substr(1));
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result += line.substr(std::min<std::size_t>(4, line.size())) + "\n";
  }
  return result;
}

/// What is written to standard output from here on, until it is taken.
class StandardOutput {
 public:
  StandardOutput() { testing::internal::CaptureStdout(); }
  [[nodiscard]] std::string take() { return testing::internal::GetCapturedStdout(); }
};

/// The tight circular DCCD(6,4) of many examples: {0,1,2,3}, {4,5,2,3}, {4,5,0,1}.
inline Design three_blocks() {
  return {Parameters{.v = 6, .k = 4, .kind = Kind::circular},
          std::vector<Block>{{0, 1, 2, 3}, {4, 5, 2, 3}, {4, 5, 0, 1}}};
}

/// The best design that the registry has.
inline Design best_design(const Parameters& p) {
  const Registry& registry = Registry::standard();
  return registry.build_design(registry.best(p).value().recipe);
}

}  // namespace changeover::test
