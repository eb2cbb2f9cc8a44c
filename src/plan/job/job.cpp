#include "changeover/plan/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/job/setups/setup_list.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_defects = 10;
std::string pair_name(const Job& job, Element x, Element y) {
  return fmt::format("{} and {}", job.names[x], job.names[y]);
}

// Places that occur twice, or that contain a part that they cannot.
void find_malformed_places(const Job& job, std::vector<std::string>& found) {
  std::unordered_set<std::uint64_t> numbers;
  std::unordered_set<Element> parts;
  for (const MountedPlace& place : job.places) {
    const auto at_start = [&](Element x) {
      return std::ranges::find(job.start, x) != job.start.end();
    };
    if (place.number == 0 || !numbers.insert(place.number).second) {
      found.push_back(
          fmt::format("two places have the number {}; count them from 1", place.number));
    } else if (place.slot != no_slot && place.slot >= job.slots.size()) {
      found.push_back(fmt::format("place {} is in a slot that there is not", place.number));
    } else if (place.part && (*place.part >= job.parts() || !at_start(*place.part))) {
      found.push_back(
          fmt::format("place {} has a part that is not mounted at the start", place.number));
    } else if (place.part &&
               (!parts.insert(*place.part).second ||
                (job.slots.empty() ? no_slot : job.slot_of[*place.part]) != place.slot)) {
      found.push_back(fmt::format("{} cannot be in place {}: it is in another, or in another slot",
                                  job.names[*place.part], place.number));
    }
  }
}

// Faults that make further checks meaningless.
void find_malformed(const Job& job, std::vector<std::string>& found) {
  if (job.parts() < 2) {
    found.push_back("there are fewer than two parts; a pair needs two");
  }
  if (job.parts() > max_parts) {
    found.push_back(
        fmt::format("there are {} parts; at most {} are supported", job.parts(), max_parts));
  }
  if (job.at_once < 2) {
    found.push_back(fmt::format("{} at once: no pair can meet; give at least 2", job.at_once));
  }
  std::unordered_set<std::string> seen;
  std::unordered_set<std::string> looks;
  for (const std::string& name : job.names) {
    if (const auto defect = text_defect(name)) {
      found.push_back(fmt::format("the name {}: {}", shown(name), *defect));
    } else if (name.empty()) {
      found.push_back("a part has no name; name it");
    } else if (!seen.insert(name).second) {
      found.push_back(fmt::format("two parts are called {}; rename one", name));
    } else if (!looks.insert(visible(name)).second) {
      found.push_back(fmt::format(
          "a second part looks like {}: the names differ in what cannot be seen; rename one",
          name));
    }
  }
  if (job.change_costs.size() != job.parts() || job.needed.v() != job.parts() ||
      job.never.v() != job.parts()) {
    found.push_back("the number of change costs or the pairs do not fit the number of parts");
  }
  if (job.replaces() && job.replace_costs.size() != job.parts() * job.parts()) {
    found.push_back("the costs by what is replaced do not fit the number of parts");
  }
  const bool known_slots = job.slot_of.size() == (job.slots.empty() ? 0 : job.names.size()) &&
                           std::ranges::all_of(job.slot_of, [&](std::uint32_t s) {
                             return s < job.slots.size() || s == no_slot;
                           });
  if (!known_slots) {
    found.push_back("the slots do not fit the parts");
  }
  if (job.model != nullptr) {
    if (auto defect = model_defect(job)) {
      found.push_back(*std::move(defect));
    }
  }
  const auto look_at = [&](const Block& block) {
    for (const Element x : block) {
      if (x >= job.parts()) {
        found.push_back("a mounted part is not in the parts list");
      } else if (std::ranges::count(block, x) > 1) {
        found.push_back(fmt::format("{} is mounted twice", job.names[x]));
      }
    }
  };
  const auto no_triple = [&](const Triple& t) {
    return t[0] >= t[1] || t[1] >= t[2] || t[2] >= job.parts();
  };
  if (!job.triples.empty() &&
      (job.parts() > max_parts_of_triples || std::ranges::any_of(job.triples, no_triple))) {
    found.push_back(fmt::format("triples are of three parts in their order, of at most {}",
                                max_parts_of_triples));
  }
  if (std::ranges::any_of(job.barred, [&](Element x) { return x >= job.parts(); }) ||
      (job.model == nullptr && !job.barred.empty())) {
    found.push_back("what is barred are not values of the model");
  }
  look_at(job.mounted);
  look_at(job.start);
  std::ranges::for_each(job.first, look_at);
  if (known_slots) {
    find_malformed_places(job, found);
  }
}

// Slots with impossible numbers.
void find_impossible_slots(const Job& job, std::vector<std::string>& found) {
  std::uint64_t needed = job.mounted.size();
  for (std::size_t s = 0; s < job.slots.size(); ++s) {
    const Slot& slot = job.slots[s];
    const auto members = static_cast<std::uint64_t>(std::ranges::count(job.slot_of, s));
    const auto mounted = static_cast<std::uint64_t>(
        std::ranges::count_if(job.mounted, [&](Element x) { return job.slot_of[x] == s; }));
    const std::string name = shown(slot.name);
    if (slot.least > slot.most) {
      found.push_back(fmt::format("slot {} has at least {} and at most {}; write the least first",
                                  name, count_of(slot.least, "part"), slot.most));
    } else if (members == 0) {
      found.push_back(fmt::format("no part is in slot {}; name it as the parts list does", name));
    } else if (slot.least > members) {
      found.push_back(fmt::format(
          "slot {} needs {} in every set-up, but only {} listed; let it need fewer, or list more",
          name, count_of(slot.least, "part"), count_of(members, "is", "are")));
    } else if (mounted > slot.most && job.model == nullptr) {
      found.push_back(fmt::format("{} of slot {} {} mounted, but at most {} fit it; mount fewer",
                                  count_of(mounted, "part"), name, mounted == 1 ? "stays" : "stay",
                                  slot.most));
    } else {
      needed += slot.least - std::min(slot.least, mounted);
    }
  }
  if (found.empty() && needed > job.at_once) {
    found.push_back(fmt::format(
        "the slots{} need {} parts in every set-up, but only {} fit; need fewer, or let more fit",
        job.mounted.empty() ? "" : " and what stays mounted", needed, job.at_once));
  }
}

// Values of one parameter, of which a test of a model has only one.
void find_two_values(const Job& job, const Block& set, std::string_view how,
                     std::vector<std::string>& found) {
  for (std::size_t i = 0; i < set.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (job.slot_of[set[i]] == job.slot_of[set[j]]) {
        found.push_back(fmt::format("{} {}, but a test has one value of {}; keep one",
                                    pair_name(job, set[j], set[i]), how,
                                    job.slots[job.slot_of[set[i]]].name));
      }
    }
  }
}

void find_impossible(const Job& job, std::vector<std::string>& found) {
  if (job.start.size() > job.at_once) {
    found.push_back(fmt::format("{} parts are mounted at the start, but only {} fit; name fewer",
                                job.start.size(), job.at_once));
  }
  if (job.mounted.size() > job.at_once) {
    found.push_back(fmt::format("{} parts stay mounted, but only {} fit; name fewer",
                                job.mounted.size(), job.at_once));
  }
  for (std::size_t i = 0; i < job.mounted.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (job.never.contains(job.mounted[i], job.mounted[j])) {
        found.push_back(fmt::format("{} both stay mounted, but must never be in one set-up{}",
                                    pair_name(job, job.mounted[j], job.mounted[i]),
                                    why_forbidden(job, job.mounted[j], job.mounted[i])));
      }
    }
  }
  if (job.model != nullptr) {
    find_two_values(job, job.start, "are both set at the start", found);
    find_two_values(job, job.mounted, "both stay mounted", found);
  }
  find_impossible_slots(job, found);
  if (found.empty() && job.model != nullptr) {
    if (auto defect = no_setup_of_model(job)) {
      found.push_back(*std::move(defect));
    }
  }
  if (!found.empty()) {
    return;
  }
  for (std::size_t i = 0; i < job.first.size() && found.size() < most_defects; ++i) {
    if (const auto defect = setup_defect(job, job.first[i])) {
      found.push_back(fmt::format("set-up {} of those that come first: {}", i + 1, *defect));
    }
  }
  // By part: whether it stays mounted, and the first mounted part that it must never meet.
  std::vector<bool> stays(job.names.size());
  std::vector<std::optional<Element>> enemy(job.names.size());
  for (const Element m : job.mounted) {
    stays[m] = true;
    for (Element x = 0; x < job.parts(); ++x) {
      if (x != m && !enemy[x] && job.never.contains(m, x)) {
        enemy[x] = m;
      }
    }
  }
  const std::size_t mounted = job.mounted.size();
  const PairSet apart = cannot_meet(job);
  job.needed.for_each(all_of_them, [&](Element x, Element y) {
    if (found.size() >= most_defects) {
      return;
    }
    const std::size_t together = mounted + (stays[x] ? 0U : 1U) + (stays[y] ? 0U : 1U);
    if (job.never.contains(x, y)) {
      found.push_back(
          fmt::format("{} must meet and must never be in one set-up{}; remove the "
                      "pair from one of the lists",
                      pair_name(job, x, y), why_forbidden(job, x, y)));
    } else if (together > job.at_once) {
      found.push_back(fmt::format(
          "{} must meet, but beside the {} mounted there is no room for both; keep fewer parts "
          "mounted, or let more parts fit at once",
          pair_name(job, x, y),
          mounted == 1 ? "part that stays" : fmt::format("{} that stay", mounted)));
    } else if (apart.contains(x, y) && job.model != nullptr) {
      found.push_back(
          fmt::format("{} must meet, but no test of the model has both; leave the pair out, or "
                      "loosen the rules",
                      pair_name(job, x, y)));
    } else if (apart.contains(x, y) && !enemy[x] && !enemy[y]) {
      const bool all_tried = Fitting(job).simplest(with_mounted(job, {x, y})).all_tried;
      found.push_back(fmt::format(
          "{} must meet, but no set-up within the slots {}; let a slot hold more, or leave the "
          "pair out",
          pair_name(job, x, y),
          all_tried ? "can hold both" : "that holds both was found among 100,000 choices"));
    } else {
      for (const Element z : {x, y}) {
        if (enemy[z]) {
          found.push_back(fmt::format(
              "{} must meet, but {} must never be in one set-up with {}, which stays mounted{}; "
              "unmount it, or leave the pair out",
              pair_name(job, x, y), job.names[z], job.names[*enemy[z]],
              why_forbidden(job, z, *enemy[z])));
        }
      }
    }
  });
}

}  // namespace

bool Job::one_change_cost() const {
  return !replaces() && std::ranges::all_of(change_costs, [&](Amount cost) {
    return cost == change_costs.front();
  });
}

Job make_job(std::uint64_t v, std::uint64_t at_once, Amount test_cost, Amount change_cost) {
  if (v > max_parts) {
    throw BadInput(fmt::format("there are {} parts; at most {} are supported", v, max_parts));
  }
  Job job;
  for (std::uint64_t i = 1; i <= v; ++i) {
    job.names.push_back(fmt::format("{}", i));
  }
  job.at_once = at_once;
  job.test_cost = test_cost;
  job.change_costs.assign(static_cast<std::size_t>(v), change_cost);
  job.never = PairSet(v);
  job.needed = all_pairs_but(job.never);
  return job;
}

PairSet all_pairs_but(const PairSet& pairs) {
  PairSet rest(pairs.v());
  pairs.for_each_missing(all_of_them, [&](Element x, Element y) { rest.insert(x, y); });
  return rest;
}

std::vector<std::string> defects(const Job& job) {
  std::vector<std::string> found;
  find_malformed(job, found);
  if (found.empty()) {
    find_impossible(job, found);
  }
  found.resize(std::min(found.size(), most_defects));
  return found;
}

CheckedJob::CheckedJob(Job job) : job_(std::move(job)) { check(job_); }

void check(const Job& job) {
  const std::vector<std::string> found = defects(job);
  if (!found.empty()) {
    throw BadInput(leading_defect(found));
  }
}

std::optional<std::string> text_defect(std::string_view text) {
  auto defect = first_defect(text, false);
  return defect ? std::optional(std::move(defect->what)) : std::nullopt;
}

}  // namespace changeover
