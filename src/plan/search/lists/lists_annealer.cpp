#include "plan/search/lists/lists_annealer.hpp"

#include <algorithm>

namespace changeover {
namespace {

constexpr double a_pair_weighs = 1e6;  // in millionths

// What overlaps cost: less than for how long they are, since one wait is often enough for several
// parts, and for later overlaps, too.
double cost_of_overlap(std::int64_t overlap) { return 0.15 * static_cast<double>(overlap); }

std::int64_t with_overlap(std::int64_t cost, const Lists& lists) {
  return cost + static_cast<std::int64_t>(cost_of_overlap(lists.overlap()));
}

}  // namespace

std::optional<Rank> rank_of(const Lists& lists, const ListsSearch& options) {
  const std::uint64_t tests = options.most_tests > 0 ? lists.tests() : 0;
  switch (options.aim) {
    case Aim::most_weight:
      return lists.total() <= options.budget
                 ? std::optional(Rank(lists.missing(), lists.total(), 0))
                 : std::nullopt;
    case Aim::least_largest:
      return lists.open() == 0
                 ? std::optional(Rank(tests, with_overlap(lists.largest(), lists), lists.total()))
                 : std::nullopt;
    case Aim::least_cost:
      break;
  }
  return lists.open() == 0
             ? std::optional(Rank(tests, with_overlap(lists.total(), lists), lists.largest()))
             : std::nullopt;
}

ListsAnnealer::ListsAnnealer(Lists& lists, const ListsSearch& options,
                             const ListsSchedule& schedule, Random& random)
    : lists_(&lists),
      options_(&options),
      schedule_(schedule),
      random_(&random),
      most_tests_(options.most_tests > 0
                      ? options.most_tests
                      : lists.tests() + std::min(lists.open() + 16, lists.tests() + 16)),
      everything_(static_cast<double>(options.everything) / a_pair_weighs),
      wide_(schedule.penalty > 0),
      cooling_(schedule.hot, schedule.cold, schedule.penalty) {
  cool(0);
  record();
}

std::uint64_t ListsAnnealer::run(std::uint64_t steps, RunControl& control) {
  constexpr std::uint64_t batch = 256;
  const auto began = control.elapsed();
  std::uint64_t step = 0;
  for (; step < steps && !lists_->movable().empty(); ++step) {
    if (step % batch == 0) {
      if (control.stop_wanted()) {
        break;
      }
      const double gone = schedule_.time ? (control.elapsed() - began) / *schedule_.time : 0.0;
      if (gone >= 1) {
        break;
      }
      cool(share_done(step, steps, gone));
      if (control.progress_due()) {
        control.tell({.phase = options_->phase, .steps = step, .missing = lists_->open()});
      }
    }
    wide_ ? move_widely() : move();
  }
  return step;
}

void ListsAnnealer::cool(double done) {
  const double open = static_cast<double>(lists_->missing()) / a_pair_weighs;
  const double met = std::max(1.0, everything_ - open);
  const double a_thing = std::max(1.0, static_cast<double>(lists_->total()) / met);
  cooling_.cool(done, {everything_, open, a_thing});
  lists_->retime();
  penalty_ = wide_ ? schedule_.penalty : cooling_.penalty() / a_pair_weighs;
  energy_ = energy();
}

// The cost or duration of the benches together, higher the more they differ, if that of one rises.
double ListsAnnealer::costs(const Lists::Rise& rise) const {
  const auto overlap = cost_of_overlap(lists_->overlap() + rise.overlap);
  const auto total = static_cast<double>(lists_->total() + rise.work + rise.other_work) + overlap;
  switch (options_->aim) {
    case Aim::most_weight:
      return total * 0.25 +
             schedule_.over * std::max(0.0, total - static_cast<double>(options_->budget));
    case Aim::least_largest: {
      const auto benches = static_cast<double>(lists_->benches());
      double sum = 0;
      double squares = 0;
      for (std::size_t bench = 0; bench < lists_->benches(); ++bench) {
        const auto end =
            static_cast<double>(lists_->end(bench) + (bench == rise.bench ? rise.work : 0) +
                                (bench == rise.other ? rise.other_work : 0));
        sum += end;
        squares += end * end;
      }
      constexpr double evenly = 2.0;
      const double mean = sum / benches;
      return sum + overlap + (mean > 0 ? evenly * (squares / mean - sum) : 0.0);
    }
    case Aim::least_cost:
      break;
  }
  return total;
}

double ListsAnnealer::energy() const {
  return costs({}) + penalty_ * static_cast<double>(lists_->missing());
}

void ListsAnnealer::record() {
  const auto rank = rank_of(*lists_, *options_);
  if (rank && (!best_rank_ || *rank < *best_rank_)) {
    best_rank_ = rank;
    best_ = lists_->lists();
  }
}

// The energy after a rise. With a clock no more than that: benches may wait, rest, and put in parts
// again.
double ListsAnnealer::least_energy(const Lists::Rise& rise) const {
  const double missing =
      penalty_ * static_cast<double>(static_cast<std::int64_t>(lists_->missing()) + rise.missing);
  if (!lists_->has_clock()) {
    return costs(rise) + missing;
  }
  const auto work = static_cast<double>(lists_->work() + rise.work + rise.other_work);
  return (options_->aim == Aim::most_weight ? work * 0.25 : work) + missing;
}

// Whether a move to this energy is too much; the same answer for all that is asked of one move.
bool ListsAnnealer::refuses(double now) {
  if (now <= energy_) {
    return false;
  }
  most_rise_ = most_rise_ ? most_rise_ : cooling_.most_rise(*random_);
  return now - energy_ > *most_rise_;
}

// The same before the move is made: if it is refused, that was all.
bool ListsAnnealer::refuses_unseen(const Lists::Rise& rise) {
  const bool refused = refuses(least_energy(rise));
  if (refused) {
    most_rise_.reset();
  }
  return refused;
}

void ListsAnnealer::decide() {
  // Most moves are refused for what they cost and leave open, without asking the clock.
  double now = least_energy({});
  bool refused = refuses(now);
  if (!refused && lists_->has_clock()) {
    now = energy();
    refused = refuses(now);
  }
  most_rise_.reset();
  if (refused) {
    lists_->undo();
    return;
  }
  const double rise = now - energy_;
  lists_->keep();
  energy_ = now;
  if (rise < 0 || lists_->open() == 0) {
    record();
  }
}

void ListsAnnealer::try_replacing(Spot where, Element out, Element in) {
  if (lists_->foresees() && refuses_unseen(lists_->rise_of_replace(where, out, in))) {
    return;
  }
  lists_->replace(where, out, in);
  decide();
}

// A movable part of a set-up; `no_part` if there is none besides those that stay.
Element ListsAnnealer::some_part_of(Spot where, std::span<const Element> staying) {
  const auto setup = lists_->setup(where);
  if (setup.empty()) {
    return no_part;
  }
  const Element x = setup[below(setup.size())];
  const bool stays = std::find(staying.begin(), staying.end(), x) != staying.end();
  return lists_->is_movable(where.bench, x) && !stays ? x : no_part;
}

// What would make place for `in`: of a model, the value of the same parameter.
Element ListsAnnealer::some_place_for(Element in, Spot where, std::span<const Element> staying) {
  if (!lists_->of_model()) {
    return some_part_of(where, staying);
  }
  const Element out = lists_->rival_in(lists_->setup(where), in);
  const bool stays = std::find(staying.begin(), staying.end(), out) != staying.end();
  return stays || out == no_part || !lists_->is_movable(where.bench, out) ? no_part : out;
}

void ListsAnnealer::move() {
  if (lists_->tests() == 0) {
    insert();
    return;
  }
  const std::size_t dice = below(128);
  if (dice < 66) {
    shift();
  } else if (dice < 80) {
    replace_one();
  } else if (dice < 94) {
    replace_one_aimed();
  } else if (dice < 100) {
    dice % 2 == 0 && lists_->open() > 0 ? exchange_aimed() : exchange();
  } else if (dice < 107) {
    take_out();
  } else if (dice < 111) {
    copy();
  } else if (dice < 113) {
    change_run();
  } else if (dice < 116) {
    insert();
  } else if (dice < 119) {
    reverse();
  } else {
    relocate();
  }
}

// For replacement costs, or if not all pairs can meet, single steps matter less.
void ListsAnnealer::move_widely() {
  if (lists_->tests() == 0) {
    insert();
    return;
  }
  const std::size_t dice = below(64);
  if (dice < 42) {
    dice % 2 == 0 && lists_->open() > 0 ? exchange_aimed() : exchange();
  } else if (dice < 48) {
    change_run();
  } else if (dice < 52) {
    take_out();
  } else if (dice < 57) {
    insert();
  } else if (dice < 59) {
    reverse();
  } else {
    relocate();
  }
}

// Some movable part of `in` that a set-up lacks; `no_part` if there is none.
Element ListsAnnealer::some_difference(std::span<const Element> in, Spot lacks, std::size_t bench) {
  const std::size_t begin = below(in.size() + 1);
  for (std::size_t i = 0; i < in.size(); ++i) {
    const Element x = in[begin + i < in.size() ? begin + i : begin + i - in.size()];
    if (!lists_->was_there(lacks, x) && lists_->is_movable(bench, x)) {
      return x;
    }
  }
  return no_part;
}

// A part stays for one more set-up and its replacement comes later, or it leaves earlier.
void ListsAnnealer::shift() {
  const Spot where = some_spot();
  const Spot after{where.bench, where.at + 1};
  const auto earlier = lists_->before_setup(where);
  const Element coming = some_difference(lists_->setup(where), where, where.bench);
  const Element leaving = lists_->of_model() && coming != no_part
                              ? lists_->rival_in(earlier, coming)
                              : some_difference(earlier, after, where.bench);
  const bool later = random_->one_in_two();
  if (later ? leaving == no_part : (coming == no_part || where.at == 0)) {
    return;
  }
  const Spot at{where.bench, later ? where.at : where.at - 1};
  const Element out = later ? coming : leaving;
  const Element in = later ? leaving : coming;
  if ((out == no_part && !has_room(at)) || !replaceable(at, out, in)) {
    return;
  }
  try_replacing(at, out, in);
}

// Some part in the place of another, in one set-up.
void ListsAnnealer::replace_one() {
  const Spot where = some_spot();
  const Element in = some_part();
  const Element out = some_place_for(in, where, {});
  if (out != no_part && lists_->is_movable(where.bench, in) && replaceable(where, out, in)) {
    try_replacing(where, out, in);
  }
}

void ListsAnnealer::replace_one_aimed() {
  if (lists_->open() == 0) {
    replace_one();
    return;
  }
  const std::vector<Element> target = some_target();
  const std::span<const Element> staying(target.data(), target.size() - 1);
  const Element in = target.back();
  const auto where = some_holder(staying);
  if (!where || !lists_->is_movable(where->bench, in)) {
    return;
  }
  const Element out = some_place_for(in, *where, staying);
  if (out != no_part && out != in && replaceable(*where, out, in)) {
    try_replacing(*where, out, in);
  }
}

void ListsAnnealer::exchange() {
  const Spot where = some_spot();
  const Element in = some_part();
  const Element out = some_place_for(in, where, {});
  if (out != no_part && lists_->is_movable(where.bench, in) && !lists_->holds(where, in)) {
    replace_around(where, out, in);
  }
}

// A set-up that contains all of these, searched for from a random place on.
std::optional<Spot> ListsAnnealer::some_holder(std::span<const Element> parts) {
  Spot where = some_spot();
  for (std::size_t left = lists_->tests(); left > 0; --left) {
    if (std::all_of(parts.begin(), parts.end(),
                    [&](Element x) { return lists_->holds(where, x); })) {
      return where;
    }
    ++where.at;
    while (where.at >= lists_->tests(where.bench)) {
      where = {where.bench + 1 < lists_->benches() ? where.bench + 1 : 0, 0};
    }
  }
  return std::nullopt;
}

// A target that has not met: its last part is added, those before it stay.
std::vector<Element> ListsAnnealer::some_target() {
  if (lists_->open() == 0) {  // a target that has met, to meet on another bench as well
    const auto there = lists_->setup(some_spot());
    std::vector<Element> target(there.begin(), there.end());
    while (target.size() > (lists_->of_triples() ? 3 : 2)) {
      target.erase(target.begin() + static_cast<std::ptrdiff_t>(below(target.size())));
    }
    return target;
  }
  const auto found = lists_->open_target(below(lists_->open()));
  std::vector<Element> target(found.begin(), found.end() - (lists_->of_triples() ? 0 : 1));
  std::swap(target[below(target.size())], target.back());
  return target;
}

void ListsAnnealer::exchange_aimed() {
  const std::vector<Element> target = some_target();
  const std::span<const Element> staying(target.data(), target.size() - 1);
  const Element in = target.back();
  const auto where = some_holder(staying);
  if (!where || !lists_->is_movable(where->bench, in) || lists_->holds(*where, in)) {
    return;
  }
  if (has_room(*where) && random_->one_in_two()) {
    replace_around(*where, no_part, in);
  } else if (const Element out = some_place_for(in, *where, staying); out != no_part) {
    replace_around(*where, out, in);
  }
}

bool ListsAnnealer::replaceable(Spot where, Element out, Element in) const {
  return (out == no_part || lists_->holds(where, out)) &&
         (in == no_part || !lists_->holds(where, in)) && lists_->may_replace(where, out, in);
}

// Here, and sometimes in set-ups before it, after it or both, as far as possible.
void ListsAnnealer::replace_around(Spot where, Element out, Element in) {
  if (!replaceable(where, out, in)) {
    return;
  }
  const std::size_t choice = below(4);
  lists_->replace(where, out, in);
  for (Spot at = where; (choice & 1U) != 0 && at.at > 0;) {
    --at.at;
    if (!replaceable(at, out, in)) {
      break;
    }
    lists_->replace(at, out, in);
  }
  for (Spot at = where; (choice & 2U) != 0 && at.at + 1 < lists_->tests(at.bench);) {
    ++at.at;
    if (!replaceable(at, out, in)) {
      break;
    }
    lists_->replace(at, out, in);
  }
  decide();
}

void ListsAnnealer::change_run() {
  const Spot where = some_spot();
  if (has_room(where) && random_->one_in_two()) {
    if (const Element in = some_part(); lists_->is_movable(where.bench, in)) {
      replace_around(where, no_part, in);
    }
  } else if (const Element out = some_part_of(where, {}); out != no_part) {
    replace_around(where, out, no_part);
  }
}

void ListsAnnealer::take_out() {
  const Spot where = some_spot();
  if (lists_->foresees() && refuses_unseen(lists_->rise_of_take_out(where))) {
    return;
  }
  lists_->take_out(where);
  decide();
}

// Repeats a set-up, sometimes with a part of an open target in place of another.
void ListsAnnealer::copy() {
  if (lists_->tests() >= most_tests_) {
    return;
  }
  Spot where = some_spot();
  Element out = no_part;
  Element in = no_part;
  if (lists_->open() > 0 && random_->one_in_two()) {
    const std::vector<Element> target = some_target();
    const std::span<const Element> staying(target.data(), target.size() - 1);
    const auto holder = some_holder(staying);
    if (!holder || !lists_->is_movable(holder->bench, target.back())) {
      return;
    }
    where = *holder;
    in = target.back();
    out = some_place_for(in, where, staying);
    if (out == no_part || !replaceable(where, out, in)) {
      return;
    }
  }
  const auto there = lists_->setup(where);
  Block setup(there.begin(), there.end());
  if (out != no_part) {
    *std::find(setup.begin(), setup.end(), out) = in;
  }
  lists_->insert({where.bench, where.at + 1}, setup);
  decide();
}

// Inserts a set-up with an open target, otherwise like the one next to it.
void ListsAnnealer::insert() {
  // If nothing is open, another set-up helps only if a target moves to another bench, or if going
  // by way of it is cheaper.
  const bool may_help = lists_->open() > 0 || lists_->benches() > 1 || lists_->job(0).replaces();
  if (!may_help || (lists_->open() == 0 && lists_->tests() == 0) ||
      lists_->tests() >= most_tests_) {
    return;
  }
  const std::vector<Element> target = some_target();
  Block setup;
  Spot at{below(lists_->benches()), 0};
  bool alone = true;
  if (lists_->tests() > 0) {
    const std::span<const Element> first(target.data(), 1);
    const auto holder = below(8) == 0 ? std::nullopt : some_holder(first);
    at = holder.value_or(some_spot());
    const auto beside = lists_->setup(at);
    setup.assign(beside.begin(), beside.end());
    at.at += random_->one_in_two() ? 1U : 0U;
    alone = false;
  }
  // Without neighbours, on any bench: what grows from it is cheap at first.
  if (below(lists_->benches() > 1 ? 3 : 12) == 0) {
    at.bench = below(lists_->benches());
    at.at = below(lists_->tests(at.bench) + 1);
    alone = true;
  }
  if (lists_->of_model()) {
    const auto whole = lists_->values(at.bench).around(setup, target);
    if (whole) {
      lists_->insert(at, *whole);
      decide();
    }
    return;
  }
  if (alone) {
    setup = lists_->job(at.bench).mounted;
  }
  for (const Element x : target) {
    if (!bring(at.bench, setup, x, target)) {
      return;
    }
  }
  if (const Fitting& fitting = lists_->fitting(at.bench); fitting.has_slots()) {
    const auto whole = fitting.completed(setup, {});
    if (!whole) {
      return;
    }
    setup = *whole;
  }
  lists_->insert(at, setup);
  decide();
}

// Mounts x in place of parts that it must not meet, of surplus parts of its slot, and of parts that
// have no room. Permanently mounted parts stay, so x cannot be added if one of them excludes it.
bool ListsAnnealer::bring(std::size_t bench, Block& setup, Element x,
                          const std::vector<Element>& target) {
  if (std::find(setup.begin(), setup.end(), x) != setup.end()) {
    return true;
  }
  const Job& job = lists_->job(bench);
  if (!lists_->joins(job.mounted, x)) {
    return false;
  }
  std::erase_if(setup, [&](Element z) { return job.never.contains(z, x); });
  const Fitting& fitting = lists_->fitting(bench);
  const auto of_slot = [&](std::size_t slot) {
    return static_cast<std::uint64_t>(std::count_if(
        setup.begin(), setup.end(), [&](Element z) { return fitting.slot(z) == slot; }));
  };
  const std::size_t slot = fitting.slot(x);
  const bool crowded = slot < fitting.slots() && of_slot(slot) >= fitting.most(slot);
  if (!crowded && setup.size() < job.room()) {
    setup.push_back(x);
    return true;
  }
  const std::size_t begin = below(setup.size() + 1);
  for (std::size_t i = 0; i < setup.size(); ++i) {
    Element& z = setup[(begin + i) % setup.size()];
    const bool may_go = lists_->is_movable(bench, z) &&
                        std::find(target.begin(), target.end(), z) == target.end() &&
                        (!crowded || fitting.slot(z) == slot);
    if (may_go) {
      z = x;
      return true;
    }
  }
  return false;
}

void ListsAnnealer::reverse() {
  const Spot where = some_spot();
  Stretch stretch{where.at, below(lists_->tests(where.bench))};
  if (stretch.first > stretch.last) {
    std::swap(stretch.first, stretch.last);
  }
  constexpr std::size_t longest = 64;
  stretch.last = std::min(stretch.last, stretch.first + longest);
  if (lists_->foresees() && refuses_unseen(lists_->rise_of_reverse(where.bench, stretch))) {
    return;
  }
  lists_->reverse(where.bench, stretch);
  decide();
}

// Moves a stretch elsewhere, sometimes reversed; moving a long one between benches is a cut.
void ListsAnnealer::relocate() {
  const Spot from = some_spot();
  const std::size_t after = lists_->tests(from.bench) - from.at;
  const std::size_t longest = below(4) == 0 ? 16 : 3;
  const std::size_t count = 1 + below(std::min<std::size_t>(after, longest));
  Spot to{below(lists_->benches()), 0};
  const std::size_t places = lists_->tests(to.bench) - (to.bench == from.bench ? count : 0) + 1;
  to.at = below(places);
  if (to.bench == from.bench && to.at == from.at) {
    return;
  }
  for (std::size_t i = 0; i < count && !lists_->alike(from.bench, to.bench); ++i) {
    if (!lists_->allows(to.bench, lists_->setup({from.bench, from.at + i}))) {
      return;
    }
  }
  const bool reversed = count > 1 && random_->one_in_two();
  if (lists_->foresees() && refuses_unseen(lists_->rise_of_move(from, count, to, reversed))) {
    return;
  }
  lists_->move(from, count, to);
  if (reversed) {
    lists_->reverse(to.bench, {to.at, to.at + count - 1});
  }
  decide();
}

}  // namespace changeover
