#include "plan/job/bench_jobs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <ranges>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "core/checked.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/small_letters.hpp"
#include "core/words.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_bench_defects = 10;

Amount multiplied(Amount cost, Amount factor) {
  constexpr std::uint64_t one = 1'000'000;
  const Wide product = Wide{cost.millionths} * factor.millionths;
  const auto said = [&] {
    return fmt::format("a change cost of {} times {}", to_string(cost), to_string(factor));
  };
  if (product % one != 0) {
    throw BadInput(said() + " has more than six decimals; change one of them");
  }
  constexpr Wide most = std::numeric_limits<std::int64_t>::max();
  if (product / one > most) {
    throw ImpossibleParameters(said() + " is too large; use a larger unit");
  }
  return Amount{static_cast<std::uint64_t>(product / one)};
}

void limit_slots(Job& own, const Bench& bench) {
  for (const Slot& limit : bench.slots) {
    const auto found = std::ranges::find(own.slots, limit.name, &Slot::name);
    if (found == own.slots.end()) {
      throw BadInput(
          fmt::format("there is no slot {}; name one of the job's slots", shown(limit.name)));
    }
    *found = limit;
  }
}

// Which parts a set-up of this bench can hold together.
class Holding {
 public:
  explicit Holding(const Job& own) : own_(&own), fitting_(own), joins_(own.names.size(), true) {
    for (const Element m : own.mounted) {
      for (Element x = 0; x < own.parts(); ++x) {
        joins_[x] = joins_[x] && (m == x || !own.never.contains(m, x));
      }
    }
    if (std::ranges::any_of(own.mounted, [&](Element m) { return !joins_[m]; })) {
      joins_.assign(joins_.size(), false);
    }
  }

  [[nodiscard]] bool can(std::initializer_list<Element> parts) const {
    std::size_t size = own_->mounted.size();
    for (const Element x : parts) {
      size += contains(own_->mounted, x) ? 0U : 1U;
      if (!joins_[x] || std::ranges::any_of(parts, [&](Element y) {
            return y < x && own_->never.contains(x, y);
          })) {
        return false;
      }
    }
    return size <= own_->room() &&
           (!fitting_.has_slots() ||
            fitting_.simplest(with_mounted(*own_, parts)).setup.has_value());
  }

 private:
  const Job* own_;
  Fitting fitting_;
  std::vector<bool> joins_;  // by part: nothing that stays mounted is against it
};

// The same for values of a model, by its rules.
void keep_possible_values(Job& own) {
  drop_needed(own, apart_in_choices(own));
  if (own.triples.empty()) {
    return;
  }
  own.triples = together_in_choices(own, own.triples);
  if (own.triples.empty()) {
    own.needed = PairSet(own.parts());
  }
  drop_met_triples(own, Meetings(own.parts(), true));  // their pairs only
}

// Keeps only pairs that can meet on this bench.
void keep_possible(Job& own) {
  if (own.model != nullptr) {
    keep_possible_values(own);
    return;
  }
  const Holding holding(own);
  PairSet pairs(own.parts());
  own.needed.for_each(all_of_them, [&](Element x, Element y) {
    stop_if_asked();
    if (holding.can({x, y})) {
      pairs.insert(x, y);
    }
  });
  own.needed = std::move(pairs);
  std::erase_if(own.triples, [&](const Triple& t) {
    stop_if_asked();
    return !holding.can({t[0], t[1], t[2]});
  });
}

// The job of a bench, with all needed pairs.
Job whole_job_of_bench(const Job& job, const Bench& bench) {
  Job own = job;
  own.quantities.clear();
  own.at_once = bench.at_once.value_or(job.at_once);
  own.test_cost = bench.test_cost.value_or(job.test_cost);
  for (std::vector<Amount>* const costs : {&own.change_costs, &own.replace_costs}) {
    for (Amount& cost : *costs) {
      cost = multiplied(cost, bench.change_factor);
    }
  }
  own.mounted = bench.mounted.value_or(job.mounted);
  own.start = bench.start.value_or(job.start);
  own.places = bench.places;
  own.first = bench.first.value_or(job.first);
  own.tests_done = bench.tests_done;
  own.last_step = bench.last_step;
  limit_slots(own, bench);
  const std::vector<bool> barred = barred_parts(job, bench);
  if (own.model != nullptr) {
    for (Element x = 0; x < barred.size(); ++x) {
      if (barred[x]) {
        own.barred.push_back(x);
      }
    }
    return own;
  }
  if (contains(barred, true)) {
    own.slot_of.resize(own.names.size(), no_slot);
    for (std::size_t x = 0; x < barred.size(); ++x) {
      own.slot_of[x] = barred[x] ? static_cast<std::uint32_t>(own.slots.size()) : own.slot_of[x];
    }
    own.slots.push_back({"not on this bench", 0, 0});
  }
  return own;
}

// The same without slots that are empty on this bench: a separate job has no such slots.
Job without_empty_slots(Job own) {
  std::vector<bool> is_kept;  // by slot
  std::ranges::transform(own.slots, std::back_inserter(is_kept),
                         [](const Slot& slot) { return slot.least > 0; });
  for (const std::uint32_t slot : own.slot_of) {
    if (slot != no_slot) {
      is_kept[slot] = true;
    }
  }
  std::vector<std::uint32_t> number(own.slots.size(), no_slot);
  std::vector<Slot> kept;
  for (std::uint32_t s = 0; s < own.slots.size(); ++s) {
    if (is_kept[s]) {
      number[s] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(own.slots[s]);
    }
  }
  for (std::uint32_t& slot : own.slot_of) {
    slot = slot == no_slot ? no_slot : number[slot];
  }
  own.slots = std::move(kept);
  if (own.slots.empty()) {
    own.slot_of.clear();
  }
  return own;
}

// What a bench cannot be asked where the parts are the values of a model.
std::optional<std::string> defect_with_model(const Job& job, const Bench& bench) {
  if (bench.at_once || !bench.slots.empty()) {
    return fmt::format(
        "{} has no meaning with a model, of whose parameters every test has one value each; leave "
        "it out, and give what the bench lacks as without",
        bench.at_once ? "at_once" : "slots");
  }
  const std::vector<bool> barred = barred_parts(job, bench);
  for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
    bool some = false;
    for (Element x = 0; x < job.parts(); ++x) {
      some = some || (job.slot_of[x] == s && !barred[x]);
    }
    if (!some) {
      return fmt::format("it has no value of {}; let it have one", shown(job.slots[s].name));
    }
  }
  return std::nullopt;
}

// What is wrong with one bench, for any needed pairs.
std::optional<std::string> defect_of(const Job& job, const Bench& bench) {
  for (const Block* parts : {&bench.own, &bench.without}) {
    for (const Element x : *parts) {
      if (x >= job.parts()) {
        return "it names a part that is not in the parts list";
      }
    }
  }
  for (const Element x : bench.own) {
    if (contains(bench.without, x)) {
      return fmt::format("{} is both in own and in without; remove it from one",
                         shown(job.names[x]));
    }
  }
  if (job.model != nullptr) {
    if (auto defect = defect_with_model(job, bench)) {
      return defect;
    }
  }
  if (bench.hours && bench.hours->millionths == 0) {
    return "it works no hours a day; give more than 0, or say that it is down";
  }
  if (bench.hours && *bench.hours > Amount{24'000'000}) {
    return fmt::format("{} hours a day; give at most 24", to_string(*bench.hours));
  }
  Job own;
  try {
    own = whole_job_of_bench(job, bench);
  } catch (const BadInput& fault) {
    return fault.what();
  } catch (const ImpossibleParameters& fault) {
    return fault.what();
  }
  const std::vector<bool> barred = barred_parts(job, bench);
  const auto barred_of = [&](const Block& parts) {
    return std::ranges::find_if(parts, [&](Element x) { return x < barred.size() && barred[x]; });
  };
  if (const auto x = barred_of(own.mounted); x != own.mounted.end()) {
    return fmt::format(
        "{} stays mounted, but the bench cannot have it; allow it there, or unmount it",
        job.names[*x]);
  }
  if (const auto x = barred_of(own.start); x != own.start.end()) {
    return fmt::format(
        "{} is mounted at the start, but the bench cannot have it; allow it there, or start "
        "without it",
        job.names[*x]);
  }
  for (const Block& setup : own.first) {
    if (const auto x = barred_of(setup); x != setup.end()) {
      return fmt::format(
          "a set-up that comes first has {}, which the bench cannot have; give it to another bench",
          job.names[*x]);
    }
  }
  own.needed = PairSet(own.parts());
  own.triples.clear();
  const std::vector<std::string> found = defects(without_empty_slots(std::move(own)));
  return found.empty() ? std::nullopt : std::optional(found.front());
}

void find_names_twice(const std::vector<Bench>& benches, std::vector<std::string>& found) {
  std::map<std::u32string, std::string> seen;  // sheets are found by names in any case
  for (std::size_t i = 0; i < benches.size(); ++i) {
    const std::string name = name_of(benches, i);
    if (const auto defect = text_defect(name)) {
      found.push_back(fmt::format("the name of bench {}: {}", i + 1, *defect));
      continue;
    }
    const auto [before, is_new] = seen.emplace(in_small_letters(name), name);
    if (!is_new) {
      found.push_back(before->second == name
                          ? fmt::format("two benches are called {}; rename one", name)
                          : fmt::format("the benches {} and {} differ only in capitals; rename one",
                                        before->second, name));
    }
  }
}

// Parts that are mounted at the start on more benches than there are pieces.
void find_overdrawn(const Job& job, const std::vector<Bench>& benches,
                    std::vector<std::string>& found) {
  for (Element x = 0; x < job.quantities.size(); ++x) {
    std::uint64_t there = 0;
    for (const Bench& bench : benches) {
      const Block& start = bench.start ? *bench.start : job.start;
      there += !bench.down && !contains(bench.own, x) && contains(start, x) ? 1U : 0U;
    }
    if (there > job.quantities[x]) {
      found.push_back(
          fmt::format("{} is mounted at the start on {}, but there {} {}; say what is "
                      "mounted where",
                      job.names[x], count_of(there, "bench", "benches"),
                      job.quantities[x] == 1 ? "is" : "are", job.quantities[x]));
    }
  }
}

}  // namespace

std::string name_of(const std::vector<Bench>& benches, std::size_t bench) {
  return benches[bench].name.empty() ? fmt::format("Bench {}", bench + 1) : benches[bench].name;
}

std::uint64_t costs_of_hour(const Job& job) {
  constexpr std::uint64_t sixty = 60;
  return job.cost_unit == CostUnit::minutes   ? sixty
         : job.cost_unit == CostUnit::seconds ? sixty * sixty
                                              : 1;
}

std::vector<Bench> benches_alike(std::uint64_t number) {
  return std::vector<Bench>(static_cast<std::size_t>(number));
}

std::vector<bool> barred_parts(const Job& job, const Bench& bench) {
  std::vector<bool> barred(job.names.size(), false);
  for (std::size_t x = 0; x < job.quantities.size(); ++x) {
    barred[x] = job.quantities[x] == 0;
  }
  for (const Element x : bench.own) {
    barred[x] = false;
  }
  for (const Element x : bench.without) {
    barred[x] = true;
  }
  return barred;
}

std::vector<std::size_t> benches_with_most_parts(const Job& job, const std::vector<Bench>& benches,
                                                 std::size_t most) {
  std::vector<std::pair<std::ptrdiff_t, std::size_t>> working;  // what each lacks, and its number
  for (std::size_t b = 0; b < benches.size(); ++b) {
    if (!benches[b].down) {
      working.emplace_back(std::ranges::count(barred_parts(job, benches[b]), true), b);
    }
  }
  std::ranges::sort(working);
  working.resize(std::min(working.size(), most));
  return {std::views::values(working).begin(), std::views::values(working).end()};
}

Job job_of_bench(const Job& job, const Bench& bench) {
  Job own = whole_job_of_bench(job, bench);
  keep_possible(own);
  return own;
}

Job job_of_bench(const Job& job, const Bench& bench, const PairSet& can_meet) {
  Job own = whole_job_of_bench(job, bench);
  own.needed = PairSet(job.parts());
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (can_meet.contains(x, y)) {
      own.needed.insert(x, y);
    }
  });
  return own;
}

Job job_by_itself(const Job& job, const Bench& bench) {
  return without_empty_slots(job_of_bench(job, bench));
}

PairSet cannot_meet(const Job& job, const std::vector<Bench>& benches) {
  PairSet left = job.needed;
  for (const Bench& bench : benches) {
    if (bench.down) {
      continue;
    }
    Job own = whole_job_of_bench(job, bench);
    own.needed = left;
    own.triples.clear();
    keep_possible(own);
    PairSet rest(job.parts());
    left.for_each(all_of_them, [&](Element x, Element y) {
      if (!own.needed.contains(x, y)) {
        rest.insert(x, y);
      }
    });
    left = std::move(rest);
  }
  return left;
}

std::vector<std::string> bench_defects(const Job& job, const std::vector<Bench>& benches) {
  if (benches.empty() || benches.size() > max_benches) {
    return {fmt::format("{} benches; give 1 to {}", benches.size(), max_benches)};
  }
  Job any = job;  // the conditions that hold on every bench
  any.needed = PairSet(any.parts());
  any.triples.clear();
  if (any.model == nullptr) {  // else slots are the parameters, of any bench
    any.slots.clear();
    any.slot_of.clear();
  }
  any.mounted.clear();
  any.start.clear();
  any.first.clear();
  std::vector<std::string> found = defects(any);
  if (!found.empty()) {
    return found;
  }
  if (!job.quantities.empty() && job.quantities.size() != job.parts()) {
    return {"the quantities do not fit the parts"};
  }
  find_names_twice(benches, found);
  bool some = false;
  for (std::size_t i = 0; i < benches.size() && found.size() < most_bench_defects; ++i) {
    if (benches[i].down) {
      continue;
    }
    some = true;
    if (const auto defect = defect_of(job, benches[i])) {
      found.push_back(fmt::format("{}: {}", name_of(benches, i), *defect));
    }
  }
  if (!some && job.needed.size() > 0) {
    found.emplace_back("all benches are down; nothing can be tested");
  }
  find_overdrawn(job, benches, found);
  if (!found.empty()) {
    found.resize(std::min(found.size(), most_bench_defects));
    return found;
  }
  cannot_meet(job, benches).for_each(most_bench_defects, [&](Element x, Element y) {
    found.push_back(
        job.never.contains(x, y)
            ? fmt::format("{} and {} must meet and must never be in one set-up; remove the pair "
                          "from one of the lists",
                          job.names[x], job.names[y])
            : fmt::format("{} and {} must meet, but no bench can hold both in one set-up; let a "
                          "bench have both",
                          job.names[x], job.names[y]));
  });
  if (found.empty() && !job.triples.empty()) {
    std::vector<Job> jobs;
    for (const Bench& bench : benches) {
      if (!bench.down) {
        jobs.push_back(job_of_bench(job, bench));
      }
    }
    for (const Triple& t : job.triples) {
      const bool can =
          std::ranges::any_of(jobs, [&](const Job& own) { return contains(own.triples, t); });
      if (!can && found.size() < most_bench_defects) {
        found.push_back(
            fmt::format("{}, {} and {} must meet, but no bench can hold all three in one set-up",
                        job.names[t[0]], job.names[t[1]], job.names[t[2]]));
      }
    }
  }
  return found;
}

}  // namespace changeover
