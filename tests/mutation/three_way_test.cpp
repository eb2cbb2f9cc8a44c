// The verifier, checkdesign and the definition word by word say the same of every file: the
// verdict, the counts, and whether there is anything to judge at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <sstream>

#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/verify/verdict.hpp"
#include "naive_verdict.hpp"
#include "run_program.hpp"

namespace changeover::test::three_way_test {
namespace {

/// What a verifier says in one line, or "refused".
std::string said(bool valid, std::uint64_t b, std::uint64_t uncovered, std::uint64_t bad_steps,
                 std::uint64_t excess, std::uint64_t never, std::uint64_t fixed) {
  std::ostringstream line;
  line << (valid ? "valid" : "invalid") << " blocks " << b << " uncovered " << uncovered
       << " bad-steps " << bad_steps << " excess " << excess << " never-newly-covered " << never
       << " fixed " << fixed;
  return line.str();
}

std::optional<Design> design_in(const std::string& text) {
  try {
    return read_text(input_from_text(text, "f"));
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

std::string verifier_says(const std::optional<Design>& design) {
  if (!design) {
    return "refused";
  }
  const Verdict v = verify(*design);
  return said(v.valid(), v.b, v.uncovered, v.bad_steps, v.excess, v.never_newly_covered,
              v.fixed.size());
}

std::string definition_says(const std::optional<Design>& design) {
  if (!design) {
    return "refused";
  }
  const NaiveVerdict v = naive_verdict(*design);
  const auto b = design->block_count();
  return said(v.valid, b, v.uncovered, v.bad_steps, v.excess, v.never_newly_covered,
              static_cast<std::uint64_t>(std::count(v.blocks.begin(), v.blocks.end(), b)));
}

/// From the exit code and the report of checkdesign.
std::string checkdesign_says(int code, const std::string& report) {
  if (code == 3) {
    return "refused";
  }
  if (code != 0 && code != 1) {
    return "exit code " + std::to_string(code);
  }
  std::istringstream lines(report);
  std::string line;
  std::getline(lines, line);
  std::ostringstream result;
  result << line;
  if ((line == "valid") != (code == 0)) {
    result << " with exit code " << code;
  }
  while (std::getline(lines, line)) {
    for (const std::string key :
         {"blocks", "uncovered", "bad-steps", "excess", "never-newly-covered", "fixed"}) {
      if (line.starts_with(key + " ")) {
        result << " " << line;
      }
    }
  }
  return result.str();
}

/// Files with a full header: walks that keep some elements for ever, blocks that share nothing with
/// the one before, more change and strength than a block has elements, one and two blocks.
std::string random_file(std::mt19937& random) {
  const auto below = [&](std::uint64_t n) { return static_cast<std::uint64_t>(random() % n); };
  const std::uint64_t v = 1 + below(9);
  const std::uint64_t k = 1 + below(v);
  const std::uint64_t change = 1 + below(below(5) == 0 ? k + 2 : std::max<std::uint64_t>(1, k / 2));
  const std::uint64_t strength =
      2 + below(below(4) == 0 ? 3 : std::clamp<std::uint64_t>(k - 1, 1, 3));
  const std::uint64_t b = 1 + below(below(3) == 0 ? 2 : 14);
  const std::uint64_t fixed = below(3) == 0 ? below(k + 1) : 0;
  std::ostringstream text;
  text << "# changeover design v=" << v << " k=" << k << " change=" << change
       << " kind=" << (below(2) == 0 ? "linear" : "circular") << " strength=" << strength << "\n";
  std::vector<std::uint64_t> elements(v);
  std::iota(elements.begin(), elements.end(), std::uint64_t{0});
  std::shuffle(elements.begin(), elements.end(), random);
  const bool walks = below(3) != 0;
  for (std::uint64_t i = 0; i < b; ++i) {
    // The block is the first k; those before `fixed` never move.
    for (std::uint64_t j = walks ? change : k; j > 0 && fixed < k && k < v; --j) {
      std::swap(elements[fixed + below(k - fixed)], elements[k + below(v - k)]);
    }
    for (std::uint64_t j = 0; j < k; ++j) {
      text << elements[j] << (j + 1 < k ? " " : "\n");
    }
  }
  return text.str();
}

/// Changes bytes below the header.
std::string mutated_below_header(std::string text, std::mt19937& random) {
  const std::size_t header = text.find('\n') + 1;
  const std::string odd = "\n\t #0123456789a,\"\x1b\x7f\xff\xc2\x9b";
  for (auto changes = 1 + random() % 3; changes > 0 && text.size() > header; --changes) {
    const std::size_t at = header + random() % (text.size() - header);
    switch (random() % 4) {
      case 0:
        text[at] = odd[random() % odd.size()];
        break;
      case 1:
        text.erase(at, 1 + random() % 3);
        break;
      case 2:
        text.insert(at, 1, odd[random() % odd.size()]);
        break;
      default:
        text[at] = static_cast<char>('0' + random() % 9);
    }
  }
  return text;
}

void expect_three_way_agreement(std::uint32_t seed, int files,
                                const std::function<std::string(std::mt19937&)>& make) {
  std::mt19937 random(seed);
  const TemporaryFolder folder;
  std::vector<std::string> texts;
  for (int i = 0; i < files; ++i) {
    texts.push_back(make(random));
    spit(folder.file(std::to_string(i)), texts.back());
  }
  const Outcome outcome = run("for ((i = 0; i < " + std::to_string(files) +
                                  "; ++i)); do $checkdesign $i >$i.out 2>/dev/null; echo $?; done",
                              folder.path());
  std::istringstream codes(outcome.out);
  std::map<std::string, int> kinds;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    int code = -1;
    ASSERT_TRUE(codes >> code) << outcome.err;
    const std::optional<Design> design = design_in(texts[i]);
    const std::string verdict = verifier_says(design);
    ++kinds[verdict.substr(0, verdict.find(' '))];
    EXPECT_EQ(verdict, definition_says(design)) << texts[i];
    EXPECT_EQ(verdict, checkdesign_says(code, slurp(folder.file(std::to_string(i) + ".out"))))
        << texts[i];
  }
  EXPECT_GT(kinds["valid"], 0);
  EXPECT_GT(kinds["invalid"], files / 50);
  EXPECT_GT(kinds["refused"], 0);
}

TEST(ThreeWay, VerifierCheckdesignAndDefinitionAgreeOnRandomFiles) {
  expect_three_way_agreement(11, 600, random_file);
}

TEST(ThreeWay, TheyAgreeOnMutatedFiles) {
  expect_three_way_agreement(12, 600, [](std::mt19937& random) {
    return mutated_below_header(random_file(random), random);
  });
}

TEST(ThreeWay, TheyAgreeOnManyMoreFilesSlow) {
  expect_three_way_agreement(13, 8000, random_file);
  expect_three_way_agreement(14, 8000, [](std::mt19937& random) {
    return mutated_below_header(random_file(random), random);
  });
}

TEST(ThreeWay, PairsInEveryBlockOfACircularDesignAreNoExcess) {
  const TemporaryFolder folder;
  spit(folder.file("f"),
       "# changeover design v=6 k=5 change=1 kind=circular\n0 1 2 3 4\n0 1 2 3 5\n0 1 2 4 5\n");
  const Outcome outcome = run("$checkdesign f", folder.path());
  const std::optional<Design> design = design_in(slurp(folder.file("f")));
  ASSERT_TRUE(design);
  EXPECT_EQ(verify(*design).never_newly_covered, 3U);
  EXPECT_EQ(checkdesign_says(outcome.code, outcome.out), verifier_says(design));
}

TEST(ThreeWay, ALargerChangeOrStrengthThanABlockIsNoVerdict) {
  const TemporaryFolder folder;
  spit(folder.file("f"), "# changeover design v=4 k=2\n0 1\n2 3\n");
  spit(folder.file("change"), "# changeover design v=4 k=2 change=3\n0 1\n2 3\n");
  spit(folder.file("strength"), "# changeover design v=4 k=2 strength=3\n0 1\n2 3\n");
  for (const std::string program : {"$checkdesign", "$changeover verify"}) {
    EXPECT_EQ(run(program + " change", folder.path()).code, 3) << program;
    EXPECT_EQ(run(program + " strength", folder.path()).code, 3) << program;
    // From the command line it is not the file's fault.
    for (const std::string wrong : {"-m 3", "-m 0", "-t 3", "-t 9", "-v 0", "-k 0", "-v 70000"}) {
      const Outcome outcome = run(program + " " + wrong + " f", folder.path());
      EXPECT_EQ(outcome.code, 2) << program << " " << wrong << ": " << outcome.err;
    }
  }
}

TEST(ThreeWay, NothingFromAFileReachesTheTerminalUnescaped) {
  const TemporaryFolder folder;
  const std::string bad = "a\x1b[31m\xff\x07";
  spit(folder.file(bad), "0 1\n0 0\n");
  spit(folder.file("f"), "x\u009b\u202e \xff\n");
  for (const std::string program : {"$checkdesign", "$changeover verify"}) {
    for (const std::string& file : {bad, std::string("f"), "absent" + bad}) {
      const Outcome outcome = run(program + " '" + file + "'", folder.path());
      EXPECT_TRUE(outcome.code == 3 || outcome.code == 4) << outcome.err;
      EXPECT_EQ(outcome.err.find_first_of("\x1b\x07\xff"), std::string::npos) << program;
      EXPECT_EQ(outcome.err.find("\u009b"), std::string::npos) << program;
      EXPECT_EQ(outcome.err.find("\u202e"), std::string::npos) << program;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
  }
}

TEST(ThreeWay, AFewHugeBlocksAreJudgedInGoodTime) {
  const TemporaryFolder folder;
  std::string all;
  for (int i = 0; i < 65'535; ++i) {
    all += std::to_string(i) + (i + 1 < 65'535 ? " " : "\n");
  }
  spit(folder.file("one"), "# changeover design v=65535\n" + all);
  for (const std::string program : {"$checkdesign", "$changeover verify"}) {
    EXPECT_EQ(run("timeout 120 " + program + " one", folder.path()).code, 0) << program;
  }
}

}  // namespace
}  // namespace changeover::test::three_way_test
