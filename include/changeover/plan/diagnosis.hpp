// Finds the faults that explain the results of tests, and the best test to run next.
//
//     Diagnosis found = diagnose(job, {{{0, 1, 2}, true}, {{0, 3, 4}, false}});
//     for (const Suspect& suspect : found.suspects) {  // parts 1 and 2, three pairs
//       std::cout << in_words(suspect, job.names) << '\n';
//     }
//     const Block test = found.next->setup;            // run it, add its result, and ask again
//
// A *suspect* is a part, or a pair of parts that do not work together. A passed test *clears* all
// parts and pairs in its set-up. Faults are assumed to be permanent: a test fails if, and only if,
// its set-up contains a fault. An *explanation* is a set of suspects that are not cleared, with at
// least one of them in each failed test, and with as few suspects as possible. If all parts and
// pairs of a failed test are cleared, no such faults explain it: the fault needs three parts, or is
// intermittent, or a result is wrong.
//
// A fault is *proven* by a failed test in which it is the only suspect. A part is also taken as
// proven if there are failed tests whose only suspects are the part and pairs that contain it, and
// no two of these pairs explain the tests: then the part is at fault, or at least three of its
// pairs are.
//
// The next test maximises the information that is gained for sure per cost. With n explanations
// left, at most m of them after either result, that is log(n/m) divided by the cost of the test and
// its changes; it is less if the test has suspects that are in no explanation. If one explanation
// is left, the next test proves or clears one of its faults. Up to 12 parts of suspects, all
// choices are compared; for more, hill climbing from several starts is used. Tests obey the room,
// the slots, forbidden pairs and what stays mounted; explanations that no such test can tell apart
// remain together. In the worst case, log2(n) tests are needed to find one of n explanations.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/plan/benches.hpp"

namespace changeover {

/// A test that was run, and whether it passed.
struct TestedSetup {
  Block setup;
  bool failed = false;
};

/// A part or a pair.
struct Suspect {
  Element one = 0;
  std::optional<Element> other = {};

  auto operator<=>(const Suspect&) const = default;
};

/// "Motor", or "Motor with Pump".
[[nodiscard]] std::string in_words(const Suspect& suspect, const std::vector<std::string>& names);

/// Suspects that together explain all failures, in increasing order.
using Explanation = std::vector<Suspect>;

/// The test to run next.
struct NextTest {
  Block setup;
  Block take_out;
  Block put_in;
  Amount cost;
  std::optional<Suspect> proves =
      {};  ///< the fault that this test proves if it fails, and clears if it passes
  std::vector<Explanation>
      if_it_fails;  ///< explanations that remain then, of those that are listed
  std::vector<Explanation> if_it_passes;  ///< likewise
};

/// An entry in the result column that is neither pass nor fail.
struct UnreadResult {
  std::string place;  ///< "sheet.csv:4:9"
  std::string text;
};

struct Diagnosis {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::vector<Suspect> faults;    ///< proven
  std::vector<Suspect> suspects;  ///< that explain everything alone: parts, then pairs
  std::uint64_t at_least = 0;     ///< the smallest number of faults that explain everything
  std::vector<Explanation>
      explanations;  ///< sets of this size, at most max_explanations if it is more than one
  bool all_explanations = true;  ///< whether the list is complete
  /// A failed test, if max_faults faults are not enough or too many sets had to be tried:
  /// `explanations` then has its suspects, each alone.
  std::optional<Block> looked_at;
  /// A failed test in which everything is cleared, and a passed test that contains it, or an empty
  /// set-up if none does; at most 10.
  std::vector<std::pair<Block, Block>> contradictions;
  std::optional<NextTest> next;  ///< nullopt if no test gives more information
  std::uint64_t least_tests =
      0;  ///< lower bound on the tests needed, in the worst case, to tell the explanations apart
  std::uint64_t unread = 0;  ///< number of results that are neither; diagnose() leaves it 0
  std::vector<UnreadResult> first_unread;  ///< some of them; diagnose() leaves it empty
  std::vector<std::string> notes;  ///< what was ignored, one per line; diagnose() leaves it empty
};

/// The limit for the number of faults that explain the results together, besides proven ones.
inline constexpr std::uint64_t max_faults = 3;
/// The limit for the number of listed explanations of more than one suspect.
inline constexpr std::size_t max_explanations = 5000;

/// Diagnoses the results; without a failed test there are no suspects. @throws BadInput as
/// check(Job), except for needed pairs, which are ignored; BadInput for a set-up with a repeated or
/// unknown part; ImpossibleParameters if costs overflow. Stopped if the scope of this thread
/// (run/control.hpp) requests it. Takes about a second for 100 parts and thousands of tests.
[[nodiscard]] Diagnosis diagnose(const Job& job, const std::vector<TestedSetup>& tests);

/// A diagnosis with the data that are written with it; all must outlive it.
struct DiagnosisDocument {
  const Job* job = nullptr;
  const Diagnosis* found = nullptr;
  std::vector<Block> rest =
      {};  ///< remaining set-ups of the current plan, which follow the next test in a workbook
  const DoneRecord* done = nullptr;        ///< as in SheetDocument
  std::vector<std::string> question = {};  ///< as in SheetDocument
  const BenchPlan* benches = nullptr;  ///< of several: what comes next on each, the next test too
  const Job* of_benches = nullptr;     ///< the job of all of them
  RequestList list = {};               ///< as in BenchDocument
};

/// Writes the diagnosis as "table" for a terminal of the given width, "markdown", "html", "xlsx" (a
/// run sheet with the next test to fill in), or "json" in one line: format
/// "changeover-diagnosis/1", passed, failed, unread, first_unread [{place, result}], faults [[part]
/// or [part, part]], suspects, at_least, explanations [[suspect]] (at most 100),
/// explanations_known, all_explanations, looked_at (or null), contradictions [{failed, passed (or
/// null)}], next {set_up, take_out, put_in, places, cost, proves (or null), why, if_it_fails {left,
/// explanations}, if_it_passes} (or null), least_tests, notes. @throws BadOption for another
/// format.
[[nodiscard]] std::string written(const DiagnosisDocument& document, std::string_view format,
                                  std::size_t width = 80);
[[nodiscard]] std::string written(const Job& job, const Diagnosis& found, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
