#include "plan/search/choices/choice_lists.hpp"

#include <algorithm>

#include "changeover/plan/model.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

constexpr std::uint32_t not_needed = std::uint32_t{1} << 30U;

}  // namespace

ChoiceJob::ChoiceJob(const Job& job)
    : job_(&job),
      rules_(*job.model),
      weights_(Weights::of(job, 2 * (job.needed.size() + job.triples.size()) + 16)),
      triples_(!job.triples.empty()),
      values_(job.slots.size()) {
  const std::size_t v = job.names.size();
  for (Element x = 0; x < v; ++x) {
    slot_.push_back(job.slot_of[x]);
    if (!rules_.banned(x) && !contains(job.barred, x)) {
      values_[slot_[x]].push_back(x);
    }
    hides_.push_back(job.model->value(x).negative ? 1 : 0);
    any_hides_ = any_hides_ || hides_[x] != 0;
  }
  for (const Element x : job.mounted) {
    values_[slot_[x]] = {x};
  }
  needed_.assign(triples_ ? v * v * v : v * v, 0);
  if (triples_) {
    for (const Triple& t : job.triples) {
      needed_[triple(t[0], t[1], t[2])] = 1;
      ++needed_count_;
    }
  } else {
    job.needed.for_each(all_of_them, [&](Element x, Element y) {
      needed_[pair(x, y)] = needed_[pair(y, x)] = 1;
      ++needed_count_;
    });
  }
  if (rules_.any_apart() || job.never.size() > 0) {
    never_.assign(v * v, 0);
    for (Element x = 0; x < v; ++x) {
      for (Element y = 0; y < v; ++y) {
        never_[pair(x, y)] = rules_.apart(x, y) ? 1 : 0;
      }
    }
    job.never.for_each(all_of_them,
                       [&](Element x, Element y) { never_[pair(x, y)] = never_[pair(y, x)] = 1; });
  }
  start_.assign(values_.size(), no_choice);
  for (const Element x : job.start) {
    start_[slot_[x]] = x;
  }
  for (const Amount cost : job.replace_costs) {
    replace_.push_back(static_cast<std::int64_t>(
        ceil_div(std::max<std::uint64_t>(1, cost.millionths), weights_.unit)));
  }
}

std::size_t ChoiceJob::triple(Element x, Element y, Element z) const {
  sort_three(x, y, z);
  return (x * parts() + y) * parts() + z;
}

void ChoiceJob::parts_of(std::size_t tuple, Element out[3]) const {
  const std::size_t v = parts();
  out[0] = static_cast<Element>(tuple % v);
  out[1] = static_cast<Element>(tuple / v % v);
  out[2] = triples_ ? static_cast<Element>(tuple / (v * v)) : no_choice;
}

bool ChoiceJob::allows(std::span<const Element> row, Element x) const {
  if (!never_.empty()) {
    const std::uint8_t* const apart = never_.data() + pair(x, 0);
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (apart[row[s]] != 0 && s != slot_[x]) {
        return false;
      }
    }
  }
  return rules_.allows(row, slot_[x], x);
}

bool ChoiceJob::allows(std::span<const Element> row) const {
  return std::ranges::all_of(row, [&](Element x) {
    return std::ranges::find(values_[slot_[x]], x) != values_[slot_[x]].end() && allows(row, x);
  });
}

ChoiceList::ChoiceList(const ChoiceJob& choices, const std::vector<Block>& setups)
    : choices_(&choices),
      width_(choices.slots()),
      count_(choices.tuples(), 0),
      where_(choices.tuples(), 0) {
  const std::size_t v = choices.parts();
  for (std::size_t tuple = 0; tuple < choices.tuples(); ++tuple) {
    if (!choices.is_needed(tuple)) {
      count_[tuple] = not_needed;
    } else if (choices.triples() || tuple / v < tuple % v) {
      // A pair is counted in both orders, but listed as missing once.
      where_[tuple] = static_cast<std::uint32_t>(missing_.size());
      missing_.push_back(tuple);
    }
  }
  for (const Block& setup : setups) {
    insert(size(), setup);
  }
}

std::uint32_t ChoiceList::hiding_in(const Element* row) const {
  if (choices_->any_hides()) {
    for (std::size_t s = 0; s < width_; ++s) {
      if (choices_->hides(row[s])) {
        return static_cast<std::uint32_t>(s);
      }
    }
  }
  return nowhere;
}

// The tuples that a row tests with x as its value of this parameter; `hiding` is the parameter of
// the row that hides the others.
template <typename Visit>
void ChoiceList::for_tuples_of(const Element* row, std::size_t slot, Element x,
                               std::uint32_t hiding, Visit&& visit) const {
  if (!choices_->triples()) {
    const auto visit_pair = [&](Element y) {
      visit(Both{choices_->pair(x, y), choices_->pair(y, x)});
    };
    if (hiding != nowhere && hiding != slot) {
      visit_pair(row[hiding]);
      return;
    }
    std::for_each(row, row + slot, visit_pair);
    std::for_each(row + slot + 1, row + width_, visit_pair);
    return;
  }
  const bool others = hiding != nowhere && hiding != slot;
  for (std::size_t s = 0; s < width_; ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      if (s != slot && t != slot && (!others || s == hiding || t == hiding)) {
        const std::size_t triple = choices_->triple(x, row[s], row[t]);
        visit(Both{triple, triple});
      }
    }
  }
}

// All tuples that a row tests, each once.
template <typename Visit>
void ChoiceList::for_tuples(const Element* row, std::uint32_t hiding, Visit&& visit) const {
  if (hiding != nowhere) {
    for_tuples_of(row, hiding, row[hiding], hiding, visit);
    return;
  }
  for (std::size_t s = 0; s < width_; ++s) {
    for (std::size_t t = 0; t < s; ++t) {
      if (!choices_->triples()) {
        visit(Both{choices_->pair(row[s], row[t]), choices_->pair(row[t], row[s])});
        continue;
      }
      for (std::size_t u = 0; u < t; ++u) {
        const std::size_t triple = choices_->triple(row[s], row[t], row[u]);
        visit(Both{triple, triple});
      }
    }
  }
}

void ChoiceList::met(Both tuple) {
  const std::uint32_t count = ++count_[tuple.tuple];
  count_[tuple.twin] = count;
  if (count == 1) {
    const std::size_t low = std::min(tuple.tuple, tuple.twin);  // it has the lower part first
    const std::size_t last = missing_.back();
    missing_[where_[low]] = last;
    where_[last] = where_[low];
    missing_.pop_back();
  }
}

void ChoiceList::lost(Both tuple) {
  const std::uint32_t count = --count_[tuple.tuple];
  count_[tuple.twin] = count;
  if (count == 0) {
    const std::size_t low = std::min(tuple.tuple, tuple.twin);
    where_[low] = static_cast<std::uint32_t>(missing_.size());
    missing_.push_back(low);
  }
}

void ChoiceList::count_row(const Element* row, std::uint32_t hiding, bool comes) {
  for_tuples(row, hiding, [&](Both tuple) { comes ? met(tuple) : lost(tuple); });
}

std::int64_t ChoiceList::step_cost(const Element* before, const Element* row) const {
  std::int64_t cost = 0;
  for (std::size_t s = 0; s < width_; ++s) {
    cost += choices_->price(before[s], row[s]);
  }
  return cost;
}

// The cost of a cell if it has the value x, including the step after it.
std::int64_t ChoiceList::cost_around(Cell cell, Element x) const {
  std::int64_t cost = choices_->price(before(cell.at)[cell.slot], x);
  if (cell.at + 1 < size()) {
    cost += choices_->price(x, cells(cell.at + 1)[cell.slot]);
  }
  return cost;
}

Rise ChoiceList::rise_of_set(Cell cell, Element x) const {
  const Element* const here = cells(cell.at);
  const Element old = here[cell.slot];
  Rise rise{.cost = cost_around(cell, x) - cost_around(cell, old)};
  const auto goes = [&](Both pair) { rise.uncovered += count_[pair.tuple] == 1 ? 1 : 0; };
  const auto comes = [&](Both pair) { rise.uncovered -= count_[pair.tuple] == 0 ? 1 : 0; };
  const std::uint32_t hiding = hiding_[order_[cell.at]];
  const bool before_here = hiding == cell.slot;
  const bool after_here = choices_->hides(x);
  if (before_here == after_here) {
    for_tuples_of(here, cell.slot, old, hiding, goes);
    for_tuples_of(here, cell.slot, x, hiding, comes);
  } else if (after_here) {
    for_tuples(here, hiding, goes);
    for_tuples_of(here, cell.slot, x, static_cast<std::uint32_t>(cell.slot), comes);
  } else {
    for_tuples(here, hiding, goes);
    thread_local std::vector<Element> row;
    row.assign(here, here + width_);
    row[cell.slot] = x;
    for_tuples(row.data(), nowhere, comes);
  }
  return rise;
}

void ChoiceList::set(Cell cell, Element x) {
  const std::size_t number = order_[cell.at];
  Element* const here = cells_.data() + number * width_;
  const Element old = here[cell.slot];
  if (old == x) {
    return;
  }
  cost_ += cost_around(cell, x) - cost_around(cell, old);
  const std::uint32_t hiding = hiding_[number];
  if ((hiding == cell.slot) == choices_->hides(x)) {
    for_tuples_of(here, cell.slot, old, hiding, [&](Both tuple) { lost(tuple); });
    here[cell.slot] = x;
    for_tuples_of(here, cell.slot, x, hiding, [&](Both tuple) { met(tuple); });
    return;
  }
  count_row(here, hiding, false);
  here[cell.slot] = x;
  hiding_[number] = hiding_in(here);
  count_row(here, hiding_[number], true);
}

std::size_t ChoiceList::tested_only_by(std::size_t at) const {
  std::size_t only = 0;
  for_tuples(cells(at), hiding_[order_[at]],
             [&](Both pair) { only += count_[pair.tuple] == 1 ? 1U : 0U; });
  return only;
}

std::int64_t ChoiceList::cost_of_insert(std::size_t at, const Element* row) const {
  const Element* const previous = before(at);
  std::int64_t cost =
      step_cost(previous, row) + static_cast<std::int64_t>(choices_->weights().test);
  if (at < size()) {
    cost += step_cost(row, cells(at)) - step_cost(previous, cells(at));
  }
  return cost;
}

std::int64_t ChoiceList::saved_by_erase(std::size_t at) const {
  const Element* const here = cells(at);
  const Element* const previous = before(at);
  std::int64_t cost =
      step_cost(previous, here) + static_cast<std::int64_t>(choices_->weights().test);
  if (at + 1 < size()) {
    cost += step_cost(here, cells(at + 1)) - step_cost(previous, cells(at + 1));
  }
  return cost;
}

Rise ChoiceList::rise_of_insert(std::size_t at, std::span<const Element> row) const {
  Rise rise{.cost = cost_of_insert(at, row.data())};
  for_tuples(row.data(), hiding_in(row.data()),
             [&](Both pair) { rise.uncovered -= count_[pair.tuple] == 0 ? 1 : 0; });
  return rise;
}

Rise ChoiceList::rise_of_erase(std::size_t at) const {
  return {-saved_by_erase(at), static_cast<std::int64_t>(tested_only_by(at))};
}

void ChoiceList::insert(std::size_t at, std::span<const Element> row) {
  const std::vector<Element> kept(row.begin(), row.end());  // the row may be one of this list
  std::size_t number = hiding_.size();
  if (free_.empty()) {
    cells_.resize(cells_.size() + width_);
    hiding_.push_back(nowhere);
  } else {
    number = free_.back();
    free_.pop_back();
  }
  std::ranges::copy(kept, cells_.begin() + static_cast<std::ptrdiff_t>(number * width_));
  const Element* const here = cells_.data() + number * width_;
  cost_ += cost_of_insert(at, here);
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(at), number);
  hiding_[number] = hiding_in(here);
  count_row(here, hiding_[number], true);
}

void ChoiceList::erase(std::size_t at) {
  cost_ -= saved_by_erase(at);
  count_row(cells(at), hiding_[order_[at]], false);
  free_.push_back(order_[at]);
  order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(at));
}

std::int64_t ChoiceList::cost_within(Stretch rows, bool turned) const {
  std::int64_t cost = 0;
  for (std::size_t at = rows.first; at < rows.last; ++at) {
    cost += turned ? step_cost(cells(at + 1), cells(at)) : step_cost(cells(at), cells(at + 1));
  }
  return cost;
}

std::int64_t ChoiceList::rise_of_move(Stretch rows, std::size_t to, bool turned) const {
  const Element* const first = cells(rows.first);
  const Element* const last = cells(rows.last);
  std::int64_t rise = -step_cost(before(rows.first), first);
  if (rows.last + 1 < size()) {
    rise +=
        step_cost(before(rows.first), cells(rows.last + 1)) - step_cost(last, cells(rows.last + 1));
  }
  if (turned && rows.first < rows.last) {
    rise += cost_within(rows, true) - cost_within(rows, false);
  }
  // Between the row before `to` and that at `to`, after removing the stretch.
  const Element* const earlier = to == rows.last + 1 ? before(rows.first) : before(to);
  const Element* const front = turned ? last : first;
  const Element* const back = turned ? first : last;
  rise += step_cost(earlier, front);
  if (to < size()) {
    rise += step_cost(back, cells(to)) - step_cost(earlier, cells(to));
  }
  return rise;
}

void ChoiceList::move(Stretch rows, std::size_t to, bool turned) {
  cost_ += rise_of_move(rows, to, turned);
  const auto at = [&](std::size_t place) {
    return order_.begin() + static_cast<std::ptrdiff_t>(place);
  };
  if (turned) {
    std::reverse(at(rows.first), at(rows.last + 1));
  }
  if (to > rows.last) {
    std::rotate(at(rows.first), at(rows.last + 1), at(to));
  } else {
    std::rotate(at(to), at(rows.first), at(rows.last + 1));
  }
}

std::int64_t ChoiceList::rise_of_reverse(Stretch rows) const {
  const Element* const first = cells(rows.first);
  const Element* const last = cells(rows.last);
  std::int64_t rise = step_cost(before(rows.first), last) - step_cost(before(rows.first), first);
  if (rows.last + 1 < size()) {
    const Element* const next = cells(rows.last + 1);
    rise += step_cost(first, next) - step_cost(last, next);
  }
  if (choices_->replaces()) {
    return rise + cost_within(rows, true) - cost_within(rows, false);
  }
  // Replacement costs: the cost from one row to the next differs from that of the way back by a
  // difference of two values.
  for (std::size_t s = 0; s < width_; ++s) {
    rise += choices_->price(no_choice, first[s]) - choices_->price(no_choice, last[s]);
  }
  return rise;
}

void ChoiceList::reverse(Stretch rows) {
  cost_ += rise_of_reverse(rows);
  std::reverse(order_.begin() + static_cast<std::ptrdiff_t>(rows.first),
               order_.begin() + static_cast<std::ptrdiff_t>(rows.last) + 1);
}

std::vector<Block> ChoiceList::setups() const {
  std::vector<Block> all;
  for (std::size_t at = 0; at < size(); ++at) {
    all.emplace_back(row(at).begin(), row(at).end());
  }
  return all;
}

}  // namespace changeover
