// What falsifies the print at one place, and looks whether the item there differs.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "changeover/construct/registry.hpp"
#include "paper/checks/checks.hpp"

namespace changeover::test {

using Section = std::vector<PaperItem> (*)(const PaperContext&);

inline std::vector<PaperItem> run(Section section, const Paper& paper) {
  return section({paper, Registry::standard(), {.largest_k = 13}});
}

// Items that differ or are refuted, with all that they say of it.
inline std::vector<PaperItem> differing(Section section, const Paper& paper) {
  std::vector<PaperItem> items = run(section, paper);
  std::erase_if(items, [](const PaperItem& item) { return item.findings.empty(); });
  return items;
}

// The same for the print as it is, once a section.
inline const std::vector<PaperItem>& differing(Section section) {
  static std::map<Section, std::vector<PaperItem>> known;
  const auto [place, added] = known.try_emplace(section);
  if (added) {
    place->second = differing(section, printed_paper());
  }
  return place->second;
}

inline std::string places(const std::vector<PaperItem>& items) {
  std::string text;
  for (const PaperItem& item : items) {
    text += item.place + ": " + item.what + '\n';
  }
  return text;
}

// The falsified print must give an item at `place`, about `what`, that differs and does not so
// otherwise.
inline void expect_found(Section section, const std::function<void(Paper&)>& falsify,
                         const std::string& place, const std::string& what = "") {
  Paper paper = printed_paper();
  falsify(paper);
  const std::vector<PaperItem>& before = differing(section);
  const std::vector<PaperItem> after = differing(section, paper);
  EXPECT_TRUE(std::any_of(after.begin(), after.end(),
                          [&](const PaperItem& item) {
                            return item.place == place &&
                                   item.what.find(what) != std::string::npos &&
                                   std::find(before.begin(), before.end(), item) == before.end();
                          }))
      << place << ' ' << what << "; differing:\n"
      << places(after);
}

inline PrintedTable& table_in(Paper& paper, const std::string& place) {
  const auto found = std::find_if(paper.tables.begin(), paper.tables.end(),
                                  [&](const PrintedTable& table) { return table.place == place; });
  return *found;
}

inline void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

}  // namespace changeover::test
