// What an experimenter wants: parts to be tested in pairs, room for some of them at once, and what
// a test and a change cost.
//
//     // nine parts, three at a time
//     Job job = make_job(9, 3, parse_amount("1"), parse_amount("5"));
//     job.never.insert(2, 7);                 // these two must not meet …
//     job.needed = all_pairs_but(job.never);  // … and all others must
//     check(job);
//
// A *set-up* is a set of at most `at_once` parts that are mounted together and tested once. A list
// of set-ups does the job if every needed pair is in some set-up, no pair of `never` is in any, the
// `mounted` parts are in all, and every set-up has of each slot no fewer parts than its least and
// no more than its most; at_once stays the room for all. It costs
//   (number of set-ups) · test_cost + Σ over all introductions of the change cost of the part,
// where a part is introduced in a set-up if it was not in the one before; the first set-up
// introduces all its parts but those of `start`, which are on the bench already. Taking parts out
// costs nothing. These are the costs of [ChafeeStevens2025, Section 1].
//
// If a change costs more or less by what is replaced (Job::replace_costs), a step is paid for by
// pairs. Let it take out the parts O and put in the parts N; for the first set-up, O are those of
// `start` that go. As many pairs of a part of O and one of N as there can be, min(|O|,|N|), no part
// in two, are chosen so that the step is cheapest: a pair (o, n) costs what putting in n costs
// where o was taken out; what is left of N goes to empty places, each at its own change cost; what
// is left of O is taken out at no cost. With slots, that is so in each slot by itself, and among
// the parts of no slot: a part takes the place of one of its own slot. Plans for weighed pairs,
// exchanged parts, ratios of costs and diagnoses are not made for such jobs: BadInput. So a list
// that begins on an empty bench pays for its first set-up as without such costs.
//
// If some set-ups must come `first`, the list begins with them, in
// their order: they break no constraint, their pairs count, and they are paid for like all others.
//
// If the job is that of a `model`, set-ups are its tests. A value replaces that of the same
// parameter, and of a test with a value that is out of range only the pairs with it count.
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

// Costs, kept exactly: whole millionths of a unit of money.
//
//     const Amount test = parse_amount("1.25");
//     to_string(test * 12 + parse_amount("0.5"));        // "15.50"
//     to_string(parse_amount("3"));                      // "3"
//
// Sums and products refuse to overflow, so a total is exact or it is not given.

/// An amount of money, never negative.
struct Amount {
  std::uint64_t millionths = 0;

  auto operator<=>(const Amount&) const = default;
};

/// The exact sum. @throws ImpossibleParameters if it exceeds 2⁶³ − 1 millionths, about 9.2·10¹²
/// units.
[[nodiscard]] Amount operator+(Amount a, Amount b);
/// The amount so many times. @throws as the sum.
[[nodiscard]] Amount operator*(Amount a, std::uint64_t times);
/// Adds b. @throws as the sum; a is then as it was.
inline Amount& operator+=(Amount& a, Amount b) { return a = a + b; }

/// a − b for b ≤ a. @throws InternalError if b is larger.
[[nodiscard]] Amount operator-(Amount a, Amount b);

/// Reads "12", "12.5", "0.000001", ".5": digits with at most one point and at most six decimals.
/// @throws BadInput with one line (without a place) for anything else, negative numbers included;
/// ImpossibleParameters if it is too large.
[[nodiscard]] Amount parse_amount(std::string_view text);

/// How many decimals show an amount as money: none, two, or as many up to six as it needs.
[[nodiscard]] unsigned decimals_needed(Amount amount);

/// The amount with decimals_needed() decimals, or with more if asked for.
[[nodiscard]] std::string to_string(Amount amount, unsigned at_least_decimals = 0);

/// The most parts of a job.
inline constexpr std::uint64_t max_parts = 1000;

/// A kind of parts, of which every set-up has so many: exactly one processor, two to four disks.
struct Slot {
  std::string name;
  std::uint64_t least = 0;
  std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

  bool operator==(const Slot&) const = default;
};

/// As many of a part as there are benches.
inline constexpr std::uint64_t enough_for_all = std::numeric_limits<std::uint64_t>::max();

/// Of a part that is in no slot.
inline constexpr std::uint32_t no_slot = std::numeric_limits<std::uint32_t>::max();

/// A place on the bench, which holds one part at a time, with slots one of its slot.
struct MountedPlace {
  std::uint64_t number = 0;          ///< from 1; "slot_3" on a sheet
  std::uint32_t slot = no_slot;      ///< whose parts it takes
  std::optional<Element> part = {};  ///< what is there before the first test

  bool operator==(const MountedPlace&) const = default;
};

/// What costs are, if they are times: a clock then runs along with the sheet.
enum class CostUnit : std::uint8_t { none, seconds, minutes, hours };

/// What pairs are worth: 1, but where something else is said. Weights are exact decimals, like
/// amounts of money.
class PairWeights {
 public:
  void set(Element x, Element y, Amount weight) { by_rank_[PairSet::rank(x, y)] = weight; }
  [[nodiscard]] Amount operator()(Element x, Element y) const {
    const auto found = by_rank_.find(PairSet::rank(x, y));
    return found == by_rank_.end() ? Amount{1'000'000} : found->second;
  }
  /// Whether something was said of this pair.
  [[nodiscard]] bool weighs(Element x, Element y) const {
    return by_rank_.count(PairSet::rank(x, y)) != 0;
  }
  /// No pair is said to be worth more or less than others.
  [[nodiscard]] bool empty() const { return by_rank_.empty(); }

 private:
  std::map<std::uint64_t, Amount> by_rank_;
};

/// Why pairs are forbidden, where that is said.
class PairReasons {
 public:
  /// An empty reason is none.
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

/// Three parts, increasing.
using Triple = std::array<Element, 3>;

struct Model;  // plan/model.hpp

struct Job {
  std::vector<std::string> names;    ///< of the parts, which are the elements 0, 1, …
  std::uint64_t at_once = 0;         ///< how many parts fit
  Amount test_cost;                  ///< of running one test
  std::vector<Amount> change_costs;  ///< of mounting each part once
  PairSet needed{0};                 ///< pairs that must meet
  PairSet never{0};                  ///< pairs that must not be in one set-up
  PairReasons why_never;             ///< why, where that is said; only to be said
  std::vector<Slot> slots;           ///< none: any parts may be together
  std::vector<std::uint32_t>
      slot_of;    ///< by part: the number of its slot, or no_slot; empty without slots
  Block mounted;  ///< parts that are in every set-up
  Block start;    ///< parts that are mounted before the first test
  /// Of the bench, those that are known; parts of the start that are in none take others.
  std::vector<MountedPlace> places;
  CostUnit cost_unit = CostUnit::none;  ///< only to be said
  std::vector<Element> piece_of;  ///< by part: the part of which it is a further piece, or itself;
                                  ///< empty: none is; only to be said
  std::uint64_t tests_done = 0;   ///< tests before the first; only for numbering
  /// what had to meet and did so only in tests that did not pass (mark_tested()); only to be said
  std::uint64_t met_only_in_failed = 0;
  bool trust_failed = false;  ///< whether these count as tested; only to be said
  PairWeights
      weights;  ///< of needed pairs: which are to meet early, or at all if the budget is small
  std::vector<Triple> triples;  ///< three parts that must meet in one set-up; increasing, each once
  std::vector<Block> first;  ///< set-ups that must be run first, in this order; they are paid for
  /// of putting in part i where part o was taken out, at o · parts() + i, which says nothing if
  /// they are not of one slot; empty: it is change_costs[i] for every o
  std::vector<Amount> replace_costs;
  /// the parts are its values and the slots its parameters: every set-up follows its rules
  std::shared_ptr<const Model> model;

  std::vector<std::uint64_t>
      quantities;  ///< by part: how many of it several benches share, or enough_for_all;
                   ///< empty: as many as there are benches

  /// Parts of one slot, or both of none, may take each other's place.
  [[nodiscard]] bool may_replace(Element out, Element in) const {
    return slots.empty() || slot_of[out] == slot_of[in];
  }
  /// What a change costs depends on what is replaced.
  [[nodiscard]] bool replaces() const { return !replace_costs.empty(); }
  /// What it costs to put in a part where another was taken out.
  [[nodiscard]] Amount replace_cost(Element out, Element in) const {
    return replaces() ? replace_costs[out * names.size() + in] : change_costs[in];
  }
  [[nodiscard]] std::uint64_t parts() const { return names.size(); }
  /// The most parts that a set-up can have: at_once, however large, but no more than there are.
  [[nodiscard]] std::uint64_t room() const { return at_once < parts() ? at_once : parts(); }
  /// All change costs are the same, whatever is replaced.
  [[nodiscard]] bool one_change_cost() const;
};

/// Why a text cannot stand on a run sheet, as the name of a part or as its title: it is not UTF-8,
/// or has control characters or those that turn the direction of writing around, which would make a
/// sheet say something else than it holds. Nothing if it can.
[[nodiscard]] std::optional<std::string> text_defect(std::string_view text);

/// A job with parts "1", …, "v" in which all pairs must meet. @throws BadInput if v > max_parts.
[[nodiscard]] Job make_job(std::uint64_t v, std::uint64_t at_once, Amount test_cost,
                           Amount change_cost);

/// All pairs of elements but these. O(v²).
[[nodiscard]] PairSet all_pairs_but(const PairSet& pairs);

/// Puts parts into slots: `of_parts` are the names of their slots, "" of those in none. @throws
/// BadInput without a name for each part, and for a part in a slot that is not listed; the job is
/// then as it was.
void set_slots(Job& job, const std::vector<std::string>& of_parts, std::vector<Slot> slots);

/// Adds further pieces of parts, called "DIMM A #2" and so on, where a set-up may need several: of
/// a part of a slot that needs at least n parts, up to n pieces, if there are so many
/// (`quantities`, by part). They fill the slot and cost what the part costs, but nothing has to
/// meet them: what is tested with one piece is tested, and no plan with pieces that are alike gains
/// by taking another one first. They must not meet what the part must not meet; two pieces of a
/// part may meet. Afterwards Job::quantities say, for each piece, how many benches may have it at a
/// time. Returns how many pieces were added. @throws BadInput if a part has the name of a
/// piece, or there are more than max_parts.
std::uint64_t add_pieces(Job& job, const std::vector<std::uint64_t>& quantities);

/// The needed pairs that no set-up can hold, for what the slots need and allow; with forbidden
/// pairs, those for which none was found among 100,000 choices. O(v³) without forbidden pairs.
/// Stopped if the scope of this thread (run/control.hpp) wants to stop.
[[nodiscard]] PairSet cannot_meet(const Job& job);

/// These pairs need not meet any more.
void drop_needed(Job& job, const PairSet& pairs);

/// Why no list of set-ups can do the job, or why the job is malformed: a line for each reason, at
/// most ten; none if there is one. The reasons are complete: without one, a set-up for each needed
/// pair, of this pair, the mounted parts and what the slots need, does the job. With slots and
/// forbidden pairs such a set-up is looked for among 100,000 choices. O(v³).
[[nodiscard]] std::vector<std::string> defects(const Job& job);

/// @throws BadInput with the first of defects() and how many more there are.
void check(const Job& job);

/// A job in which check() found nothing. Nothing else makes one, so a function that takes it need
/// not check again.
class CheckedJob {
 public:
  /// Without parts: nothing has to meet.
  CheckedJob() = default;
  /// @throws BadInput as check(Job), which is also what it costs.
  explicit CheckedJob(Job job);

  [[nodiscard]] const Job& operator*() const { return job_; }
  [[nodiscard]] const Job* operator->() const { return &job_; }

 private:
  friend class JobMaker;  // takes tests that were done off a job that was checked
  Job job_;
};

/// Takes tests that were already done off a job: their pairs are needed no more, and unless the job
/// says what is mounted at the start, the last of them is. @throws BadInput if one is larger than
/// at_once, has a part twice or names none of the parts; the job is then as it was. O(v² + tests ·
/// at_once · v/64). Stopped if the scope of this thread (run/control.hpp) wants to stop; the job is
/// then as it was.
void mark_done(Job& job, const std::vector<Block>& setups);

/// What the result of a test says.
enum class TestResult {
  none,     ///< nothing was written
  pass,     ///< all pairs of the set-up work together
  fail,     ///< something does not
  done,     ///< the test was run, and that is all: "done"
  not_run,  ///< it was not: "skipped", "blocked", "n/a"
  unread    ///< anything else: "smelled of smoke", "12.5"
};

/// What is said by what people write: by the first word, in any case, in the languages of
/// docs/plan.md ("FAILED - hang", "n.i.O.", "réussi", "不合格", "✓"). A word of success that is taken
/// back later ("ok, but hot"), a number and a letter x are unread. O(length).
[[nodiscard]] TestResult result_of(std::string_view result);

/// A test that was done.
struct DoneTest {
  Block setup;
  TestResult result = TestResult::done;
};

/// What comes of pairs that met only in tests that did not pass.
enum class FailedTests {
  again,   ///< they are still needed
  trusted  ///< they count as tested
};

/// As mark_done(), by results: what meets in a test that passed, that was done or of which no
/// result is known (`none`) is needed no more; what meets only in tests that failed, or whose
/// result is unread, is needed still, unless these are trusted. How much that is stands then in
/// Job::met_only_in_failed: triples if these must meet, else pairs. Tests that were not run say
/// nothing. @throws and complexity as mark_done().
void mark_tested(Job& job, const std::vector<DoneTest>& tests,
                 FailedTests failed = FailedTests::again);

/// The most parts of a job in which triples have to meet.
inline constexpr std::uint64_t max_parts_of_triples = 100;

/// Asks for every three parts that can be in one set-up to meet, and for their pairs, instead of
/// what was asked for; returns how many triples cannot, for the slots, forbidden pairs or what
/// stays mounted. @throws BadInput for more than max_parts_of_triples parts. O(v³) without
/// forbidden pairs. Stopped if the scope of this thread wants to stop; the job is then as it was.
std::uint64_t need_triples(Job& job);

/// What is left of a job when its first set-ups have been run: their pairs are needed no more, and
/// the last of them is mounted. The job itself if there are none. O(v² + pairs of the set-ups).
[[nodiscard]] Job after_first(const Job& job);

// What an experimenter writes down: parts with their change costs, pairs, and set-ups.
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
// Files are rows of fields between commas, semicolons or tabs, whichever comes first outside
// quotes; a field may be quoted; lines that begin with # and blank lines say nothing. Where a part
// is expected, its name or its number in the parts list counts, from 1; a name wins over a number.
//   - Parts: a name, and a change cost if there is a second field; with a header also other
//     columns, of which those for names, costs, slots and quantities are found by their words. What
//     is a header is decided by src/plan/job/parts/part_columns.hpp; a first row that may be a
//     header or a part is refused. Between semicolons or tabs a cost may have a decimal comma, if
//     no cost of the list has a point.
//   - Pairs: two parts a row, or with blanks between them if that is no part; a third field may say
//     why. A first row with two words that head columns of parts and are no parts is a header, and
//     says which columns count.
//   - Set-ups: the parts of one a row. The CSV of a run sheet (plan/run_plan.hpp) is taken too: its
//     columns slot_1, slot_2, … count, or its column set_up with all parts in one field, its
//     columns result and bench, and its rows in their order.
// Each of them may be a sheet of a workbook (.xlsx) instead, known by its content: the first sheet,
// or open_list() (io/input.hpp) names one. Its cells are what they say, so no row is a comment and
// no name needs quotes; a number is taken in full, a formula for the value that the file holds,
// line ends within a cell for blanks; what stands right of the columns that the header names says
// nothing. Places are then `parts.xlsx:Costs!B3`.
//
// Lists are UTF-8; control characters and those that turn the direction of writing around are
// refused. They are read a line at a time: at most 16 MiB a line, 1 GiB and 4,194,304 rows in all.
// A violation is BadInput with one line: `NAME:LINE:COLUMN: what is wrong; how to mend it`.

/// Whether a parts list has a header.
enum class Header { guessed, given, none };

struct PartListOptions {
  Header header = Header::guessed;
  /// What heads the change costs, in any case, so that there is a header; "-": no column has any.
  /// Empty: found by words.
  std::string cost_column = {};
  /// Names of slots that are known: if no column is headed "slot", one of which more than half is
  /// these has them.
  std::vector<std::string> slots = {};
};

struct PartList {
  std::vector<std::string> names;
  std::vector<std::optional<Amount>> change_costs;  ///< by part; nothing where none is given
  std::vector<std::string>
      slots;  ///< by part: the name of its slot, or ""; empty without a column for it
  std::vector<std::uint64_t>
      quantities;  ///< by part: how many there are, 1 where nothing is said; empty without a column
  CostUnit unit = CostUnit::none;  ///< of the change costs, if the list says so
  std::string note;  ///< what was made of the list, in one line, if that is worth saying
};

/// The parts in the order of their rows.
/// @throws BadInput for no part, an empty or repeated name, a cost that is none, too many fields, a
/// first row that may or may not be a header; MissingResource if reading fails.
[[nodiscard]] PartList read_parts(Input& input, Header header = Header::guessed);
[[nodiscard]] PartList read_parts(Input& input, const PartListOptions& options);

/// The pairs, as elements below names.size(); repetitions are fine. A third field says why, which
/// is kept in `why` if that is given; without a header it may not be a part. If `gone` is given,
/// rows of a file that name parts which are none (any more) are left out, and each such name is
/// added to it once; a number, and a name that differs in its case only, is refused all the same.
/// @throws BadInput for unknown parts, a part with itself, rows that are no pair; MissingResource
/// if reading fails.
[[nodiscard]] PairSet read_pairs(Input& input, const std::vector<std::string>& names,
                                 PairReasons* why = nullptr,
                                 std::vector<std::string>* gone = nullptr);

/// The set-ups in order. @throws BadInput for unknown or repeated parts and for a set-up of more
/// than `at_once`; MissingResource if reading fails.
[[nodiscard]] std::vector<Block> read_setups(
    Input& input, const std::vector<std::string>& names,
    std::uint64_t at_once = std::numeric_limits<std::uint64_t>::max());

/// The same for the parts of a job. If these are the values of a model they are called as they are
/// or "Parameter: value", in any case, and have no numbers; set-ups may have a first row with names
/// of parameters, below which stand their values.
[[nodiscard]] PairSet read_pairs(Input& input, const Job& job, PairReasons* why = nullptr);
[[nodiscard]] std::vector<Block> read_setups(Input& input, const Job& job);

/// What a change costs by what is replaced, for Job::replace_costs: a square table. Its first row
/// names the parts that are put in, after a field that says nothing; every other row begins with
/// the part that is taken out. Each part heads one row and one column, in any order; where a part
/// meets itself the field is empty. With slots, by part, fields for parts of two slots may be
/// empty, and say nothing: 0. `gone` as in read_pairs(), of rows and columns. @throws BadInput for
/// a part that heads none or two, unknown parts, fields that are no cost, too few and too many of
/// them; MissingResource if reading fails.
[[nodiscard]] std::vector<Amount> read_change_costs(Input& input,
                                                    const std::vector<std::string>& names,
                                                    const std::vector<std::uint32_t>& slot_of = {},
                                                    std::vector<std::string>* gone = nullptr);

/// What pairs are worth, `A,B,weight` a row; a header is taken for one. `gone` as in read_pairs().
/// @throws BadInput for other rows, negative weights and a pair with two weights; MissingResource
/// if reading fails.
[[nodiscard]] PairWeights read_priorities(Input& input, const std::vector<std::string>& names,
                                          std::vector<std::string>* gone = nullptr);

/// Set-ups that must come first in a job that is otherwise complete, for Job::first. Of a model a
/// set-up may lack values, which are chosen. @throws BadInput as read_setups(), with the line of a
/// set-up that the job does not allow: parts that must not meet, slots, what stays mounted; for no
/// set-up.
[[nodiscard]] std::vector<Block> read_first(Input& input, const Job& job);

/// A column of a run sheet that holds what is mounted in one place.
struct DonePlace {
  std::uint64_t number = 0;  ///< of the place: 3 of "slot_3 disk"
  std::string slot = {};     ///< "disk"; "" where the head does not say
};

/// What was done by a list of set-ups, perhaps the run sheet of a parts list that has changed
/// since.
struct DoneList {
  std::vector<Block> setups;
  std::vector<std::string> results;  ///< by set-up, as written; "" where none is
  std::vector<std::string> gone;     ///< names on a run sheet that no part has any more, each once
  std::vector<bool> lacks;           ///< by set-up: some of its parts are gone
  std::vector<std::uint64_t> lines;  ///< by set-up: where it stands
  std::vector<DonePlace> places;     ///< of a run sheet with a column for each; else none
  std::vector<std::vector<std::optional<Element>>>
      in_place;  ///< by set-up, by place: what was mounted there; nothing for what is gone
  std::vector<std::vector<std::string>>
      written;                     ///< the same as it stands there, also what is gone
  std::vector<std::string> notes;  ///< by set-up: its column notes
  std::vector<std::string>
      unread;  ///< by set-up: the place of its result if that is unread, else ""
  std::vector<std::string>
      benches;  ///< by set-up: the bench that it was on, as written; "" where none is

  [[nodiscard]] bool has_results() const;
};

/// Tests that were done, as they are kept on a sheet.
struct DoneRecord {
  struct Test {
    std::vector<std::string>
        parts;  ///< by place, "" where there was none; perhaps fewer than places
    std::string result;
    std::string notes;
  };
  std::vector<DonePlace> places;
  std::vector<Test> tests;
};

/// As read_setups(), but for a run sheet: parts that are none any more are left out of the set-ups
/// and named once, and numbers count as parts only if no name is a number. A name that differs from
/// one of a part in its case only is refused. @throws as read_setups().
[[nodiscard]] DoneList read_done(Input& input, const std::vector<std::string>& names,
                                 std::uint64_t at_once = std::numeric_limits<std::uint64_t>::max());

/// The same for the parts of a job, as read_setups() has it.
[[nodiscard]] DoneList read_done(Input& input, const Job& job);

/// Slots with the least and the most parts of each, `slot,least,most` a row; with a header of such
/// words ("slot", "min", "max", "quantity") in any order, an empty field is no limit. @throws
/// BadInput for other rows and repeated slots; MissingResource if reading fails.
[[nodiscard]] std::vector<Slot> read_slots(Input& input);

/// Slots in one line, "CPU=1, disk=2..4, fan=..2". @throws BadInput (without a place).
[[nodiscard]] std::vector<Slot> parse_slots(std::string_view text);

/// Parts in one line, "Pump A, 3"; fields as in files. @throws BadInput (without a place) for
/// unknown or repeated parts.
[[nodiscard]] Block parse_parts(std::string_view text, const std::vector<std::string>& names);

/// Parts by name, or by number if no name is a number. @throws BadInput (without a place) for
/// unknown or repeated parts.
[[nodiscard]] Block parts_named(const std::vector<std::string>& words,
                                const std::vector<std::string>& names);

/// The same for the parts of a job, as read_pairs() has it.
[[nodiscard]] Block parts_named(const std::vector<std::string>& words, const Job& job);

/// The same parts again by name, so that parse_parts() reads them back.
[[nodiscard]] std::string parts_text(const Block& parts, const std::vector<std::string>& names);

}  // namespace changeover
