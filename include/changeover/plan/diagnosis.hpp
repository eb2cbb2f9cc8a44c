// What the results of tests say about one fault, and which tests tell apart what is left.
//
//     Diagnosis found = diagnose(job, {{{0, 1, 2}, true}, {{0, 3, 4}, false}});
//     for (const Suspect& suspect : found.suspects) {  // parts 1 and 2, three pairs
//       std::cout << in_words(suspect, job.names) << '\n';
//     }
//
// A *suspect* is a part, or a pair of parts that do not work together. It explains the results by itself if every test
// that failed had all of it, and none that passed had. If none does, the results need two faults at least. Where a set-up that failed is
// the same as one that passed, or part of it, no faults explain that, however many: the fault comes and goes, or a result is wrong.
//
// The next tests are a tree: what is tested next if a test fails, and if it passes. Each is chosen so that what is
// sure to be learned for its cost is the most: with n suspects left, of which at most m stay whatever the result, that is
// log(n/m) for the cost of the test and of its changes. Up to 12 parts of suspects all choices among them are
// looked at, else some thousands. Tests obey the room, the slots, forbidden pairs and what stays mounted; suspects
// that no such test tells apart stay together.
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

  bool operator==(const Suspect&) const = default;
};

/// "Motor", or "Motor with Pump".
[[nodiscard]] std::string in_words(const Suspect& suspect, const std::vector<std::string>& names);

/// A test to be made after some results.
struct NextTest {
  std::vector<bool> after;  ///< of the tests before it in the tree: whether they failed
  Block setup;
  Block take_out;
  Block put_in;
  Amount cost;
  std::vector<Suspect> if_it_fails;
  std::vector<Suspect> if_it_passes;
};

/// What was written as the result of a test and says neither.
struct UnreadResult {
  std::string place;  ///< "sheet.csv:4:9"
  std::string text;
};

struct Diagnosis {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;
  std::vector<Suspect> suspects;  ///< that explain all by themselves: parts, then pairs
  std::vector<std::pair<Suspect, Suspect>>
      two;  ///< if there is none: two that do together, at most 100
  std::vector<std::pair<Block, Block>>
      contradictions;  ///< what failed, and what passed though it had all of it; at most 10
  std::vector<NextTest> tests;             ///< a test before those that come after it; at most 1000
  Amount most_cost;                        ///< of the tests that are made, whatever the results
  std::uint64_t unread = 0;                ///< results that say neither; diagnose() leaves it at 0
  std::vector<UnreadResult> first_unread;  ///< the first of them; diagnose() leaves it empty
  std::vector<std::string>
      notes;  ///< what was not taken into account, a line each; diagnose() leaves it empty
};

/// Nothing is suspect if no test failed. @throws BadInput as check(Job) for anything but needed pairs, which do not matter;
/// for a tested set-up that names a part twice or none of the parts. ImpossibleParameters if costs overflow. Stopped if the
/// scope of this thread (run/control.hpp) wants to stop.
[[nodiscard]] Diagnosis diagnose(const Job& job, const std::vector<TestedSetup>& tests);

/// "table" for a terminal of so many columns, or "json", one line: format "changeover-diagnosis/1", passed, failed, unread, first_unread
/// [{place, result}], suspects [[part] or [part, part]], two [[suspect, suspect]], contradictions [{failed, passed}], tests [{after
/// ["fail" or "pass"], set_up, take_out, put_in, cost, if_it_fails, if_it_passes}], most_cost. @throws BadOption for another
/// format.
[[nodiscard]] std::string written(const Job& job, const Diagnosis& found, std::string_view format,
                                  std::size_t width = 80);

}  // namespace changeover
