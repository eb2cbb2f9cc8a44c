#include "plan/request/asked_benches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "plan/job/bench_jobs.hpp"
#include "plan/job/bench_list.hpp"
#include "plan/job/setups/setup_list.hpp"

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

// The first set-ups of a model. None can have a value that is left out from now on.
std::vector<Block> first_of_model(Input& input, const OldListOptions& options, const Job& job) {
  DoneList list = read_first_list(input, *options.all_values, job.at_once);
  if (options.notes != nullptr) {
    options.notes->insert(options.notes->end(), list.notes.begin(), list.notes.end());
  }
  for (DoneRow& row : list.rows) {
    for (const Element x : row.setup) {
      if ((*options.left)(Block{x}).empty()) {
        fail(input.name(), {row.line, 1},
             fmt::format("{} is left out from now on; set another value, or leave this one open",
                         options.all_values->names[x]));
      }
    }
    row.setup = (*options.left)(row.setup);
  }
  return checked_first(input.name(), std::move(list), job);
}

// Parts that broke are in no set-up.
void note_left_out(const std::string& name, const DoneList& list, const OldListOptions& options) {
  Block without;
  for (const DoneRow& row : list.rows) {
    for (const Element x : row.setup) {
      if ((*options.left)(Block{x}).empty() && !contains(without, x)) {
        without.push_back(x);
      }
    }
  }
  if (!without.empty() && options.notes != nullptr) {
    options.notes->push_back(fmt::format("{}: left out from now on, so not in its set-ups: {}",
                                         name, parts_text(without, *options.names)));
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

void take_first(Input& input, const OldListOptions& options, Job& job,
                std::vector<Bench>& benches) {
  if (job.model != nullptr) {
    job.first = first_of_model(input, options, job);
    return;
  }
  const DoneList list =
      read_first_list(input, *options.names, most_at_once(job, benches), options.gone);
  note_left_out(input.name(), list, options);
  for (const DoneRow& row : list.rows) {
    const Place place{row.line, 1};
    const Block setup = (*options.left)(row.setup);
    if (setup.empty() && (row.lacks || !row.setup.empty())) {
      continue;
    }
    const std::string& name = row.bench;
    const auto bench = find_bench(benches, name);
    if (!name.empty() && !bench) {
      fail(input.name(), place,
           fmt::format("there is no bench {}; give the name or the number of one", shown(name)));
    }
    if (bench || benches.empty()) {
      if (const auto defect =
              setup_defect(bench ? job_of_bench(job, benches[*bench]) : job, setup)) {
        fail(input.name(), place, *defect);
      }
    }
    if (!bench) {
      job.first.push_back(setup);
      continue;
    }
    std::optional<std::vector<Block>>& own = benches[*bench].first;
    own = own.value_or(std::vector<Block>());
    own->push_back(setup);
  }
  for (Bench& bench : benches) {
    if (bench.first) {
      bench.first->insert(bench.first->begin(), job.first.begin(), job.first.end());
    }
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
