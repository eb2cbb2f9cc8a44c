// Command lines, each with its exit code and the words by which it says so.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "run_program.hpp"

namespace changeover::test {

/// Without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

struct Case {
  std::string command;
  int code = 0;
  std::string
      says;  ///< distinctive, so that a refusal for another reason is not taken for this one
};

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++times;
  }
  return times;
}

/// Without the lines of progress ("changeover: planning v = 9; 11 s", "…; 1:08 min") that a command
/// writes once it has taken ten seconds.
inline std::string without_progress(const std::string& err) {
  static const std::regex progress("changeover: .*; [0-9:]+ (s|min|h)\n");
  std::string rest;
  for (std::size_t at = 0; at < err.size();) {
    const std::size_t end = std::min(err.find('\n', at), err.size() - 1) + 1;
    const std::string line = err.substr(at, end - at);
    rest += std::regex_match(line, progress) ? "" : line;
    at = end;
  }
  return rest;
}

/// The exit codes of each verb's answers, as `changeover describe` has them: "catalog verify" ->
/// {0, 1, 30}.
inline const std::map<std::string, std::set<int>>& described_outcomes() {
  static const std::map<std::string, std::set<int>> all = [] {
    std::map<std::string, std::set<int>> codes;
    const TemporaryFolder folder;
    const auto described = nlohmann::json::parse(run("$changeover describe", folder.path()).out);
    for (const auto& verb : described.at("verbs")) {
      for (const auto& outcome : verb.at("outcomes")) {
        codes[verb.at("typed")].insert(outcome.at("code").get<int>());
      }
    }
    return codes;
  }();
  return all;
}

/// The verb of a line that runs changeover once and nothing else: "catalog verify"; empty
/// otherwise.
inline std::string only_verb(const std::string& command) {
  constexpr std::string_view program = "$changeover ";
  if (!command.starts_with(program) || command.find_first_of("|;&\n") != std::string::npos ||
      command.find("--help") != std::string::npos) {
    return {};
  }
  const std::string words = command.substr(program.size()) + " ";
  const std::string one = words.substr(0, words.find(' '));
  const std::string two =
      words.substr(0, words.find(' ', std::min(one.size() + 1, words.size() - 1)));
  return described_outcomes().contains(two)   ? two
         : described_outcomes().contains(one) ? one
                                              : std::string();
}

/// An answer is on standard output and nothing on stderr; a refusal is one clean line on stderr and
/// nothing else. That nothing serves some parameters (4) is an answer as well.
inline void expect(const std::vector<Case>& cases, const TemporaryFolder& folder) {
  for (const Case& each : cases) {
    if (each.command.find("/dev/full") != std::string::npos && !has_full_device()) {
      continue;
    }
    const Outcome outcome = run(each.command, folder.path());
    EXPECT_EQ(outcome.code, each.code) << each.command << "\n"
                                       << outcome.out.substr(0, 500) << outcome.err;
    const bool answers =
        each.code <= 1 || each.code >= 10 || (each.code == 4 && !outcome.out.empty());
    const std::string& said = answers ? outcome.out : outcome.err;
    EXPECT_TRUE(!each.says.empty() && said.find(each.says) != std::string::npos)
        << each.command << " should say '" << each.says << "' but says\n"
        << said.substr(0, 1000);
    EXPECT_EQ(answers ? without_progress(outcome.err) : outcome.out, "") << each.command;
    EXPECT_EQ(said.find('\x1b'), std::string::npos) << each.command;
    if (const std::string verb = only_verb(each.command);
        answers && each.code != 4 && !verb.empty()) {
      EXPECT_TRUE(described_outcomes().at(verb).contains(outcome.code))
          << each.command << ": the help of " << verb << " knows no exit code " << outcome.code;
    }
    if (!answers && each.command != "$changeover") {  // which shows the help
      EXPECT_EQ(count(without_progress(outcome.err), "\n"), 1U) << each.command << "\n"
                                                                << outcome.err;
    }
  }
}

/// Open MPI refuses to run as root, or with more processes than cores, unless told otherwise. It
/// leaves memory to modules that it has unloaded when it ends, of which a leak sanitizer cannot
/// even say where it was taken.
inline const std::string mpirun =
    "ASAN_OPTIONS=\"$ASAN_OPTIONS:detect_leaks=0\" "
    "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1 "
    "OMPI_MCA_btl_vader_single_copy_mechanism=none mpirun ";

/// Installed, and able to start processes: it needs a separate network and more.
inline bool have_mpirun(const TemporaryFolder& folder) {
  return run(mpirun + "-n 4 true", folder.path()).code == 0;
}

}  // namespace changeover::test
