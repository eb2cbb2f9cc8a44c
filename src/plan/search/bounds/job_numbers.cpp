#include "plan/search/bounds/job_numbers.hpp"

#include <algorithm>
#include <numeric>

#include "core/checked.hpp"
#include "plan/job/pair_numbers.hpp"

namespace changeover {
namespace {

// The colours of a greedy colouring of the graph of pairs that may meet: no clique is larger.
std::uint64_t clique_bound(const Job& job, const std::vector<Element>& parts) {
  std::vector<std::vector<Element>> classes;
  for (const Element x : parts) {
    const auto fitting = std::find_if(classes.begin(), classes.end(), [&](const auto& members) {
      return std::all_of(members.begin(), members.end(),
                         [&](Element y) { return job.never.contains(x, y); });
    });
    if (fitting == classes.end()) {
      classes.push_back({x});
    } else {
      fitting->push_back(x);
    }
  }
  return classes.size();
}

// The limits of the slots for parts of F, and what the slots need in addition.
void add_slots(const Job& job, const std::vector<bool>& mounted, JobNumbers& n) {
  const std::size_t slots = job.slots.size();
  n.slot_of.assign(job.names.size(), static_cast<std::uint32_t>(slots));
  for (Element x = 0; x < job.slot_of.size(); ++x) {
    n.slot_of[x] = job.slot_of[x] == no_slot ? n.slot_of[x] : job.slot_of[x];
  }
  std::vector<std::vector<Element>> members(slots + 1);  // of F
  for (const Element x : n.parts) {
    members[n.slot_of[x]].push_back(x);
  }
  n.most.push_back(0);
  n.room = job.room() - job.mounted.size();
  std::uint64_t all = 0;
  for (std::size_t s = 0; s <= slots; ++s) {
    std::uint64_t most = clique_bound(job, members[s]);
    if (s < slots) {
      std::uint64_t stay = 0;
      std::uint64_t on_bench = 0;    // parts that may go, with a needed pair or without
      std::uint64_t idle_there = 0;  // of these on the bench, without one
      std::vector<Amount> idle;      // costs of parts to be mounted without a needed pair
      for (Element x = 0; x < job.parts(); ++x) {
        if (n.slot_of[x] != s) {
          continue;
        }
        stay += mounted[x] ? 1U : 0U;
        on_bench += !mounted[x] && n.at_start[x] ? 1U : 0U;
        if (!mounted[x] && n.degree[x] == 0) {
          idle_there += n.at_start[x] ? 1U : 0U;
          if (!n.at_start[x]) {
            idle.push_back(job.change_costs[x]);
          }
        }
      }
      const Slot& slot = job.slots[s];
      most = std::min(most, slot.most - std::min(slot.most, stay));
      const std::uint64_t rest = slot.least - std::min(slot.least, stay);
      const std::uint64_t by_idle = rest - std::min<std::uint64_t>(rest, members[s].size());
      n.room -= std::min(n.room, by_idle);
      std::sort(idle.begin(), idle.end());
      for (std::uint64_t i = idle_there; i < by_idle; ++i) {
        n.mounting += idle[static_cast<std::size_t>(i - idle_there)];
        ++n.mounted_introductions;
      }
      const std::uint64_t others = idle.size() + on_bench;
      n.first += rest - std::min(rest, others);
    }
    n.most.insert(n.most.end() - 1, most);
    all += most;
  }
  n.most.pop_back();
  n.room = std::min(n.room, all);
}

}  // namespace

JobNumbers numbers_of(const Job& job) {
  JobNumbers n;
  std::vector<bool> mounted(job.names.size());
  for (const Element m : job.mounted) {
    mounted[m] = true;
  }
  n.at_start.resize(job.names.size());
  for (const Element x : job.start) {
    n.at_start[x] = true;
  }
  for (const Element m : job.mounted) {
    if (!n.at_start[m]) {
      n.mounting += job.change_costs[m];
      ++n.mounted_introductions;
    }
  }
  n.degree.resize(job.names.size());
  n.inner.resize(job.names.size());
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    ++n.degree[x];
    ++n.degree[y];
    if (!mounted[x] && !mounted[y]) {
      ++n.pairs;
      ++n.inner[x];
      ++n.inner[y];
      n.start_pairs += n.at_start[x] && n.at_start[y] ? 1U : 0U;
    }
  });
  for (Element x = 0; x < job.parts(); ++x) {
    if (!mounted[x]) {
      n.start += n.at_start[x] ? 1U : 0U;
      if (n.degree[x] > 0) {
        n.parts.push_back(x);
      }
    }
  }
  add_slots(job, mounted, n);
  n.room = std::min(n.room, clique_bound(job, n.parts));
  if (job.start.empty() && n.pairs == job.needed.size()) {
    n.first = std::max<std::uint64_t>(n.first, 2);  // each needed pair consists of two parts of F
  } else if (job.start.empty() && !n.parts.empty()) {
    n.first =
        std::max<std::uint64_t>(n.first, 1);  // one set-up contains all pairs of mounted parts
  }
  return n;
}

std::uint64_t most_pairs(const JobNumbers& n, std::uint64_t tests, std::uint64_t introductions) {
  return most_by_steps(
      n.room, tests, introductions,
      [&](std::uint64_t j) {
        const std::uint64_t kept = std::min(n.start, n.room - j);
        return choose_two(j) + j * kept + std::min(choose_two(kept), n.start_pairs);
      },
      [&](std::uint64_t j) { return choose_two(j) + j * (n.room - j); });
}

std::uint64_t unit_of_costs(const Job& job) {
  std::uint64_t unit = job.test_cost.millionths;
  for (const Amount each : job.change_costs) {
    unit = std::gcd(unit, each.millionths);
  }
  for (const Amount each : job.replace_costs) {
    unit = std::gcd(unit, each.millionths);
  }
  return unit;
}

Amount rounded_up(const Job& job, Amount cost) {
  const std::uint64_t unit = unit_of_costs(job);
  return unit == 0 ? cost : Amount{unit} * ceil_div(cost.millionths, unit);
}

}  // namespace changeover
