// How a work is named in a sentence or a picture: docs/references.bib as a person reads it.
#include "construct/references.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace changeover::references_test {
namespace {

// The keys of all works, read by other means than the library's.
std::vector<std::string> keys_of_file() {
  std::ifstream file(CHANGEOVER_TEST_DATA "/../../docs/references.bib");
  std::vector<std::string> keys;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('@')) {
      const std::size_t brace = line.find('{');
      keys.push_back(line.substr(brace + 1, line.find(',') - brace - 1));
    }
  }
  return keys;
}

TEST(References, NamesKeepTheirAccents) {
  EXPECT_EQ(spoken_work("Furedi1981"), "Füredi 1981");
  EXPECT_EQ(spoken_work("Kaiser1997"), "Kaiser 1997");
  EXPECT_EQ(spoken_work("AharoniKaiserZerbib2017"), "Aharoni, Kaiser and Zerbib");
  EXPECT_EQ(spoken_work("Schonheim1964"), "Schönheim 1964");
}

TEST(References, TitlesKeepWhatTheySay) {
  EXPECT_EQ(title_of_work("Tardos1995"), "Transversals of 2-Intervals, a Topological Approach");
  EXPECT_EQ(spoken_work("NoSuchWork"), "");
  EXPECT_EQ(title_of_work("NoSuchWork"), "");
}

// Each accent of the first author's family name is a letter of Unicode in what is said.
TEST(References, EveryAccentOfAFirstNameIsShown) {
  const std::vector<std::string> keys = keys_of_file();
  ASSERT_GT(keys.size(), 40U);
  for (const std::string& key : keys) {
    const std::string entry = bibtex_of(key);
    ASSERT_FALSE(entry.empty()) << key;
    const std::size_t from = entry.find("author");
    const std::string family = entry.substr(from, entry.find_first_of(",\n", from) - from);
    const std::string spoken = spoken_work(key);
    const auto beyond_ascii =
        std::ranges::count_if(spoken, [](char c) { return (c & '\xC0') == '\xC0'; });
    EXPECT_GE(beyond_ascii, std::ranges::count(family, '\\')) << key << ": " << spoken;
  }
}

}  // namespace
}  // namespace changeover::references_test
