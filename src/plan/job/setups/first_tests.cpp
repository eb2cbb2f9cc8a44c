// Set-ups that must run first.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/plan/job.hpp"
#include "changeover/plan/model.hpp"
#include "core/contains.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/place.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {

std::string why_forbidden(const Job& job, Element x, Element y) {
  const std::string& why = job.why_never(x, y);
  return why.empty() ? "" : " (" + why + ")";
}

std::optional<std::string> setup_defect(const Job& job, const Block& setup) {
  if (setup.empty()) {
    return "no part is mounted; remove the set-up or complete it";
  }
  if (setup.size() > job.at_once) {
    return fmt::format("{} parts, but only {} fit at once; remove some", setup.size(), job.at_once);
  }
  for (const Element m : job.mounted) {
    if (std::ranges::find(setup, m) == setup.end()) {
      return fmt::format("{} stays mounted, but is not in this set-up; add it", job.names[m]);
    }
  }
  for (std::size_t i = 0; i < setup.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (job.never.contains(setup[i], setup[j])) {
        return fmt::format("{} and {} must never be in one set-up{}; remove one",
                           job.names[setup[j]], job.names[setup[i]],
                           why_forbidden(job, setup[j], setup[i]));
      }
    }
  }
  for (std::uint32_t s = 0; s < job.slots.size(); ++s) {
    const Slot& slot = job.slots[s];
    const auto is_in_it = [&](Element x) { return job.slot_of[x] == s; };
    if (slot.most == 0 && std::ranges::any_of(setup, is_in_it)) {  // a bench that cannot have it
      return fmt::format("{} cannot be mounted here; remove it",
                         job.names[*std::ranges::find_if(setup, is_in_it)]);
    }
    const auto there = static_cast<std::uint64_t>(std::ranges::count_if(setup, is_in_it));
    if (there < slot.least || there > slot.most) {
      const bool few = there < slot.least;
      return fmt::format("slot {} has {} here, but {} {} in every set-up; {}", shown(slot.name),
                         count_of(there, "part"), few ? "needs" : "holds at most",
                         few ? slot.least : slot.most,
                         few ? "add " + count_of(slot.least - there, "part") + " of it"
                             : "remove " + count_of(there - slot.most, "part") + " of it");
    }
  }
  for (const Element x : setup) {
    if (contains(job.barred, x)) {
      return fmt::format("{} cannot be set here; change it", job.names[x]);
    }
  }
  if (job.model != nullptr) {
    if (auto broken = broken_rule(*job.model, setup)) {
      return *broken + "; change one of its values";
    }
  }
  return std::nullopt;
}

namespace {

// Tests of a model may give only some of their values.
void complete_values(const Job& job, const std::string& name, const std::string& where,
                     DoneList& list) {
  ChoiceSolver solver(job);
  Block before = job.start;
  for (DoneRow& row : list.rows) {
    if (row.setup.size() < job.slots.size()) {
      auto completed = solver.completed(row.setup, before);
      if (!completed) {
        fail(name, {row.line, 1},
             where + "no test of the model has all of these values; change one, or leave it open");
      }
      row.setup = *std::move(completed);
    }
    before = row.setup;
  }
}

}  // namespace

DoneList read_first_list(Input& input, const PartNames& names, std::uint64_t at_once,
                         std::vector<std::string>* gone) {
  DoneList list = read_list(input, names, at_once, gone != nullptr);
  if (gone != nullptr) {
    *gone = list.gone;
  }
  if (list.rows.empty()) {
    fail(input.name(), {}, "no set-up is listed; write one set-up per line");
  }
  return list;
}

std::vector<Block> checked_first(const std::string& name, DoneList list, const Job& job,
                                 const std::string& bench) {
  const std::string where = bench.empty() ? "" : bench + ": ";
  if (job.model != nullptr) {
    complete_values(job, name, where, list);
  }
  for (const DoneRow& row : list.rows) {
    if (const auto defect = setup_defect(job, row.setup)) {
      fail(name, {row.line, 1}, where + *defect);
    }
  }
  return list.setups();
}

std::vector<Block> read_first(Input& input, const Job& job) {
  return checked_first(input.name(), read_first_list(input, job, job.at_once), job);
}

Job after_first(const Job& job) {
  if (job.first.empty()) {
    return job;
  }
  Job rest = job;
  rest.first.clear();
  Meetings met(job.parts(), !job.triples.empty());
  for (const Block& setup : job.first) {
    met.add(job, setup);
  }
  PairSet pairs(job.parts());
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (!met.met(x, y)) {
      pairs.insert(x, y);
    }
  });
  rest.needed = std::move(pairs);
  drop_met_triples(rest, met);
  rest.start = job.first.back();
  return rest;
}

}  // namespace changeover
