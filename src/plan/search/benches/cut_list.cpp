#include "plan/search/benches/cut_list.hpp"

#include <algorithm>

#include "core/least_number.hpp"
#include "plan/search/benches/step_costs.hpp"

namespace changeover {

BenchLists cut_list(const Job& job, const std::vector<Block>& setups, std::size_t benches) {
  std::vector<std::uint64_t> going_on;          // by set-up: its cost after the one before
  std::vector<std::uint64_t> at_start_of_list;  // and at the beginning of a list
  std::uint64_t most = 0;
  for (const Amount cost : step_costs(job, setups)) {
    going_on.push_back(cost.millionths);
    most += going_on.back();
  }
  at_start_of_list.reserve(setups.size());
  for (const Block& setup : setups) {
    at_start_of_list.push_back(step_costs(job, {setup}).front().millionths);
  }
  // The beginnings of pieces if none costs more than the limit.
  const auto pieces = [&](std::uint64_t limit) {
    std::vector<std::size_t> begins;
    std::uint64_t cost = 0;
    for (std::size_t i = 0; i < setups.size(); ++i) {
      if (begins.empty() || cost + going_on[i] > limit) {
        begins.push_back(i);
        cost = at_start_of_list[i];
      } else {
        cost += going_on[i];
      }
    }
    return begins;
  };
  const std::uint64_t costliest =
      setups.empty() ? 0 : *std::max_element(at_start_of_list.begin(), at_start_of_list.end());
  const std::vector<std::size_t> begins = pieces(least_number(
      costliest, most, [&](std::uint64_t limit) { return pieces(limit).size() <= benches; }));
  BenchLists lists(benches);
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const std::size_t end = i + 1 < begins.size() ? begins[i + 1] : setups.size();
    lists[i].assign(setups.begin() + static_cast<std::ptrdiff_t>(begins[i]),
                    setups.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return lists;
}

BenchLists cut_list(const BenchField& field, const Job& job, const std::vector<Block>& setups) {
  BenchLists lists = cut_list(job, setups, field.size());
  if (!field.alike()) {
    const Lists rules(field.lists_job(field.most_tests()), BenchLists(field.size()));
    for (std::size_t w = 0; w < lists.size(); ++w) {
      std::erase_if(lists[w], [&](const Block& setup) { return !rules.allows(w, setup); });
    }
  }
  return lists;
}

}  // namespace changeover
