#include "plan/job/setups/emptied_cells.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/setups/results.hpp"

namespace changeover {
namespace {

std::optional<Element> part_in(const DoneRow* row, std::size_t place) {
  return row != nullptr && place < row->in_place.size() ? row->in_place[place] : std::nullopt;
}

// Whether a value of the parameter of this one is among these.
bool is_set(const Model& model, Element value, const Block& among) {
  return std::ranges::any_of(model.parameters, [&](const ModelParameter& parameter) {
    const auto is_of_it = [&](Element x) {
      return x >= parameter.first && x < parameter.first + parameter.values.size();
    };
    return is_of_it(value) && std::ranges::any_of(among, is_of_it);
  });
}

bool counts(const DoneRow& row, bool has_results) {
  return has_results ? was_run(row.result) : result_of(row.result) != TestResult::not_run;
}

bool is_next(const DoneRow* one, const DoneRow* other) {
  return one != nullptr && other != nullptr && one->step && other->step == *one->step + 1;
}

}  // namespace

// A row, and the rows of its bench above and below it.
struct EmptiedCells::Neighbours {
  const DoneRow* above = nullptr;
  const DoneRow* here = nullptr;
  const DoneRow* below = nullptr;
};

void EmptiedCells::take(const DoneRow& done, const std::vector<Field>& cells, Changes changes) {
  Known known{.empty = {}, .changes = std::move(changes)};
  for (std::size_t i = 0; i < cells.size() && i < done.written.size(); ++i) {
    if (done.written[i].empty() && !done.in_place[i]) {
      known.empty.emplace_back(i, cells[i].offset);
    }
  }
  some_are_empty_ = some_are_empty_ || !known.empty.empty();
  rows_.emplace(done.line, std::move(known));
}

// In a test before that is as it was planned: all that is taken out here was in it.
bool EmptiedCells::was_before(const Neighbours& rows, std::size_t place,
                              const PartFinder& finder) const {
  const auto part = part_in(rows.above, place);
  if (!part || contains(rows.here->setup, *part)) {
    return false;
  }
  const Changes& changes = rows_.at(rows.here->line).changes;
  if (finder.model() != nullptr) {
    return changes.in && !is_set(finder.model()->model(), *part, *changes.in);
  }
  return changes.out && !contains(*changes.out, *part) &&
         std::ranges::all_of(*changes.out,
                             [&](Element x) { return contains(rows.above->setup, x); });
}

bool EmptiedCells::is_after(const Neighbours& rows, std::size_t place) const {
  const auto part = part_in(rows.below, place);
  if (!part || contains(rows.here->setup, *part)) {
    return false;
  }
  const Changes& changes = rows_.at(rows.below->line).changes;
  return changes.in && !contains(*changes.in, *part);
}

// The same part before and after, and nothing that says what was taken out.
bool EmptiedCells::is_doubtful(const Neighbours& rows, std::size_t place) const {
  const auto part = part_in(rows.above, place);
  return part && part == part_in(rows.below, place) && !contains(rows.here->setup, *part) &&
         !rows_.at(rows.here->line).changes.out;
}

void EmptiedCells::judge_row(const Neighbours& rows, const PartFinder& finder,
                             const RowReader& reader, FirstNoted& doubts) const {
  const bool has_steps = rows.here->step.has_value();
  for (const auto& [place, offset] : rows_.at(rows.here->line).empty) {
    const bool before =
        was_before(rows, place, finder) && (!has_steps || is_next(rows.above, rows.here));
    const bool after = is_after(rows, place) && (!has_steps || is_next(rows.here, rows.below));
    const Field cell{.text = {}, .offset = offset, .line = rows.here->line};
    if (has_steps ? before || after : before && after) {
      const Element part = *part_in(before ? rows.above : rows.below, place);
      reader.fail(
          cell, fmt::format(
                    "the cell is empty, but {} is there in the test {}; write it here{}",
                    shown(finder.name(part)),
                    before ? "before and nothing takes it out" : "after it and nothing puts it in",
                    finder.model() != nullptr ? ""
                    : before                  ? ", or under take_out if it was taken out"
                                              : ", or under put_in there if it was put in"));
    }
    const bool is_between =
        !has_steps || (is_next(rows.above, rows.here) && is_next(rows.here, rows.below));
    if (is_between && is_doubtful(rows, place)) {
      doubts.add([&] {
        return fmt::format("{}: the cell is empty, and {} is there in the tests before and after",
                           reader.place(cell), shown(finder.name(*part_in(rows.above, place))));
      });
    }
  }
}

// A test of the user between those that were planned: it has no number and no changes.
bool EmptiedCells::is_own(const DoneRow& row) const {
  const Changes& changes = rows_.at(row.line).changes;
  const auto says_none = [](const std::optional<Block>& parts) { return !parts || parts->empty(); };
  return !row.step && says_none(changes.out) && says_none(changes.in);
}

void EmptiedCells::judge(DoneList& list, const PartFinder& finder, const RowReader& reader) const {
  if (!some_are_empty_) {
    return;
  }
  const bool has_results = list.has_results();
  std::map<std::string, Neighbours> by_bench;
  FirstNoted doubts;
  const auto look = [&](const Neighbours& rows) {
    if (rows.here != nullptr && counts(*rows.here, has_results)) {
      judge_row(rows, finder, reader, doubts);
    }
  };
  const bool has_steps =
      std::ranges::any_of(list.rows, [](const DoneRow& row) { return row.step.has_value(); });
  for (const DoneRow& row : list.rows) {
    if (has_steps && is_own(row)) {
      continue;
    }
    Neighbours& rows = by_bench[row.bench];
    rows = {.above = rows.here, .here = rows.below, .below = &row};
    look(rows);
  }
  for (auto& [bench, rows] : by_bench) {
    look({.above = rows.here, .here = rows.below, .below = nullptr});
  }
  if (doubts) {
    list.notes.push_back(doubts.said("other cell") + "; write it here if it was there in this one");
  }
}

}  // namespace changeover
