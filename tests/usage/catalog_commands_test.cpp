// The commands that the catalog credits its designs to: none is refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "cases.hpp"

namespace changeover::test::catalog_commands_test {
namespace {

// C(n,2).
std::uint64_t pairs(std::uint64_t n) { return n * (n - 1) / 2; }

TEST(CatalogCommands, AreAcceptedAndSearchForWhatTheDesignIs) {
  const TemporaryFolder folder;
  const std::string lines =
      run("$changeover catalog export | grep '\"command\":\"changeover search'", folder.path()).out;
  // One command of each form: its numbers do not decide what options go together.
  std::map<std::string, std::string> forms;
  for (const std::string& line : lines_of(lines)) {
    const auto entry = nlohmann::json::parse(line);
    const auto& design = entry["recipe"];
    const std::string command = entry["credit"]["command"];
    if (design["kind"] == "circular" && command.find(" --tight") != std::string::npos &&
        command.find(" --strength") == std::string::npos) {
      const std::uint64_t k = design["k"];
      const std::uint64_t m = design["change"];
      const std::uint64_t newly_covered = m * (k - m) + pairs(m);
      EXPECT_EQ(entry["b"].get<std::uint64_t>() * newly_covered, pairs(design["v"])) << command;
    }
    static const std::regex number("\\b[0-9]+(s|m|h)?\\b");
    if (command.find(';') != std::string::npos) {
      continue;  // it says in words what came after it
    }
    forms.try_emplace(std::regex_replace(command, number, "#"), command);
  }
  EXPECT_GE(forms.size(), 12U);
  for (const auto& [form, command] : forms) {
    static const std::regex time(" --time [0-9a-z]+");
    static const std::regex place("DIR");
    std::string typed = std::regex_replace(command, time, "");
    typed = std::regex_replace(typed, place, folder.path().string() + "/proof");
    const Outcome outcome = run("$" + typed + " --time 10ms --quiet", folder.path());
    EXPECT_TRUE(outcome.code == 10 || outcome.code == 20 || outcome.code == 30) << command << '\n'
                                                                                << outcome.err;
  }
}

}  // namespace
}  // namespace changeover::test::catalog_commands_test
