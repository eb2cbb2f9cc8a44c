#include "plan/search/lists/lists.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "changeover/plan/model.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/lists/assignment.hpp"

namespace changeover {
std::vector<Weights> weights_of(const std::vector<const Job*>& jobs, std::uint64_t tests) {
  std::vector<Weights> all;
  std::uint64_t unit = 1;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const bool is_same = i > 0 && jobs[i] == jobs[i - 1];
    all.push_back(is_same ? all.back() : Weights::of(*jobs[i], tests));
    unit = std::max(unit, all.back().unit);
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (all[i].unit != unit) {
      all[i].unit = unit;
      all[i].test = ceil_div(jobs[i]->test_cost.millionths, unit);
      for (std::size_t x = 0; x < all[i].change.size(); ++x) {
        all[i].change[x] =
            ceil_div(std::max<std::uint64_t>(1, jobs[i]->change_costs[x].millionths), unit);
      }
    }
  }
  return all;
}

ListsJob ListsJob::alike(const Job& job, const Weights& weights, std::size_t benches) {
  return {.common = &job,
          .jobs = std::vector<const Job*>(benches, &job),
          .weights = std::vector<Weights>(benches, weights)};
}

namespace {

std::vector<bool> values_out_of_range(const Job& job) {
  std::vector<bool> hides(job.names.size(), false);
  bool some = false;
  for (Element x = 0; x < job.parts() && job.model != nullptr; ++x) {
    hides[x] = job.model->value(x).negative;
    some = some || hides[x];
  }
  return some ? hides : std::vector<bool>();
}

}  // namespace

Element Lists::hiding_in(std::span<const Element> setup) const {
  if (!hides_.empty()) {
    for (const Element x : setup) {
      if (hides_[x]) {
        return x;
      }
    }
  }
  return no_part;
}

void Lists::fill(Place& place, std::span<const Element> setup) const {
  place.elements.assign(setup.begin(), setup.end());
  if (of_model()) {
    std::ranges::sort(place.elements);
  }
  place.bits.assign((parts_ + 63) / 64, 0);
  for (const Element x : setup) {
    place.bits[x >> 6] |= std::uint64_t{1} << (x & 63);
  }
}

Lists::Place Lists::place_of(std::span<const Element> setup) const {
  Place place;
  fill(place, setup);
  return place;
}

void Lists::add_views(const ListsJob& job) {
  for (std::size_t bench = 0; bench < job.jobs.size(); ++bench) {
    const Job& own = *job.jobs[bench];
    const auto same = std::find_if(views_.begin(), views_.end(),
                                   [&](const View& other) { return other.job == &own; });
    view_of_.push_back(static_cast<std::size_t>(same - views_.begin()));
    if (same != views_.end()) {
      continue;
    }
    View view{.job = &own,
              .fitting = Fitting(own),
              .weights = job.weights[bench],
              .replace = {},
              .values = ValueRules(own, job.rules),
              .stays = std::vector<bool>(parts_, false),
              .start = place_of(own.start)};
    for (const Element m : own.mounted) {
      view.stays[m] = true;
    }
    for (const Amount cost : own.replace_costs) {
      view.replace.push_back(static_cast<std::int64_t>(
          ceil_div(std::max<std::uint64_t>(1, cost.millionths), view.weights.unit)));
    }
    most_room_ = std::max(most_room_, own.room());
    views_.push_back(std::move(view));
  }
}

Lists::Lists(const ListsJob& job, const BenchLists& lists)
    : job_(job.common),
      parts_(job.common->names.size()),
      triples_(!job.common->triples.empty()),
      hides_(values_out_of_range(*job.common)),
      is_movable_(parts_, false),
      order_(lists.size()),
      cost_(lists.size(), 0) {
  const std::size_t words = (parts_ + 63) / 64;
  const std::size_t places = triples_ ? choose_three(parts_) : choose_two(parts_);
  constexpr auto all = std::numeric_limits<std::uint64_t>::max();
  add_views(job);
  count_.assign(places, 1);
  place_.assign(places, 0);
  if (!job_->weights.empty()) {
    weight_.assign(places, one);
  }
  const auto need = [&](std::size_t i) {
    count_[i] = 0;
    place_[i] = static_cast<std::uint32_t>(open_.size());
    open_.push_back(static_cast<std::uint32_t>(i));
    missing_ += weight_.empty() ? one : weight_[i];
  };
  if (triples_) {
    for (const Triple& t : job_->triples) {
      is_movable_[t[0]] = is_movable_[t[1]] = is_movable_[t[2]] = true;
      need(index(t[0], t[1], t[2]));
    }
  } else {
    job_->needed.for_each(all, [&](Element x, Element y) {
      is_movable_[x] = is_movable_[y] = true;
      if (!weight_.empty()) {
        weight_[index(x, y)] = job_->weights(x, y).millionths;
      }
      need(index(x, y));
    });
  }
  for (Element x = 0; x < parts_; ++x) {
    bool moves = false;  // on some bench
    for (const View& view : views_) {
      const bool fills = view.fitting.least(view.fitting.slot(x)) > 0;
      moves = moves || (!view.stays[x] && (is_movable_[x] || fills));
    }
    is_movable_[x] = moves;
    if (moves) {
      movable_.push_back(x);
    }
  }
  if (job_->never.size() > 0) {
    never_.assign(parts_, Bits(words, 0));
    job_->never.for_each(all, [&](Element x, Element y) {
      never_[x][y >> 6] |= std::uint64_t{1} << (y & 63);
      never_[y][x >> 6] |= std::uint64_t{1} << (x & 63);
    });
  }
  for (std::size_t bench = 0; bench < job.spent.size(); ++bench) {
    cost_[bench] = job.spent[bench];
    total_ += job.spent[bench];
  }
  job.overlaps ? set_overlaps(job) : set_clock(job);
  for (std::size_t bench = 0; bench < lists.size(); ++bench) {
    for (const Block& setup : lists[bench]) {
      stop_if_asked();
      insert({bench, tests(bench)}, setup);
    }
  }
  keep();
  retime();
}

std::size_t Lists::index(Element x, Element y, Element z) const {
  sort_three(x, y, z);
  return choose_three(z) + choose_two(y) + x;
}

std::array<Element, 3> Lists::open_target(std::size_t index) const {
  std::size_t left = open_[index];
  std::array<Element, 3> target{0, 0, no_part};
  if (triples_) {
    Element z = 2;
    while (choose_three(z + std::size_t{1}) <= left) {
      ++z;
    }
    left -= choose_three(z);
    target[2] = z;
  }
  Element y = 1;
  while (choose_two(y + std::size_t{1}) <= left) {
    ++y;
  }
  target[0] = static_cast<Element>(left - choose_two(y));
  target[1] = y;
  return target;
}

Spot Lists::spot(std::size_t index) const {
  std::size_t bench = 0;
  while (index >= order_[bench].size()) {
    index -= order_[bench++].size();
  }
  return {bench, index};
}

BenchLists Lists::lists() const {
  BenchLists result(benches());
  for (std::size_t bench = 0; bench < benches(); ++bench) {
    for (const std::uint32_t handle : order_[bench]) {
      result[bench].push_back(places_[handle].elements);
      std::sort(result[bench].back().begin(), result[bench].back().end());
    }
  }
  return result;
}

Element Lists::rival_in(std::span<const Element> setup, Element x) const {
  const auto found =
      std::ranges::find_if(setup, [&](Element y) { return job_->slot_of[y] == job_->slot_of[x]; });
  return found == setup.end() ? no_part : *found;
}

bool Lists::joins(std::span<const Element> setup, Element y) const {
  return never_.empty() ||
         std::none_of(setup.begin(), setup.end(), [&](Element z) { return bit(never_[y], z); });
}

bool Lists::may_replace(Spot where, Element out, Element in) const {
  const std::span<const Element> now = setup(where);
  const View& own = view(where.bench);
  const Fitting& fitting = own.fitting;
  if (out == no_part && now.size() >= own.job->room()) {
    return false;
  }
  if (in == no_part && now.size() < 2) {
    return false;
  }
  if (fitting.has_slots()) {
    const std::size_t from = out == no_part ? fitting.slots() : fitting.slot(out);
    const std::size_t to = in == no_part ? fitting.slots() : fitting.slot(in);
    const auto there = [&](std::size_t slot) {
      return static_cast<std::uint64_t>(std::count_if(
          now.begin(), now.end(), [&](Element z) { return fitting.slot(z) == slot; }));
    };
    if (from != to && ((from < fitting.slots() && there(from) <= fitting.least(from)) ||
                       (to < fitting.slots() && there(to) >= fitting.most(to)))) {
      return false;
    }
  }
  const auto is_against = [&](Element z) { return z != out && bit(never_[in], z); };
  return in == no_part || ((never_.empty() || std::none_of(now.begin(), now.end(), is_against)) &&
                           (!own.values.of_model() || own.values.may_have(now, in)));
}

bool Lists::allows(std::size_t bench, std::span<const Element> setup) const {
  const View& own = view(bench);
  if (setup.empty() || setup.size() > own.job->room()) {
    return false;
  }
  for (const Element m : own.job->mounted) {
    if (std::find(setup.begin(), setup.end(), m) == setup.end()) {
      return false;
    }
  }
  for (std::size_t slot = 0; slot < own.fitting.slots(); ++slot) {
    const auto there = static_cast<std::uint64_t>(std::count_if(
        setup.begin(), setup.end(), [&](Element x) { return own.fitting.slot(x) == slot; }));
    if (there < own.fitting.least(slot) || there > own.fitting.most(slot)) {
      return false;
    }
  }
  return own.values.has_all(setup);
}

std::int64_t Lists::replacing_step(const View& view, const Place& from, const Place& to) const {
  gone_.clear();
  come_.clear();
  for (const Element x : from.elements) {
    if (!bit(to.bits, x)) {
      gone_.push_back(x);
    }
  }
  for (const Element x : to.elements) {
    if (!bit(from.bits, x)) {
      come_.push_back(x);
    }
  }
  if (!view.fitting.has_slots()) {
    return replaced(view, gone_, come_);
  }
  // Each slot separately.
  const auto slot = [&](Element x) { return view.fitting.slot(x); };
  std::ranges::sort(gone_, {}, slot);
  std::ranges::sort(come_, {}, slot);
  std::int64_t weight = 0;
  for (auto first = come_.begin(); first != come_.end();) {
    const auto end = std::ranges::upper_bound(first, come_.end(), slot(*first), {}, slot);
    const auto gone = std::ranges::equal_range(gone_, slot(*first), {}, slot);
    weight += replaced(view, {gone.begin(), gone.end()}, {first, end});
    first = end;
  }
  return weight;
}

std::int64_t Lists::replaced(const View& view, std::span<const Element> gone,
                             std::span<const Element> come) const {
  const std::size_t columns = std::max(gone.size(), come.size());
  table_.clear();
  for (const Element in : come) {
    for (const Element out : gone) {
      table_.push_back(view.replace[out * parts_ + in]);
    }
    table_.insert(table_.end(), columns - gone.size(),
                  static_cast<std::int64_t>(view.weights.change[in]));
  }
  return cheapest_assignment(come.size(), columns, table_);
}

std::int64_t Lists::step_of_values(const View& view, const Place& from, const Place& to) const {
  std::int64_t weight = 0;
  for (std::size_t p = 0; p < to.elements.size(); ++p) {
    const Element in = to.elements[p];
    const bool is_whole = from.elements.size() == to.elements.size();
    weight += price_of(view, is_whole ? from.elements[p] : rival_in(from.elements, in), in);
  }
  return weight;
}

std::int64_t Lists::step(const View& view, const Place& from, const Place& to) const {
  if (of_model()) {
    return step_of_values(view, from, to);
  }
  if (!view.replace.empty()) {
    return replacing_step(view, from, to);
  }
  std::int64_t weight = 0;
  for (const Element x : to.elements) {
    weight += bit(from.bits, x) ? 0 : static_cast<std::int64_t>(view.weights.change[x]);
  }
  return weight;
}

// Updates the cost of the step into a place, which may be after the last.
void Lists::price(Spot where) {
  if (where.at >= tests(where.bench)) {
    return;
  }
  const View& own = view(where.bench);
  Place& place = places_[order_[where.bench][where.at]];
  const std::int64_t now =
      static_cast<std::int64_t>(own.weights.test) + step(own, before(where), place);
  cost_[where.bench] += now - place.cost;
  total_ += now - place.cost;
  place.cost = now;
}

void Lists::meet(std::size_t index) {
  if (count_[index]++ == 0) {
    const std::uint32_t last = open_.back();
    open_[place_[index]] = last;
    place_[last] = place_[index];
    open_.pop_back();
    missing_ -= weight_.empty() ? one : weight_[index];
  }
}

void Lists::part(std::size_t index) {
  if (--count_[index] == 0) {
    place_[index] = static_cast<std::uint32_t>(open_.size());
    open_.push_back(static_cast<std::uint32_t>(index));
    missing_ += weight_.empty() ? one : weight_[index];
  }
}

// Updates the counts when x joins or leaves other parts.
template <bool coming>
void Lists::count_with(const Block& others, Element x) {
  const auto count = [&](std::size_t i) { coming ? meet(i) : part(i); };
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (!triples_) {
      count(index(x, others[i]));
      continue;
    }
    for (std::size_t j = 0; j < i; ++j) {
      count(index(x, others[i], others[j]));
    }
  }
}

// All of a set-up; with a value out of range, only what has that.
template <bool coming>
void Lists::count_all(const Block& setup) {
  Block others;
  others.reserve(setup.size());
  if (const Element hiding = hiding_in(setup); hiding != no_part) {
    std::ranges::remove_copy(setup, std::back_inserter(others), hiding);
    count_with<coming>(others, hiding);
    return;
  }
  for (const Element x : setup) {
    count_with<coming>(others, x);
    others.push_back(x);
  }
}

// A value takes the place of another of its parameter.
void Lists::replace_value(Place& place, Element out, Element in) {
  if (!hides_.empty() && (hides_[in] || hiding_in(place.elements) != no_part)) {
    count_all<false>(place.elements);
    *std::ranges::find(place.elements, out) = in;
    count_all<true>(place.elements);
  } else {
    others_.clear();
    std::ranges::remove_copy(place.elements, std::back_inserter(others_), out);
    count_with<false>(others_, out);
    count_with<true>(others_, in);
    *std::ranges::find(place.elements, out) = in;
  }
  place.bits[out >> 6] &= ~(std::uint64_t{1} << (out & 63));
  place.bits[in >> 6] |= std::uint64_t{1} << (in & 63);
}

void Lists::do_replace(Spot where, Element out, Element in) {
  changed(where);
  Place& place = places_[order_[where.bench][where.at]];
  overlap_ -= overlap_of(where.bench, place);
  if (of_model()) {
    replace_value(place, out, in);
    in = out = no_part;
  }
  if (out != no_part) {
    *std::find(place.elements.begin(), place.elements.end(), out) = place.elements.back();
    place.elements.pop_back();
    place.bits[out >> 6] &= ~(std::uint64_t{1} << (out & 63));
    count_with<false>(place.elements, out);
  }
  if (in != no_part) {
    count_with<true>(place.elements, in);
    place.elements.push_back(in);
    place.bits[in >> 6] |= std::uint64_t{1} << (in & 63);
  }
  overlap_ += overlap_of(where.bench, place);
  price(where);
  price({where.bench, where.at + 1});
}

void Lists::attach(Spot where, std::uint32_t handle, bool timed) {
  changed(where);
  std::vector<std::uint32_t>& order = order_[where.bench];
  order.insert(order.begin() + static_cast<std::ptrdiff_t>(where.at), handle);
  places_[handle].cost = 0;
  price(where);
  price({where.bench, where.at + 1});
  ++tests_;
  if (!scarce_.empty() && !timed) {
    set_time(where);
  }
  overlap_ += overlap_of(where.bench, places_[handle]);
}

std::uint32_t Lists::detach(Spot where) {
  changed(where);
  std::vector<std::uint32_t>& order = order_[where.bench];
  const std::uint32_t handle = order[where.at];
  overlap_ -= overlap_of(where.bench, places_[handle]);
  cost_[where.bench] -= places_[handle].cost;
  total_ -= places_[handle].cost;
  order.erase(order.begin() + static_cast<std::ptrdiff_t>(where.at));
  price(where);
  --tests_;
  return handle;
}

std::uint32_t Lists::new_place(std::span<const Element> setup) {
  std::uint32_t handle = 0;
  if (free_.empty()) {
    handle = static_cast<std::uint32_t>(places_.size());
    places_.emplace_back();
  } else {
    handle = free_.back();
    free_.pop_back();
  }
  fill(places_[handle], setup);
  return handle;
}

void Lists::replace(Spot where, Element out, Element in) {
  do_replace(where, out, in);
  notes_.push_back({Kind::replaced, where, out, in});
}

void Lists::take_out(Spot where) {
  const std::uint32_t handle = detach(where);
  count_all<false>(places_[handle].elements);
  notes_.push_back({Kind::taken_out, where, handle, 0});
}

void Lists::insert(Spot where, std::span<const Element> setup) {
  const std::uint32_t handle = new_place(setup);
  attach(where, handle);
  count_all<true>(places_[handle].elements);
  notes_.push_back({Kind::inserted, where, handle, 0});
}

void Lists::move(Spot from, std::size_t count, Spot to) {
  std::vector<std::uint32_t> handles;
  for (std::size_t i = 0; i < count; ++i) {
    handles.push_back(detach(from));
    const Place& place = places_[handles.back()];
    notes_.push_back({Kind::detached, from, handles.back(), 0, place.begin, place.end});
  }
  for (std::size_t i = 0; i < count; ++i) {
    attach({to.bench, to.at + i}, handles[i]);
    notes_.push_back({Kind::attached, {to.bench, to.at + i}, handles[i], 0});
  }
}

void Lists::reverse(std::size_t bench, Stretch where) {
  do_reverse(bench, where);
  notes_.push_back(
      {Kind::reversed, {bench, where.first}, static_cast<std::uint32_t>(where.last), 0});
}

void Lists::keep() {
  for (const Note& note : notes_) {
    if (note.kind == Kind::taken_out) {
      free_.push_back(note.a);
    }
  }
  if (clock_ && !notes_.empty()) {
    clock_kept_ = clocked_;
    if (clocked_) {
      clock_->keep();
    }
  }
  notes_.clear();
}

void Lists::undo() {
  for (; !notes_.empty(); notes_.pop_back()) {
    const Note& note = notes_.back();
    switch (note.kind) {
      case Kind::replaced:
        do_replace(note.where, note.b, note.a);
        break;
      case Kind::taken_out:
        attach(note.where, note.a, true);
        count_all<true>(places_[note.a].elements);
        break;
      case Kind::inserted:
        count_all<false>(places_[detach(note.where)].elements);
        free_.push_back(note.a);
        break;
      case Kind::detached:
        places_[note.a].begin = note.begin;
        places_[note.a].end = note.end;
        attach(note.where, note.a, true);
        break;
      case Kind::attached:
        (void)detach(note.where);
        break;
      case Kind::reversed:
        do_reverse(note.where.bench, {note.where.at, note.a});
        break;
    }
  }
  if (clock_ && clock_kept_) {
    clock_->undo();
    clocked_ = true;
  }
}

}  // namespace changeover
