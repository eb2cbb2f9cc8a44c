#include "plan/request/asked_benches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/job/bench_list.hpp"

namespace changeover {
namespace {

// A part that broke is mounted no more, but a machine whose value is gone has nothing to run.
void check_mounted_left(const Bench& bench, const std::string& name, const std::string& list,
                        const OldListOptions& options) {
  const Block mounted = bench.mounted.value_or(Block());
  for (const Element x : mounted) {
    if (options.all_values != nullptr && !bench.down && (*options.left)(Block{x}).empty()) {
      throw BadInput(fmt::format(
          "{}: bench {} always has {}, which is left out from now on; mark the bench down, or "
          "change what is mounted there",
          list, shown(name), options.all_values->names[x]));
    }
  }
}

}  // namespace

std::vector<Bench> listed_benches(Input& input, const OldListOptions& options) {
  const PartNames names =
      options.all_values != nullptr ? PartNames(*options.all_values) : PartNames(*options.names);
  std::vector<Bench> benches = read_benches(input, names, options.gone, options.notes);
  const PartsLeft& left = *options.left;
  for (std::size_t b = 0; b < benches.size(); ++b) {
    Bench& bench = benches[b];
    check_mounted_left(bench, name_of(benches, b), input.name(), options);
    bench.own = left(bench.own);
    bench.without = left(bench.without);
    for (std::optional<Block>* parts : {&bench.mounted, &bench.start}) {
      if (*parts) {
        *parts = left(**parts);
      }
    }
  }
  return benches;
}

std::uint64_t most_at_once(const Job& job, const std::vector<Bench>& benches) {
  std::uint64_t most = job.at_once;
  for (const Bench& bench : benches) {
    most = std::max(most, bench.at_once.value_or(0));
  }
  return most;
}

void check_benches(const Job& job, const std::vector<Bench>& benches, const std::string& file) {
  std::vector<std::string> found = bench_defects(job, benches);
  if (found.empty() &&
      std::ranges::all_of(benches, [](const Bench& bench) { return bench.down; })) {
    found.emplace_back("all benches are down, so nothing can be tested; mark at least one as up");
  }
  if (!found.empty()) {
    throw BadInput((file.empty() ? "" : (file == "-" ? "<stdin>" : file) + ": ") +
                   leading_defect(found));
  }
}

std::uint64_t drop_impossible_triples(Job& job, const std::vector<Bench>& benches) {
  if (benches.empty()) {
    return 0;
  }
  std::set<Triple> possible;
  for (const Bench& bench : benches) {
    if (!bench.down) {
      const Job own = job_of_bench(job, bench);
      possible.insert(own.triples.begin(), own.triples.end());
    }
  }
  const std::uint64_t all = job.triples.size();
  std::erase_if(job.triples, [&](const Triple& t) { return possible.count(t) == 0; });
  drop_met_triples(job, Meetings(job.parts(), true));
  return all - job.triples.size();
}

void drop_overdrawn(const Job& job, std::vector<Bench>& benches, std::vector<std::string>& notes) {
  for (Element x = 0; x < job.quantities.size(); ++x) {
    std::vector<std::size_t> there;
    std::string where;
    for (std::size_t i = 0; i < benches.size(); ++i) {
      if (!benches[i].down && !contains(benches[i].own, x) &&
          contains(benches[i].start.value_or(job.start), x)) {
        where += (there.empty() ? "" : ", ") + name_of(benches, i);
        there.push_back(i);
      }
    }
    if (there.size() <= job.quantities[x]) {
      continue;
    }
    for (const std::size_t i : there) {
      Block start = benches[i].start.value_or(job.start);
      std::erase(start, x);
      benches[i].start = std::move(start);
    }
    notes.push_back(
        fmt::format("{} was in the last test of {}, but there {} {}: the sheets have it taken out, "
                    "and put in where it is needed",
                    job.names[x], where, job.quantities[x] == 1 ? "is" : "are", job.quantities[x]));
  }
}

}  // namespace changeover
