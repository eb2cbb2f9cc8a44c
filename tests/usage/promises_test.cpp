// What docs/stability.md promises of names and labels: tests/data/promised has those of version 1.
#include <filesystem>

#include "cases.hpp"

namespace changeover::test::promises_test {
namespace {

std::set<std::string> promised(const std::string& file) {
  const auto lines = lines_of(slurp(CHANGEOVER_TEST_DATA "/promised/" + file));
  return {lines.begin(), lines.end()};
}

// The elements of `these` that are not in `those`, one a line.
std::string beyond(const std::set<std::string>& these, const std::set<std::string>& those) {
  std::string words;
  for (const std::string& one : these) {
    words += those.contains(one) ? "" : one + "\n";
  }
  return words;
}

// A line for each verb, argument, name of an option, and exit code.
std::set<std::string> names_of_the_program(const nlohmann::json& program) {
  std::set<std::string> names;
  for (const auto& code : program["exit_codes"]) {
    names.insert("exit code " + code["code"].dump());
  }
  for (const auto& verb : program["verbs"]) {
    const auto typed = verb["typed"].get<std::string>();
    names.insert(typed);
    for (const auto& argument : verb["arguments"]) {
      names.insert(typed + " " + argument["name"].get<std::string>());
    }
    for (const auto& option : verb["options"]) {
      for (const auto& name : option["names"]) {
        names.insert(typed + " " + name.get<std::string>());
      }
    }
  }
  return names;
}

TEST(Promises, NamesOfTheCommandLineStay) {
  const TemporaryFolder folder;
  const auto now = names_of_the_program(
      nlohmann::json::parse(run("$changeover describe --json", folder.path()).out));
  const auto before = promised("command_line.txt");
  EXPECT_EQ(beyond(before, now), "") << "these names are promised, and are gone";
  EXPECT_EQ(beyond(now, before), "") << "add these new names to command_line.txt";
}

TEST(Promises, LabelsStay) {
  const TemporaryFolder folder;
  std::set<std::string> now;
  for (const std::string& line :
       lines_of(run("$changeover catalog list --all", folder.path()).out)) {
    now.insert(line.substr(0, line.find(' ')));
  }
  const auto before = promised("labels.txt");
  EXPECT_GT(before.size(), 200U);
  EXPECT_EQ(beyond(before, now), "") << "these labels are promised, and are gone";
}

// A request that version 1.0 showed is read, and shown as it was: no key is lost.
TEST(Promises, RequestsOfVersion1AreRead) {
  const TemporaryFolder folder;
  std::size_t read = 0;
  for (const auto& file : std::filesystem::directory_iterator(CHANGEOVER_TEST_DATA "/promised")) {
    if (file.path().extension() != ".json") {
      continue;
    }
    const std::string stem = file.path().stem();
    const std::string verb = stem.substr(0, stem.find('-'));
    const auto said =
        run("$changeover " + verb + " --request '" + file.path().string() + "' --show-request",
            folder.path());
    EXPECT_EQ(said.code, 0) << stem << ": " << said.err;
    EXPECT_EQ(said.out, slurp(file.path())) << stem;
    ++read;
  }
  EXPECT_EQ(read, 7U);
}

}  // namespace
}  // namespace changeover::test::promises_test
