// A job of an experimenter: parts to be tested in pairs, room for some of them at a time, and the
// costs of a test and of a change.
//
//     // nine parts, three at a time
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
//     job.never.insert(2, 7);                 // these two must not meet …
//     job.needed = all_pairs_but(job.never);  // … and all others must
//     check(job);
//
// A *set-up* is a set of at most `at_once` parts that are mounted together and tested once. A list
// of set-ups does the job if every needed pair is in some set-up, no pair of `never` is in any, the
// `mounted` parts are in all, and the number of parts of each slot in each set-up is within the
// limits of the slot; at_once remains the limit for all parts. The list costs
//   (number of set-ups) · test_cost + Σ over all introductions of the change cost of the part,
// where a part is introduced in a set-up if it was not in the one before. The first set-up
// introduces all its parts except those of `start`, which are mounted already. Taking parts out
// costs nothing. These are the costs of [ChafeeStevens2025, Section 1].
//
// The cost of a change may depend on the part that is replaced (Job::replace_costs). Let a step
// take out the parts O and put in the parts N; for the first set-up, O are the removed parts of
// `start`. The parts are matched in min(|O|,|N|) pairs of one part of O and one of N so that the
// step is cheapest. A pair (o, n) costs replace_cost(o, n). The other parts of N go to empty
// places, each at its own change cost; the other parts of O are taken out at no cost. With slots, a
// part only takes the place of a part of the same slot, and likewise for parts in no slot. Such
// jobs have no plans for weighed pairs or exchanged parts: BadInput. A list that starts on an empty
// bench pays for its first set-up as without replacement costs.
//
// If some set-ups must come `first`, the list begins with them, in their order. They break no
// constraint, their pairs count, and they cost as much as others.
//
// In the job of a `model`, set-ups are its tests. A value replaces a value of the same parameter.
// In a test with a value out of range, only the pairs of that value count.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/pair_set.hpp"
#include "changeover/io/input.hpp"

namespace changeover {

// Costs, kept exactly: whole millionths of a unit, which is of money or of time.
//
//     const Amount test = parse_amount("1.25");
//     to_string(test * 12 + parse_amount("0.5"));        // "15.50"
//     to_string(parse_amount("3"));                      // "3"
//
// Sums and products are checked for overflow, so a total is exact or an exception.

/// An exact amount of money or time, never negative.
struct Amount {
  std::uint64_t millionths = 0;

  auto operator<=>(const Amount&) const = default;
};

/// The exact sum. @throws ImpossibleParameters if it exceeds 2⁶³ − 1 millionths, about 9.2·10¹²
/// units.
[[nodiscard]] Amount operator+(Amount a, Amount b);
/// The product. @throws as the sum.
[[nodiscard]] Amount operator*(Amount a, std::uint64_t times);
/// Adds b. @throws as the sum; a is then as it was.
inline Amount& operator+=(Amount& a, Amount b) { return a = a + b; }

/// a − b for b ≤ a. @throws BadOption if b is larger.
[[nodiscard]] Amount operator-(Amount a, Amount b);

/// Reads "12", "12.5", "0.000001", ".5": digits with at most one point and at most six decimals.
/// @throws BadInput with one line (without a place) for anything else, negative numbers included;
/// ImpossibleParameters if it is too large.
[[nodiscard]] Amount parse_amount(std::string_view text);

/// The number of decimals that shows the amount as money: 0 or 2, or up to 6 if it needs more.
[[nodiscard]] unsigned decimals_needed(Amount amount);

/// The amount with decimals_needed() decimals, or with more on request.
[[nodiscard]] std::string to_string(Amount amount, unsigned at_least_decimals = 0);

/// The limit for the number of parts of a job.
inline constexpr std::uint64_t max_parts = 1000;

/// A kind of parts, with limits for their number in every set-up: exactly one processor, two to
/// four disks.
struct Slot {
  std::string name;
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

  bool operator==(const Slot&) const = default;
};

/// A quantity without limit: one for every bench.
inline constexpr std::uint64_t enough_for_all = std::numeric_limits<std::uint64_t>::max();

/// The slot number of a part that is in no slot.
inline constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

/// A place on the bench, which holds one part at a time, if it has a slot, a part of that slot.
struct MountedPlace {
  std::uint64_t number = 0;          ///< from 1; `slot_3` on a sheet
  std::uint32_t slot = no_slot;      ///< the slot of its parts
  std::optional<Element> part = {};  ///< the part in it before the first test

  bool operator==(const MountedPlace&) const = default;
};

/// The unit of costs that are times; the sheet then shows a clock.
enum class CostUnit : std::uint8_t { none, seconds, minutes, hours };

/// The weights of pairs, 1 by default. Weights are exact decimals, like amounts.
class PairWeights {
 public:
  void set(Element x, Element y, Amount weight) { by_rank_[PairSet::rank(x, y)] = weight; }
  [[nodiscard]] Amount operator()(Element x, Element y) const {
    const auto found = by_rank_.find(PairSet::rank(x, y));
    return found == by_rank_.end() ? Amount{1'000'000} : found->second;
  }
  /// Whether the pair has its own weight.
  [[nodiscard]] bool weighs(Element x, Element y) const {
    return by_rank_.count(PairSet::rank(x, y)) != 0;
  }
  /// Whether no pair has its own weight.
  [[nodiscard]] bool empty() const { return by_rank_.empty(); }

 private:
  std::map<std::uint64_t, Amount> by_rank_;
};

/// The reasons why pairs are forbidden, if they are given.
class PairReasons {
 public:
  /// An empty reason removes it.
  void set(Element x, Element y, std::string why) {
    if (!why.empty()) {
      by_rank_[PairSet::rank(x, y)] = std::move(why);
    }
  }
  [[nodiscard]] const std::string& operator()(Element x, Element y) const {
    static const std::string none;
    const auto found = by_rank_.find(PairSet::rank(x, y));
    return found == by_rank_.end() ? none : found->second;
  }
  [[nodiscard]] bool empty() const { return by_rank_.empty(); }

 private:
  std::map<std::uint64_t, std::string> by_rank_;
};

/// Three parts, in increasing order.
using Triple = std::array<Element, 3>;

struct Model;  // plan/model.hpp

struct Job {
  std::vector<std::string> names;    ///< of the parts, which are the elements 0, 1, …
  std::uint64_t at_once = 0;         ///< most parts in a set-up
  Amount test_cost;                  ///< of running one test
  std::vector<Amount> change_costs;  ///< of mounting each part once
  PairSet needed{0};                 ///< pairs that must meet
  PairSet never{0};                  ///< pairs that must not be in the same set-up
  PairReasons why_never;             ///< reasons for these pairs; for display only
  std::vector<Slot> slots;           ///< if empty, any parts may be together
  std::vector<std::uint32_t>
      slot_of;    ///< by part: the number of its slot, or no_slot; empty without slots
  Block mounted;  ///< parts that are in every set-up
  Block start;    ///< parts that are mounted before the first test
  /// The known places of the bench; parts of the start that are in none of them take other places.
  std::vector<MountedPlace> places;
  CostUnit cost_unit = CostUnit::none;  ///< for display only
  std::vector<Element> piece_of;  ///< by part: the part of which it is a further piece, or itself;
                                  ///< empty if there are no pieces; for display only
  std::uint64_t tests_done = 0;   ///< number of earlier tests; only for numbering
  std::uint64_t last_step = 0;    ///< highest number of an earlier test, if they have numbers
  /// Pairs or triples that had to meet and met only in tests that did not pass (mark_tested()); for
  /// display only.
  std::uint64_t met_only_in_failed = 0;
  bool trust_failed = false;  ///< whether these count as tested; for display only
  PairWeights weights;        ///< of needed pairs: heavy pairs meet early, or first within a budget
  std::vector<Triple>
      triples;  ///< three parts that must meet in one set-up; increasing, without repetition
  bool asks_for_triples = false;  ///< also if none of them is left to test (need_triples())
  std::vector<Block> first;       ///< set-ups that must run first, in this order; their cost counts
  /// The cost of putting in part i where part o was taken out, at o · parts() + i; undefined if
  /// they are not of one slot. Empty: it is change_costs[i] for every o.
  std::vector<Amount> replace_costs;
  /// The model of the job: parts are its values, slots its parameters; every set-up follows its
  /// rules.
  std::shared_ptr<const Model> model;
  Block barred;  ///< values of the model that no set-up may have: a bench lacks them

  std::vector<std::uint64_t>
      quantities;  ///< by part: how many pieces several benches share, or enough_for_all;
                   ///< empty: one per bench

  /// Whether a part may take the place of another: both are of one slot, or both of none.
  [[nodiscard]] bool may_replace(Element out, Element in) const {
    return slots.empty() || slot_of[out] == slot_of[in];
  }
  /// Whether the cost of a change depends on what is replaced.
  [[nodiscard]] bool replaces() const { return !replace_costs.empty(); }
  /// The cost of putting in a part where another was taken out.
  [[nodiscard]] Amount replace_cost(Element out, Element in) const {
    return replaces() ? replace_costs[out * names.size() + in] : change_costs[in];
  }
  [[nodiscard]] std::uint64_t parts() const { return names.size(); }
  /// The number that the last earlier test has; new tests go on after it.
  [[nodiscard]] std::uint64_t steps_before() const {
    return tests_done < last_step ? last_step : tests_done;
  }
  /// The most parts that a set-up can have: at_once, or the number of parts if that is less.
  [[nodiscard]] std::uint64_t room() const { return at_once < parts() ? at_once : parts(); }
  /// Whether all change costs are the same, whatever is replaced.
  [[nodiscard]] bool one_change_cost() const;
};

/// Why a text cannot be used on a run sheet, as the name of a part or as a title: it is not UTF-8,
/// or has control characters or characters that change the writing direction, with which a sheet
/// could show something else than it contains. nullopt if it can be used.
[[nodiscard]] std::optional<std::string> text_defect(std::string_view text);

/// A job with v parts, named "1" to "v", of which `at_once` fit on the bench; all pairs must meet.
/// The costs are of one test and of putting one part in. check() refuses what cannot be done, such
/// as at_once = 0. @throws BadInput if v > max_parts. O(v).
[[nodiscard]] Job make_job(std::uint64_t v, std::uint64_t at_once, Amount test_cost,
                           Amount change_cost);

/// All pairs of elements except these. O(v²).
[[nodiscard]] PairSet all_pairs_but(const PairSet& pairs);

/// Assigns parts to slots: `of_parts` are the names of their slots, "" for those in none. @throws
/// BadInput if the number of names is wrong, and for a slot that is not listed; the job is then
/// unchanged.
void set_slots(Job& job, const std::vector<std::string>& of_parts, std::vector<Slot> slots);

/// Adds further pieces of parts, named "DIMM A #2" and so on, where a set-up may need several: a
/// part of a slot that needs at least n parts gets up to n pieces, limited by `quantities` (by
/// part). Pieces fill the slot and cost as much as the part, but have no needed pairs: testing one
/// piece is enough, and using equal pieces in another order saves nothing. A piece has the
/// forbidden pairs of its part; two pieces of a part may meet. Afterwards Job::quantities has, for
/// each piece, the number of benches that may have it at a time. Returns the number of added
/// pieces. @throws BadInput if a part has the name of a piece, or there are more than max_parts.
std::uint64_t add_pieces(Job& job, const std::vector<std::uint64_t>& quantities);

/// The needed pairs that no set-up can hold, because of the limits of slots; with forbidden pairs,
/// those for which no set-up was found among 100,000 choices. O(v³) without forbidden pairs.
/// Stopped if the scope of this thread (run/control.hpp) requests it.
[[nodiscard]] PairSet cannot_meet(const Job& job);

/// Removes pairs from the needed ones.
void drop_needed(Job& job, const PairSet& pairs);

/// Reasons why no list of set-ups can do the job, or why the job is malformed, one per line, at
/// most ten; empty if a list exists. The reasons are complete: without one, the job is done by one
/// set-up per needed pair, of the pair, the mounted parts and what the slots need. With slots and
/// forbidden pairs such a set-up is searched for among 100,000 choices. O(v³).
[[nodiscard]] std::vector<std::string> defects(const Job& job);

/// @throws BadInput with the first of defects() and how many more there are.
void check(const Job& job);

/// A job that passed check(). Only check() makes one, so a function that takes it need not check
/// again.
class CheckedJob {
 public:
  /// A job without parts: nothing has to meet.
  CheckedJob() = default;
  /// @throws BadInput as check(Job), with the same complexity.
  explicit CheckedJob(Job job);

  [[nodiscard]] const Job& operator*() const { return job_; }
  [[nodiscard]] const Job* operator->() const { return &job_; }

 private:
  friend class JobMaker;  // removes earlier tests from a checked job
  Job job_;
};

/// Removes the pairs of earlier tests from the needed ones. If the job has no start, the last test
/// becomes its start. A test may be larger than at_once, since more parts may have fitted when it
/// was done; the start then has as many of its parts as fit. @throws BadInput if a test has a
/// repeated or unknown part. O(v² + tests · at_once · v/64). Stopped if the scope of this thread
/// (run/control.hpp) requests it. After an exception the job is unchanged.
void mark_done(Job& job, const std::vector<Block>& setups);

/// The meaning of the result of a test.
enum class TestResult {
  none,     ///< nothing was written
  pass,     ///< all pairs of the set-up work together
  fail,     ///< something does not work
  done,     ///< the test was run, without a result: "done"
  not_run,  ///< the test was not run: "skipped", "blocked", "n/a"
  unread    ///< anything else: "smelled of smoke", "12.5"
};

/// Interprets a result as people write it, by its first word, in any case, in the languages of
/// docs/plan.md ("FAILED - hang", "n.i.O.", "réussi", "不合格", "✓"). A word of success that is
/// qualified later ("ok, but hot"), a number and a letter x are unread. O(length).
[[nodiscard]] TestResult result_of(std::string_view result);

/// A test that was run.
struct DoneTest {
  Block setup;
  TestResult result = TestResult::done;
  bool hidden = false;  ///< none of its pairs counts: the error of a value may have hidden them
};

/// What happens to pairs that met only in tests that did not pass.
enum class FailedTests {
  again,   ///< they are still needed
  trusted  ///< they count as tested
};

/// Like mark_done(), by results. Pairs of a test that passed, was done, or has no known result
/// (`none`) are no longer needed. Pairs that met only in tests that failed, or have an unread
/// result, are still needed, unless these tests are trusted; Job::met_only_in_failed has their
/// number (of triples, if these must meet). Tests that were not run are ignored. Of hidden tests
/// nothing counts but that they were done, last or not. @throws and complexity as mark_done().
void mark_tested(Job& job, const std::vector<DoneTest>& tests,
                 FailedTests failed = FailedTests::again);

/// The limit for the number of parts of a job in which triples have to meet.
inline constexpr std::uint64_t max_parts_of_triples = 100;

/// Replaces what is needed by all triples of parts that can be in one set-up, and their pairs.
/// Returns the number of triples that cannot meet, because of slots, forbidden pairs or mounted
/// parts. @throws BadInput for more than max_parts_of_triples parts. O(v³) without forbidden pairs.
/// Stopped if the scope of this thread requests it; the job is then unchanged.
std::uint64_t need_triples(Job& job);

/// The job that remains after its first set-ups: their pairs are no longer needed, and the last of
/// them is the start. The job itself if it has none. O(v² + pairs of the set-ups).
[[nodiscard]] Job after_first(const Job& job);

// The lists of an experimenter: parts with their change costs, pairs, and set-ups.
//
//     # bench.csv
//     component,change cost
//     Pump A,12.50
//     "Valve, large",8
//     Motor,3
//
//     # pairs.csv
//     Pump A,Motor
//     1,2
//
//     # done.csv
//     Pump A,Motor
//     2,3
//
// Files are rows of fields separated by commas, semicolons or tabs, whichever comes first outside
// quotes. A field may be quoted. Blank lines and lines that begin with # are ignored. A part is
// given by its name or by its number in the parts list, from 1; a name takes precedence.
//   - Parts: a name, and a change cost if there is a second field. With a header there may be other
//     columns; those for names, costs, slots and quantities are found by the words in the header
//     (internal: src/plan/job/parts/part_columns.hpp); a first row that may be a header or a part
//     is refused. With semicolons or tabs, costs may have a decimal
//     comma, if no cost in the list has a point.
//   - Pairs: two parts per row, or separated by blanks if the row is no part; a third field may
//     give a reason. A first row with two words that are column names of parts, and no parts, is a
//     header, and says which columns count.
//   - Set-ups: the parts of one set-up per row. The CSV of a run sheet (plan/run_plan.hpp) is read,
//     too: its columns slot_1, slot_2, …, or its column set_up with all parts in one field; its
//     columns result and bench; and its rows in their order.
// Each list may also be a sheet of a workbook (.xlsx), detected by its content: the first sheet, or
// the one that open_list() (io/input.hpp) names. Cells are taken as they are: no row is a comment,
// and names need no quotes. A number is read in full, a formula as its stored value, and a line end
// within a cell as a blank. Columns to the right of those that the header names are ignored. Places
// are given as `parts.xlsx:Costs!B3`.
//
// Lists are UTF-8; control characters and those that change the writing direction are refused. They
// are read line by line, with at most 16 MiB per line, 1 GiB and 4,194,304 rows in all. A violation
// is BadInput with one line: `NAME:LINE:COLUMN: what is wrong; how to mend it`.

/// Whether a parts list has a header.
enum class Header { guessed, given, none };

struct PartListOptions {
  Header header = Header::guessed;
  /// The name of the column of change costs, in any case, so there is a header; "-" if no column
  /// has costs. Empty: found by its words.
  std::string cost_column = {};
  /// Known slot names: if no column is named "slot", a column in which more than half of the fields
  /// are such names is taken.
  std::vector<std::string> slots = {};
  /// Whether "-" and "n/a" are no cost, as an empty field; else they are refused with their place.
  bool costs_may_lack = false;
};

struct PartList {
  std::vector<std::string> names;
  std::vector<std::optional<Amount>> change_costs;  ///< by part; nullopt if none is given
  std::vector<std::string>
      slots;  ///< by part: the name of its slot, or ""; empty if there is no such column
  std::vector<std::uint64_t>
      quantities;  ///< by part: the number of pieces, 1 by default; empty without a column
  CostUnit unit = CostUnit::none;  ///< of the change costs, if the list gives one
  std::string note;  ///< one line on how the list was interpreted, if that is worth telling
};

/// Reads the parts in the order of their rows. @throws BadInput for no part, an empty or repeated
/// name, an invalid cost, too many fields, a first row that may or may not be a header;
/// MissingResource if reading fails.
[[nodiscard]] PartList read_parts(Input& input, Header header = Header::guessed);
[[nodiscard]] PartList read_parts(Input& input, const PartListOptions& options);

/// Reads pairs, as elements below names.size(); repetitions are allowed. A third field is a reason,
/// which is kept in `why` if that is given; without a header it must not be a part. If `gone` is
/// given, rows of a file with unknown (removed) parts are left out, and each such name is added to
/// it once; a number, or a name that differs only in case, is still refused. @throws BadInput for
/// unknown parts, a part with itself, rows that are no pair; MissingResource if reading fails.
[[nodiscard]] PairSet read_pairs(Input& input, const std::vector<std::string>& names,
                                 PairReasons* why = nullptr,
                                 std::vector<std::string>* gone = nullptr);

/// Reads set-ups in order. @throws BadInput for unknown or repeated parts and for a set-up of more
/// than `at_once` parts; MissingResource if reading fails.
[[nodiscard]] std::vector<Block> read_setups(
    Input& input, const std::vector<std::string>& names,
    std::uint64_t at_once = std::numeric_limits<std::uint64_t>::max());

/// Reads pairs or set-ups of the parts of a job. Values of a model are given by their names or as
/// "Parameter: value", in any case, and have no numbers; the set-ups may have a first row of
/// parameter names, with values below.
[[nodiscard]] PairSet read_pairs(Input& input, const Job& job, PairReasons* why = nullptr);
[[nodiscard]] std::vector<Block> read_setups(Input& input, const Job& job);

/// Reads costs by what is replaced, for Job::replace_costs, from a square table. Its first row
/// names the parts that are put in, after an ignored field; every other row begins with the part
/// that is taken out. Each part heads one row and one column, in any order; the field of a part
/// with itself is empty. With slots (by part), fields for parts of two slots may be empty and are
/// 0. `gone` as in read_pairs(), for rows and columns. @throws BadInput for a part that heads no
/// row or column, or two; for unknown parts, invalid costs, and rows with too few or too many
/// fields; MissingResource if reading fails.
[[nodiscard]] std::vector<Amount> read_change_costs(Input& input,
                                                    const std::vector<std::string>& names,
                                                    const std::vector<std::uint32_t>& slot_of = {},
                                                    std::vector<std::string>* gone = nullptr);

/// Reads the weights of pairs, one row `A,B,weight` each; a header is recognised. `gone` as in
/// read_pairs(). @throws BadInput for other rows, negative weights and a pair with two weights;
/// MissingResource if reading fails.
[[nodiscard]] PairWeights read_priorities(Input& input, const std::vector<std::string>& names,
                                          std::vector<std::string>* gone = nullptr);

/// Reads set-ups that must come first in an otherwise complete job, for Job::first. In a model,
/// missing values of a set-up are chosen. @throws BadInput as read_setups(); for no set-up; and,
/// with its line, for a set-up that forbidden pairs, slots or mounted parts do not allow.
[[nodiscard]] std::vector<Block> read_first(Input& input, const Job& job);

/// A column of a run sheet for one place.
struct DonePlace {
  std::uint64_t number = 0;  ///< of the place: 3 for "slot_3 disk"
  std::string slot = {};     ///< "disk"; "" if the header has no slot
};

/// A set-up of a list of tests that were done.
struct DoneRow {
  Block setup;
  std::string result = {};  ///< as written; "" for none
  std::string unread = {};  ///< the place of the result if it is not understood, else ""
  std::string notes = {};
  std::string bench = {};  ///< as written; "" for none
  std::uint64_t line = 0;
  bool lacks = false;  ///< whether some of its parts are gone, or values of parameters that are
  /// As written, a value that was out of range and is now gone or in range; "" for none.
  std::string hidden_by = {};
  std::vector<std::optional<Element>> in_place = {};  ///< by place; nullopt: none, or it is gone
  std::vector<std::string> written = {};   ///< the same as written, including parts that are gone
  std::vector<std::string> gone = {};      ///< the names of its parts that are gone
  std::optional<std::uint64_t> step = {};  ///< its number on the sheet, if it has one
};

/// A list of tests that were done, possibly a run sheet of a parts list that has changed since.
struct DoneList {
  std::vector<DoneRow> rows;
  std::vector<DonePlace> places;  ///< of a run sheet with a column for each place; otherwise empty
  std::vector<std::string>
      gone;  ///< names on a run sheet that no part has any more, without repetition
  std::vector<std::string> notes;  ///< how it was read, where people may expect another way

  [[nodiscard]] bool has_results() const;
  [[nodiscard]] std::vector<Block> setups() const;
};

/// Tests that were done, as they are kept on a sheet.
struct DoneRecord {
  struct Test {
    std::vector<std::string> parts;  ///< by place, "" for an empty one; may be shorter than places
    std::string result;
    std::string notes;
    std::string bench = {};                  ///< on which it was, by name; "" if that is not known
    std::optional<std::uint64_t> step = {};  ///< its number where it was planned, if it had one
  };
  std::vector<DonePlace> places;
  std::vector<Test> tests;
};

/// Like read_setups(), but for a run sheet: parts that no longer exist are left out of the set-ups
/// and listed once. Numbers count as parts only if no name is a number. A name that differs from
/// one of a part only in case is refused. @throws as read_setups().
[[nodiscard]] DoneList read_done(Input& input, const std::vector<std::string>& names,
                                 std::uint64_t at_once = std::numeric_limits<std::uint64_t>::max());

/// Reads a run sheet as above, for the parts of a job; names are read as by read_setups().
[[nodiscard]] DoneList read_done(Input& input, const Job& job);

/// Reads slots with their limits, one row `slot,least,most` each; with a header of such words
/// ("slot", "min", "max", "quantity"), in any order. An empty field is no limit. @throws BadInput
/// for other rows and repeated slots; MissingResource if reading fails.
[[nodiscard]] std::vector<Slot> read_slots(Input& input);

/// Parses slots in one line, "CPU=1, disk=2..4, fan=..2". @throws BadInput (without a place).
[[nodiscard]] std::vector<Slot> parse_slots(std::string_view text);

/// Parses parts in one line, "Pump A, 3"; fields as in files. @throws BadInput (without a place)
/// for unknown or repeated parts.
[[nodiscard]] Block parse_parts(std::string_view text, const std::vector<std::string>& names);

/// Finds parts by name, or by number if no name is a number. @throws BadInput (without a place) for
/// unknown or repeated parts.
[[nodiscard]] Block parts_named(const std::vector<std::string>& words,
                                const std::vector<std::string>& names);

/// Finds parts of a job by name, or by number if no name is a number; values of a model as
/// read_pairs() reads them. @throws BadInput (without a place) for unknown or repeated parts.
[[nodiscard]] Block parts_named(const std::vector<std::string>& words, const Job& job);

/// The names of the parts in one line, which parse_parts() reads back.
[[nodiscard]] std::string parts_text(const Block& parts, const std::vector<std::string>& names);

}  // namespace changeover
