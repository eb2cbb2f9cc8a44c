// Files that a released version wrote are read (docs/stability.md).
#include <filesystem>

#include "cases.hpp"

namespace changeover::test::old_files_test {
namespace {

TEST(OldFiles, OfVersion0_1AreRead) {
  const TemporaryFolder folder;
  std::filesystem::copy(CHANGEOVER_TEST_DATA "/written_by_0.1", folder.path(),
                        std::filesystem::copy_options::recursive);
  expect(
      {{"$changeover verify design.json", 0, "valid: circular DCCD(15,5) with 15 blocks"},
       {"$changeover verify labels.txt", 0, "valid: circular DCCD(8,5) with 5 blocks"},
       {"$changeover verify design.csv --change 1 --linear", 0, "valid: linear SCCD(20,5)"},
       {"$changeover verify design.g --circular", 0, "valid: circular DCCD(26,4)"},
       {"$changeover verify design.sage --circular", 0, "valid: circular DCCD(26,4)"},
       {"$changeover verify design.xml --circular", 0, "valid: circular DCCD(26,4)"},
       {"$changeover catalog show 4.3.1.linear.3.fdc879cf --catalog catalog.db", 0, "by hand"},
       {"$changeover catalog verify --users --catalog catalog.db", 0, "1 of 1 design built"},
       {"$changeover catalog import catalog.jsonl --catalog new.db", 0, "1 design"},
       {"$changeover minima --data minima.csv --v 6 -o minima.md && grep -c '' minima.md >/dev/null "
        "&& grep -m 1 Minima minima.md",
        0, "# Minima"},
       {"$changeover search 30 6 --checkpoint search.checkpoint --time 100ms --threads 1 --quiet "
        "--json",
        30, "\"b\":"},
       {"$changeover plan parts.csv -k 3 --test-cost 2 --slot x=1,y=1..2 --done sheet.csv "
        "--steps 100 --quiet",
        0, "tests"},
       {"$changeover plan parts.csv -k 3 --test-cost 2 --slot x=1,y=1..2 --done sheet.xlsx "
        "--steps 100 --quiet",
        0, "tests"}},
      folder);
}

// The keys of documents that 0.1 wrote are still there, and mean the same.
TEST(OldFiles, DocumentsKeepTheirKeys) {
  const TemporaryFolder folder;
  std::filesystem::copy(CHANGEOVER_TEST_DATA "/written_by_0.1", folder.path(),
                        std::filesystem::copy_options::recursive);
  const auto keys_of = [](const nlohmann::json& document) {
    std::set<std::string> keys;
    for (const auto& [key, value] : document.items()) {
      keys.insert(key);
      if (value.is_array() && !value.empty() && value.front().is_object()) {
        for (const auto& [inner, ignored] : value.front().items()) {
          keys.insert(key + "[]." + inner);
        }
      }
    }
    return keys;
  };
  const auto missing = [&](const std::string& old_text, const std::string& new_text) {
    std::string gone;
    const std::set<std::string> now = keys_of(nlohmann::json::parse(new_text));
    for (const std::string& key : keys_of(nlohmann::json::parse(old_text))) {
      gone += now.contains(key) ? "" : " " + key;
    }
    return gone;
  };
  const auto first_line = [](const std::string& text) { return text.substr(0, text.find('\n')); };
  const auto said = [&](const std::string& command) { return run(command, folder.path()).out; };
  EXPECT_EQ(missing(slurp(folder.file("design.json")), said("$changeover design 15 5 --json")), "");
  EXPECT_EQ(
      missing(slurp(folder.file("plan.json")),
              said("$changeover plan parts.csv -k 3 --test-cost 2 --slot x=1,y=1..2 --steps 200 "
                   "--quiet --json")),
      "");
  EXPECT_EQ(missing(first_line(slurp(folder.file("loads.jsonl"))),
                    first_line(said("$changeover loadorder --items 20 --room 5 --json --quiet"))),
            "");
}

}  // namespace
}  // namespace changeover::test::old_files_test
