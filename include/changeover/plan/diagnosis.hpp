// What the results of tests say about faults, and the one test to run next.
//
//     Diagnosis found = diagnose(job, {{{0, 1, 2}, true}, {{0, 3, 4}, false}});
//     for (const Suspect& suspect : found.suspects) {  // parts 1 and 2, three pairs
//       std::cout << in_words(suspect, job.names) << '\n';
//     }
//     const Block test = found.next->setup;            // run it, add its result, and ask again
//
// A *suspect* is a part, or a pair of parts that do not work together; it is *cleared* if a test
// passed that had all of it. Faults do not come and go: a test fails if, and only if, it has all of
// a fault. An *explanation* is a set of suspects that are not cleared, at least one of them in each
// test that failed, and no set of fewer suspects is one: results are explained by as few faults as
// can be. If a test failed all of whose parts and pairs are cleared, no such faults explain it:
// three parts are needed for the fault, or it comes and goes, or a result is wrong.
//
// A fault is *proven* by a test that failed and whose only suspect it is. A part is also taken for
// proven if tests failed all of whose suspects are the part and pairs of it, and no two of these
// pairs explain them: then it is at fault, or three of its pairs are.
//
// The next test is chosen so that what is sure to be learned for its cost is the most: with n
// explanations left, of which at most m stay whatever the result, that is log(n/m) for the cost of
// the test and of its changes, and less if the test has suspects that are in no explanation. If one
// explanation is left, the next test proves one of its faults, or clears it. Up to 12 parts of
// suspects all choices among them are looked at, else a climb from several beginnings. Tests obey
// the room, the slots, forbidden pairs and what stays mounted; explanations that no such test tells
// apart stay together. Of n explanations, no way to ask finds one with fewer than log2(n) tests at
// worst.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/plan/job.hpp"

namespace changeover {

/// A test that was done and told whether it passed.
struct TestedSetup {
  Block setup;
  bool failed = false;
};

/// A part, or a pair.
struct Suspect {
  Element one = 0;
  std::optional<Element> other = {};

  auto operator<=>(const Suspect&) const = default;
};

/// "Motor", or "Motor with Pump".
[[nodiscard]] std::string in_words(const Suspect& suspect, const std::vector<std::string>& names);

/// Suspects that explain together what failed; increasing.
using Explanation = std::vector<Suspect>;

/// The test to run next.
struct NextTest {
  Block setup;
  Block take_out;
  Block put_in;
  Amount cost;
  std::optional<Suspect> proves =
      {};  ///< if it fails, this is a fault beyond doubt; if it passes, it is none
  std::vector<Explanation> if_it_fails;   ///< those that are left then, of those that are known
  std::vector<Explanation> if_it_passes;  ///< likewise
};

/// What was written as the result of a test and says neither.
struct UnreadResult {
  std::string place;  ///< "sheet.csv:4:9"
  std::string text;
};

struct Diagnosis {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::vector<Suspect> faults;    ///< proven
  std::vector<Suspect> suspects;  ///< that explain all by themselves: parts, then pairs
  std::uint64_t at_least = 0;     ///< no fewer faults explain all together
  std::vector<Explanation>
      explanations;  ///< sets of so many, at most max_explanations if it is more than one
  bool all_explanations = true;  ///< there are no others
  /// If max_faults are not enough, or too many sets had to be tried: the test that failed whose
  /// suspects `explanations` are, each alone.
  std::optional<Block> looked_at;
  /// What failed though all of it is cleared, and a test that passed and had all of it, or nothing;
  /// at most 10.
  std::vector<std::pair<Block, Block>> contradictions;
  std::optional<NextTest> next;  ///< nothing if no test tells more
  std::uint64_t least_tests =
      0;                     ///< no way to ask needs fewer at worst to tell the explanations apart
  std::uint64_t unread = 0;  ///< results that say neither; diagnose() leaves it at 0
  std::vector<UnreadResult> first_unread;  ///< the first of them; diagnose() leaves it empty
  std::vector<std::string>
      notes;  ///< what was not taken into account, a line each; diagnose() leaves it empty
};

/// The most faults that are looked for together, besides those that are proven.
inline constexpr std::uint64_t max_faults = 3;
/// The most explanations that are listed, of more than one suspect.
inline constexpr std::size_t max_explanations = 5000;

/// Nothing is suspect if no test failed. @throws BadInput as check(Job) for anything but needed
/// pairs, which do not matter; for a tested set-up that names a part twice or none of the parts.
/// ImpossibleParameters if costs overflow. Stopped if the scope of this thread (run/control.hpp)
/// wants to stop. For 100 parts and thousands of tests within about a second.
[[nodiscard]] Diagnosis diagnose(const Job& job, const std::vector<TestedSetup>& tests);

/// A diagnosis with what is written around it; all must outlive it.
struct DiagnosisDocument {
  const Job* job = nullptr;
  const Diagnosis* found = nullptr;
  std::vector<Block> rest =
      {};  ///< of the plan that is under way: it comes after the next test in a workbook
  const DoneRecord* done = nullptr;        ///< as in SheetDocument
  std::vector<std::string> question = {};  ///< as in SheetDocument
};

/// "table" for a terminal of so many columns, "markdown", "html", "xlsx": a run sheet with the next
/// test to fill in, and "json", one line: format "changeover-diagnosis/1", passed, failed, unread,
/// first_unread [{place, result}], faults [[part] or [part, part]], suspects, at_least,
/// explanations [[suspect]] (at most 100), explanations_known, all_explanations, looked_at (or
/// null), contradictions [{failed, passed (or null)}], next {set_up, take_out, put_in, places,
/// cost, proves (or null), why, if_it_fails {left, explanations}, if_it_passes} (or null),
/// least_tests, notes. @throws BadOption for another format.
[[nodiscard]] std::string written(const DiagnosisDocument& document, std::string_view format,
                                  std::size_t width = 80);
[[nodiscard]] std::string written(const Job& job, const Diagnosis& found, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
