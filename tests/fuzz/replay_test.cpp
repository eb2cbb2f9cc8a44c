// Every file of fuzz/corpus goes to its target, and what the target promises holds. A crash that
// was mended stays there as a file.
#include <gtest/gtest.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "support/target.hpp"

namespace changeover::fuzz::replay_test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 50;
constexpr std::size_t most_bytes = 200'000;

fs::path corpora() { return fs::path(CHANGEOVER_FUZZ) / "corpus"; }

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

class Replay : public ::testing::TestWithParam<std::string> {};

TEST_P(Replay, KeepsItsPromises) {
  const auto target = std::ranges::find(Target::all(), GetParam(), &Target::name);
  ASSERT_NE(target, Target::all().end());
  const std::vector<fs::path> files = files_in(corpora() / GetParam());
  ASSERT_FALSE(files.empty()) << "no file of this kind is kept";
  EXPECT_LE(files.size(), most_files);
  std::size_t bytes = 0;
  for (const fs::path& path : files) {
    std::ifstream in(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    bytes += text.size();
    try {
      (*target)(text);
    } catch (const Broken& broken) {
      ADD_FAILURE() << path << ": broken: " << broken.promise;
    } catch (const std::exception& fault) {
      ADD_FAILURE() << path << ": thrown: " << fault.what();
    }
  }
  EXPECT_LE(bytes, most_bytes);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Target& target : Target::all()) {
    all.push_back(target.name());
  }
  std::ranges::sort(all);
  return all;
}

// Called when the tests begin, and not before all targets are there.
INSTANTIATE_TEST_SUITE_P(Of, Replay, ::testing::ValuesIn(names()),
                         [](const auto& name) { return name.param; });

TEST(Corpora, EachFolderAndDictionaryHasATarget) {
  std::set<std::string> targets;
  for (const Target& target : Target::all()) {
    EXPECT_TRUE(targets.insert(target.name()).second) << target.name() << " is there twice";
  }
  std::set<std::string> sources;
  for (const fs::path& path : files_in(CHANGEOVER_FUZZ)) {
    if (const std::string stem = path.stem().string();
        path.extension() == ".cpp" && stem.ends_with("_fuzz")) {
      sources.insert(stem.substr(0, stem.size() - 5));
    }
  }
  EXPECT_EQ(targets, sources);
  for (const fs::path& path : files_in(corpora())) {
    EXPECT_TRUE(targets.contains(path.filename().string())) << path;
  }
  for (const fs::path& path : files_in(fs::path(CHANGEOVER_FUZZ) / "dictionaries")) {
    EXPECT_TRUE(targets.contains(path.stem().string())) << path;
  }
}

}  // namespace
}  // namespace changeover::fuzz::replay_test
