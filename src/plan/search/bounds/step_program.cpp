#include "plan/search/bounds/step_program.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "bounds/short_stays.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

__extension__ using Whole = __int128;

constexpr int fraction_bits = 20;  // of prices in whole numbers
constexpr double largest_price = 0x1p76;
constexpr double slightly = 1e-6;                           // what rows are violated by
constexpr std::size_t most_numbers = std::size_t{1} << 23;  // of the table of a program: 64 MiB

}  // namespace

void StepProgram::set_costs(const Job& job) {
  for (std::size_t x = 0; x < v_; ++x) {
    costs_.push_back(q_->prices[x].millionths);
    starts_ += q_->at_start[x];
    base_ += q_->at_start[x] > 0 ? 0 : q_->prices[x].millionths;
  }
  costs_.push_back(job.test_cost.millionths);
  base_ += Whole{job.test_cost.millionths} * least_tests_;
  most_times_ = job.needed.size() + job.first.size() + 1;
  std::vector<std::uint64_t> exact = costs_;
  if (!exchanges_.empty()) {
    std::fill(exact.begin(), exact.end() - 1, 0);
    base_ = Whole{job.test_cost.millionths} * least_tests_;
  }
  exact.resize(counted_.columns());
  for (const Exchange& each : exchanges_) {
    exact.push_back(job.replace_cost(q_->parts[each.out], q_->parts[each.in]).millionths);
  }
  for (std::size_t x = 0; x < v_ && !exchanges_.empty(); ++x) {
    exact.push_back(job.change_costs[q_->parts[x]].millionths);
  }
  unit_ = std::max(1.0, static_cast<double>(*std::max_element(exact.begin(), exact.end())));
  std::vector<double> costs;
  costs.reserve(exact.size());
  for (const std::uint64_t cost : exact) {
    costs.push_back(static_cast<double>(cost) / unit_);
  }
  // A little more for each, so that no two choices cost the same and the method does not go round.
  std::uint64_t mixed = 1;
  for (double& cost : costs) {
    mixed = mixed * 6364136223846793005U + 1442695040888963407U;
    cost += 1e-8 * static_cast<double>(1 + (mixed >> 54U));
  }
  program_.emplace(costs);
}

void StepProgram::add_first_rows() {
  const std::int64_t before = starts_ > 0 ? 1 : 0;  // the start is a set-up, but no test
  const std::vector<PartGroup>& groups = counted_.groups();
  for (const StepBlock& block : counted_.blocks()) {
    steps_rows_.push_back(rows_.size());
    LeastSum::Row steps{{v_, 1}};
    for (std::size_t kind = 0; kind < block.kinds.size(); ++kind) {
      steps.push_back({block.first_column + kind, -1});
    }
    add(std::move(steps), 1 - before);
    for (std::size_t a = 0; a < block.groups.size(); ++a) {
      const PartGroup& group = groups[block.groups[a]];
      LeastSum::Row coming;
      for (const std::size_t x : group.parts) {
        coming.push_back({x, 1});
      }
      for (std::size_t kind = 0; kind < block.kinds.size(); ++kind) {
        if (block.kinds[kind][a] > 0) {
          coming.push_back(
              {block.first_column + kind, -static_cast<std::int64_t>(block.kinds[kind][a])});
        }
      }
      add(std::move(coming), static_cast<std::int64_t>(group.room));
      for (std::size_t b = 0; b <= a; ++b) {
        const std::uint64_t all = counted_.pairs(block.groups[a], block.groups[b]);
        const std::uint64_t first =
            a == b ? choose_two(group.room) : group.room * groups[block.groups[b]].room;
        if (all <= first) {
          continue;
        }
        LeastSum::Row met;
        for (std::size_t kind = 0; kind < block.kinds.size(); ++kind) {
          const std::uint64_t each = counted_.brought(block, kind, a, b);
          if (each > 0) {
            met.push_back({block.first_column + kind, static_cast<std::int64_t>(each)});
          }
        }
        add(std::move(met), static_cast<std::int64_t>(all - first));
      }
    }
  }
  LeastSum::Row all;
  for (std::size_t x = 0; x < v_; ++x) {
    all.push_back({x, 1});
  }
  add(std::move(all), static_cast<std::int64_t>(q_->least_introductions));
}

bool StepProgram::add_violated() {
  const std::vector<PartGroup>& groups = counted_.groups();
  bool any = add_few_stays();
  any = add_entries() || any;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    any = add_occupied(groups[a].parts, groups[a].in_a_test) || any;
    for (std::size_t b = 0; b < groups.size(); ++b) {
      const bool apart = groups[a].parts.size() < v_ && groups[b].parts.size() < v_;
      if (a != b && !apart) {
        continue;  // All parts are not beside those of a slot.
      }
      any = add_staying(a, b) || any;
      any = (a <= b && add_subsets(a, b)) || any;
    }
  }
  return any || add_side_by_side() || add_costliest();
}

// (3) of the theorem.
bool StepProgram::add_staying(std::size_t a, std::size_t b) {
  const std::vector<PartGroup>& groups = counted_.groups();
  const std::vector<StepBlock>& blocks = counted_.blocks();
  const auto block = std::find_if(blocks.begin(), blocks.end(), [&](const StepBlock& each) {
    return each.place_of(a) && each.place_of(b);
  });
  if (block == blocks.end()) {
    return false;
  }
  const std::uint64_t each = groups[b].room - (a == b ? 1 : 0);
  LeastSum::Row row;
  double open = 0;
  std::int64_t least = 0;
  for (const std::size_t x : groups[a].parts) {
    const double lacking =
        static_cast<double>(counted_.degree(x, b)) - static_cast<double>(each) * times(x);
    if (lacking > 0) {
      open += lacking;
      least += static_cast<std::int64_t>(counted_.degree(x, b));
      row.push_back({x, static_cast<std::int64_t>(each)});
    }
  }
  if (open <= slightly) {
    return false;
  }
  const std::size_t at_a = *block->place_of(a);
  const std::size_t at_b = *block->place_of(b);
  for (std::size_t kind = 0; kind < block->kinds.size(); ++kind) {
    const std::uint64_t met =
        (groups[a].room - block->kinds[kind][at_a]) * block->kinds[kind][at_b];
    if (met > 0) {
      open -= static_cast<double>(met) * program_->value(block->first_column + kind);
      row.push_back({block->first_column + kind, static_cast<std::int64_t>(met)});
    }
  }
  if (open <= slightly) {
    return false;
  }
  return add_if_room(std::move(row), least);
}

std::vector<std::size_t> StepProgram::by_times(std::size_t group) const {
  std::vector<std::size_t> parts = counted_.groups()[group].parts;
  std::stable_sort(parts.begin(), parts.end(),
                   [&](std::size_t x, std::size_t y) { return times(x) < times(y); });
  return parts;
}

// (4) of the theorem, for whole numbers: of the parts that come least often.
bool StepProgram::add_subsets(std::size_t a, std::size_t b) {
  const std::vector<PartGroup>& groups = counted_.groups();
  const std::vector<std::size_t> of_a = by_times(a);
  const std::vector<std::size_t> of_b = by_times(b);
  double most = slightly;
  std::size_t best_a = 0;
  std::size_t best_b = 0;
  std::int64_t least = 0;
  std::vector<std::uint64_t> met(of_b.size() + 1, 0);  // pairs of the first of a and those of b
  double times_a = 0;
  for (std::size_t s = 1; s <= of_a.size(); ++s) {
    times_a += times(of_a[s - 1]);
    std::uint64_t of_last = 0;
    double times_b = 0;
    for (std::size_t t = 1; t <= of_b.size(); ++t) {
      of_last += counted_.needed(of_a[s - 1], of_b[t - 1]) ? 1U : 0U;
      met[t] += of_last;
      times_b += times(of_b[t - 1]);
      const std::uint64_t c = std::min<std::uint64_t>(groups[a].room, s);
      const std::uint64_t d = std::min<std::uint64_t>(groups[b].room, t);
      if (a == b && s != t) {
        continue;
      }
      const std::uint64_t unit = a == b ? c - 1 : std::gcd(c, d);
      if (unit == 0) {
        continue;
      }
      const std::uint64_t must =
          unit * ceil_div(a == b ? met[t] / 2 + choose_two(c) : met[t] + c * d, unit);
      const double comes =
          a == b ? static_cast<double>(c - 1) * times_a
                 : static_cast<double>(d) * times_a + static_cast<double>(c) * times_b;
      if (static_cast<double>(must) - comes > most) {
        most = static_cast<double>(must) - comes;
        best_a = s;
        best_b = t;
        least = static_cast<std::int64_t>(must);
      }
    }
  }
  if (best_a == 0) {
    return false;
  }
  LeastSum::Row row;
  const std::uint64_t c = std::min<std::uint64_t>(groups[a].room, best_a);
  const std::uint64_t d = std::min<std::uint64_t>(groups[b].room, best_b);
  const std::uint64_t unit = a == b ? c - 1 : std::gcd(c, d);
  for (std::size_t s = 0; s < best_a; ++s) {
    row.push_back({of_a[s], static_cast<std::int64_t>(a == b ? 1 : d / unit)});
  }
  for (std::size_t t = 0; a != b && t < best_b; ++t) {
    row.push_back({of_b[t], static_cast<std::int64_t>(c / unit)});
  }
  return add_if_room(std::move(row), least / static_cast<std::int64_t>(unit));
}

// (6): of each group the parts that come least often, so many or up to so often.
bool StepProgram::add_side_by_side() {
  std::vector<std::vector<std::size_t>> all;  // by group that is not the whole
  std::vector<double> limits;
  std::size_t most = 0;
  for (std::size_t g = 0; g < counted_.groups().size(); ++g) {
    if (counted_.groups()[g].parts.size() < v_) {
      all.push_back(by_times(g));
      most = std::max(most, all.back().size());
    }
  }
  for (std::size_t x = 0; x < v_; ++x) {
    limits.push_back(times(x));
  }
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end(),
                           [](double a, double b) { return b - a < slightly; }),
               limits.end());
  SideBySide best;
  for (std::size_t number = 1; number <= most + limits.size() && all.size() > 2; ++number) {
    std::vector<std::vector<std::size_t>> sets = all;
    for (std::vector<std::size_t>& set : sets) {
      const auto end = number <= most
                           ? set.begin() + static_cast<std::ptrdiff_t>(std::min(number, set.size()))
                           : std::find_if(set.begin(), set.end(), [&](std::size_t x) {
                               return times(x) > limits[number - most - 1] + slightly;
                             });
      set.erase(end, set.end());
    }
    SideBySide found = side_by_side(sets);
    if (found.open > best.open) {
      best = std::move(found);
    }
  }
  if (best.open <= slightly) {
    return false;
  }
  LeastSum::Row row;
  for (const std::size_t x : best.parts) {
    row.push_back({x, 1});
  }
  return add_if_room(std::move(row), best.least);
}

// The row for some of these sets of parts, one of each group, those for which it is broken most.
StepProgram::SideBySide StepProgram::side_by_side(std::vector<std::vector<std::size_t>> sets) {
  const auto room = [&](const std::vector<std::size_t>& set) {
    const auto group = std::find_if(
        counted_.groups().begin(), counted_.groups().end(), [&](const PartGroup& each) {
          return each.parts.size() < v_ &&
                 std::find(each.parts.begin(), each.parts.end(), set.front()) != each.parts.end();
        });
    return std::min<std::uint64_t>(group->room, set.size());
  };
  std::erase_if(sets, [](const auto& set) { return set.empty(); });
  const std::uint64_t c = sets.empty() ? 0 : room(sets.front());
  std::erase_if(sets, [&](const auto& set) { return room(set) != c; });
  const std::size_t n = sets.size();
  const std::uint64_t numbers = v_ * v_ + n * n * n;
  if (n < 3 || numbers > work_) {
    return {};
  }
  work_ -= numbers;
  std::vector<std::int64_t> both(n * n);  // the most that two shares are together
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      std::uint64_t pairs = 0;
      for (const std::size_t x : sets[a]) {
        for (const std::size_t y : sets[b]) {
          pairs += counted_.needed(x, y) ? 1U : 0U;
        }
      }
      both[a * n + b] = static_cast<std::int64_t>(ceil_div(pairs, c) + c + 1);
    }
  }
  std::vector<std::size_t> taken(n);
  std::iota(taken.begin(), taken.end(), 0);
  std::vector<std::int64_t> share(n);
  std::vector<double> open(n);
  const auto idle = [&] {
    return std::min_element(taken.begin(), taken.end(),
                            [&](std::size_t a, std::size_t b) { return open[a] < open[b]; });
  };
  for (; taken.size() > 2; taken.erase(idle())) {
    for (const bool rest : {false, true}) {
      for (const std::size_t a : taken) {
        std::int64_t most = std::numeric_limits<std::int64_t>::max();
        for (const std::size_t b : taken) {
          const std::int64_t all = both[a * n + b];
          most = a == b ? most : std::min(most, rest ? all - share[b] : all / 2);
        }
        share[a] = most;
      }
    }
    for (const std::size_t a : taken) {
      open[a] = static_cast<double>(share[a]);
      for (const std::size_t x : sets[a]) {
        open[a] -= times(x);
      }
    }
    if (open[*idle()] >= 0) {
      break;
    }
  }
  SideBySide found{.open = -1, .least = -1};
  for (const std::size_t a : taken) {
    found.parts.insert(found.parts.end(), sets[a].begin(), sets[a].end());
    found.open += open[a];
    found.least += share[a];
  }
  return taken.size() > 2 ? found : SideBySide{};
}

// (5): a part is in as many tests as it comes, and in as many as its partners need.
bool StepProgram::add_occupied(const std::vector<std::size_t>& parts, std::uint64_t in_a_test) {
  LeastSum::Row row{{v_, static_cast<std::int64_t>(in_a_test)}};
  std::int64_t least = 0;
  double open = -static_cast<double>(in_a_test) * tests();
  for (const std::size_t x : parts) {
    const auto there = static_cast<std::int64_t>(q_->at_start[x]);
    const double comes = times(x) - static_cast<double>(there);
    if (comes > static_cast<double>(counted_.least_on(x))) {
      row.push_back({x, -1});
      least -= there;
      open += comes;
    } else {
      least += static_cast<std::int64_t>(counted_.least_on(x));
      open += static_cast<double>(counted_.least_on(x));
    }
  }
  if (open <= slightly) {
    return false;
  }
  return add_if_room(std::move(row), least);
}

// Theorem 5, for parts of which every two must meet.
bool StepProgram::add_few_stays() {
  bool any = false;
  for (std::uint64_t s = 1; s <= v_; ++s) {
    const std::uint64_t most = most_stays_short(s, std::max<std::uint64_t>(q_->room, 2));
    LeastSum::Row row;
    double short_of = 0;
    for (std::size_t x = 0; x < v_; ++x) {
      if (q_->together[x] && times(x) < static_cast<double>(s + 1)) {
        row.push_back({x, 1});
        short_of += static_cast<double>(s + 1) - times(x);
      }
    }
    if (short_of > static_cast<double>(most) + slightly) {
      const auto least = static_cast<std::int64_t>((s + 1) * row.size());
      any = add_if_room(std::move(row), least - static_cast<std::int64_t>(most)) || any;
    }
    if ((s + 1) * v_ < most) {
      break;
    }
  }
  return any;
}

// What comes takes the place of something or comes to an empty one; what goes has come; and what a
// slot must have has come to empty places.
void StepProgram::add_exchanges(const Job& job) {
  if (exchanges_.empty()) {
    return;
  }
  std::vector<LeastSum::Row> comes(v_);
  std::vector<LeastSum::Row> goes(v_);
  for (std::size_t i = 0; i < exchanges_.size(); ++i) {
    comes[exchanges_[i].in].push_back({exchange_column(i), 1});
    goes[exchanges_[i].out].push_back({exchange_column(i), -1});
  }
  for (std::size_t x = 0; x < v_; ++x) {
    comes[x].push_back({empty_column(x), 1});
    comes[x].push_back({x, -1});
    add(std::move(comes[x]), -static_cast<std::int64_t>(q_->at_start[x]));
    goes[x].push_back({x, 1});
    out_rows_.push_back(rows_.size());
    add(std::move(goes[x]), 0);
  }
  for (const PartGroup& group : counted_.groups()) {
    LeastSum::Row empty;
    std::uint64_t there = 0;
    const std::uint32_t slot =
        job.slots.empty() ? no_slot : job.slot_of[q_->parts[group.parts.front()]];
    for (const std::size_t x : group.parts) {
      empty.push_back({empty_column(x), 1});
      there += q_->at_start[x];
    }
    const std::uint64_t least = job.slots.empty() ? group.in_a_test
                                : slot == no_slot
                                    ? 0
                                    : std::min(job.slots[slot].least, group.in_a_test);
    if (least > there && (job.slots.empty() || group.parts.size() < v_)) {
      add(std::move(empty), static_cast<std::int64_t>(least - there));
    }
  }
}

// A set of parts, none of which is there at the start, is entered from others.
bool StepProgram::add_entries() {
  bool any = false;
  for (std::size_t to = 0; to < v_ && !exchanges_.empty(); ++to) {
    any = (q_->at_start[to] == 0 && add_entry(to)) || any;
  }
  return any;
}

// Adds the constraint that part `to` is reached at least once from a set, if the program's values
// break it: the set is a least cut, found by augmenting a flow until it is largest.
bool StepProgram::add_entry(std::size_t to) {
  const std::size_t source = v_;
  const std::size_t nodes = v_ + 1;
  std::vector<double> left(nodes * nodes, 0);
  for (std::size_t i = 0; i < exchanges_.size(); ++i) {
    left[exchanges_[i].out * nodes + exchanges_[i].in] += program_->value(exchange_column(i));
  }
  for (std::size_t x = 0; x < v_; ++x) {
    left[source * nodes + x] = program_->value(empty_column(x)) + (q_->at_start[x] > 0 ? 1.0 : 0.0);
  }
  double flow = 0;
  std::vector<std::size_t> from(nodes);
  for (;;) {
    std::fill(from.begin(), from.end(), nodes);
    from[source] = source;
    std::vector<std::size_t> reached{source};
    for (std::size_t i = 0; i < reached.size(); ++i) {
      for (std::size_t x = 0; x < v_; ++x) {
        if (from[x] == nodes && left[reached[i] * nodes + x] > slightly / 100) {
          from[x] = reached[i];
          reached.push_back(x);
        }
      }
    }
    if (from[to] == nodes) {
      break;
    }
    double more = 1;
    for (std::size_t x = to; x != source; x = from[x]) {
      more = std::min(more, left[from[x] * nodes + x]);
    }
    for (std::size_t x = to; x != source; x = from[x]) {
      left[from[x] * nodes + x] -= more;
      left[x * nodes + from[x]] += more;
    }
    flow += more;
    if (flow > 1 - 1e-3) {
      return false;
    }
  }
  std::vector<bool> set(v_);
  set[to] = true;
  std::vector<std::size_t> reaching{to};
  for (std::size_t i = 0; i < reaching.size(); ++i) {
    for (std::size_t x = 0; x < v_; ++x) {
      if (!set[x] && from[x] == nodes && left[x * nodes + reaching[i]] > slightly / 100) {
        set[x] = true;
        reaching.push_back(x);
      }
    }
  }
  if (std::any_of(entry_.begin(), entry_.end(),
                  [&](const auto& known) { return known.first == set; })) {
    return false;
  }
  LeastSum::Row row;
  for (std::size_t i = 0; i < exchanges_.size(); ++i) {
    if (!set[exchanges_[i].out] && set[exchanges_[i].in]) {
      row.push_back({exchange_column(i), 1});
    }
  }
  for (std::size_t x = 0; x < v_; ++x) {
    if (set[x]) {
      row.push_back({empty_column(x), 1});
    }
  }
  const std::size_t place = rows_.size();
  if (!add_if_room(std::move(row), 1)) {
    return false;
  }
  entry_.emplace_back(std::move(set), place);
  return true;
}

bool StepProgram::add_if_room(LeastSum::Row terms, std::int64_t least) {
  const std::uint64_t line = empty_column(exchanges_.empty() ? 0 : v_) + 1;
  const std::uint64_t numbers = (terms.size() + 1) * line;
  full_ = full_ || (rows_.size() + 1) * line > most_numbers || numbers > work_;
  if (!full_) {
    work_ -= numbers;
    add(std::move(terms), least);
  }
  return !full_;
}

ExchangePrices StepProgram::exchange_prices() const {
  ExchangePrices prices;
  for (const std::size_t row : out_rows_) {
    prices.out.push_back(program_->price(row) * unit_);
  }
  for (const auto& [parts, row] : entry_) {
    prices.entries.push_back({parts, program_->price(row) * unit_});
  }
  return prices;
}

Amount StepProgram::proved() const {
  std::vector<Whole> charged(counted_.columns(), 0);
  Whole sum = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double price = program_->price(i) * unit_ * static_cast<double>(1U << fraction_bits);
    if (!(price < largest_price)) {
      continue;  // Prices are a proof without this one, too, and sums do not overflow.
    }
    const auto whole = static_cast<Whole>(price);
    sum += whole * rows_[i].least;
    for (const LeastSum::Term& term : rows_[i].terms) {
      charged[term.column] += whole * term.factor;
    }
  }
  // Steps cost nothing: what one is charged too much, the row that counts them takes back.
  for (std::size_t b = 0; b < counted_.blocks().size(); ++b) {
    const StepBlock& block = counted_.blocks()[b];
    Whole most = 0;
    for (std::size_t kind = 0; kind < block.kinds.size(); ++kind) {
      most = std::max(most, charged[block.first_column + kind]);
    }
    charged[v_] += most;
    sum += most * rows_[steps_rows_[b]].least;
  }
  for (std::size_t j = 0; j <= v_; ++j) {
    const Whole left = (Whole{costs_[j]} << fraction_bits) - charged[j];
    sum += left < 0 ? left * most_times_ : 0;
  }
  const Whole cost = base_ + (sum > 0 ? sum >> fraction_bits : 0);
  constexpr Whole most = std::numeric_limits<std::int64_t>::max();
  if (cost > most) {
    throw ImpossibleParameters("the costs are too large to be added up; use a larger unit");
  }
  return Amount{static_cast<std::uint64_t>(cost)};
}

}  // namespace changeover
