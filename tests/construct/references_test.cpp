// How a work is named in a sentence or a picture: docs/references.bib as a person reads it.
#include "construct/references.hpp"

#include <gtest/gtest.h>

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
  EXPECT_EQ(find_work("Furedi1981")->name, "Füredi 1981");
  EXPECT_EQ(find_work("AharoniKaiserZerbib2017")->name, "Aharoni, Kaiser and Zerbib 2017");
  EXPECT_EQ(find_work("Schonheim1964")->name, "Schönheim 1964");
  EXPECT_EQ(find_work("NoSuchWork"), nullptr);
}

TEST(References, AreLinesOfAList) {
  EXPECT_EQ(find_work("ChafeeStevens2025")->text,
            "A. L. Chafee and B. Stevens. Recursive and Cyclic Constructions for Double-Change "
            "Covering Designs. Journal of Combinatorial Designs (2025)");
  EXPECT_EQ(find_work("PreeceEtAl1995")->text,
            "D. A. Preece et al. Tight Single-Change Covering Designs. Utilitas Mathematica 47, "
            "55–84 (1995)");
  EXPECT_TRUE(find_work("Nelder1969")->text.starts_with("J. A. Nelder. The earliest use of"));
}

// A DOI stays, preprints and pages may move.
TEST(References, AreReadAtTheirDoiElseTheirPreprintElseTheirPage) {
  EXPECT_EQ(find_work("ChafeeStevens2025")->url, "https://doi.org/10.1002/jcd.70000");
  EXPECT_EQ(find_work("ChafeeStevens2023")->url, "https://arxiv.org/abs/2209.11010");
  EXPECT_EQ(find_work("PreeceEtAl1995")->url, "https://opensiuc.lib.siu.edu/math_articles/134");
  EXPECT_EQ(find_work("McSorley1999")->url, "");
}

// Every entry of the bibliography has its words, and no command of TeX is left in them.
TEST(References, HaveWordsForEveryEntry) {
  const std::vector<std::string> keys = keys_of_file();
  ASSERT_GT(keys.size(), 40U);
  for (const std::string& key : keys) {
    EXPECT_FALSE(bibtex_of(key).empty()) << key;
    const Work* const work = find_work(key);
    ASSERT_NE(work, nullptr) << key;
    EXPECT_FALSE(work->name.empty()) << key;
    EXPECT_EQ((work->name + work->text).find_first_of("\\{}$"), std::string::npos) << key;
  }
}

}  // namespace
}  // namespace changeover::references_test
