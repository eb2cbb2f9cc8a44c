#include <algorithm>
#include <bit>

#include "changeover/plan/diagnosis.hpp"
#include "plan/diagnosis/evidence.hpp"
#include "plan/job/prices.hpp"

namespace changeover {
namespace {

// Of the failed tests that no proven fault explains, one with the fewest suspects.
std::size_t easiest_failure(const Evidence& evidence, const std::vector<Suspect>& proven) {
  std::size_t best = evidence.failures().size();
  for (std::size_t i = 0; i < evidence.failures().size(); ++i) {
    const bool is_explained = std::ranges::any_of(
        proven, [&](const Suspect& fault) { return has_all_of(evidence.failures()[i], fault); });
    if (!is_explained && (best == evidence.failures().size() ||
                          evidence.suspects()[i].size() < evidence.suspects()[best].size())) {
      best = i;
    }
  }
  return best;
}

void explain(const Evidence& evidence, Diagnosis& found) {
  found.faults = proven_faults(evidence);
  Explanations explained = explanations_of(evidence, found.faults);
  found.at_least = explained.size;
  found.explanations = std::move(explained.sets);
  found.all_explanations = explained.all;
  if (!found.explanations.empty() || evidence.failures().empty()) {
    return;
  }
  // Too many faults to find all together: one failed test is examined alone.
  const std::size_t one = easiest_failure(evidence, found.faults);
  found.all_explanations = true;  // for that test
  found.looked_at = evidence.failures().at(one);
  for (const Suspect& suspect : evidence.suspects()[one]) {
    found.explanations.push_back({suspect});
  }
}

}  // namespace

std::string in_words(const Suspect& suspect, const std::vector<std::string>& names) {
  return suspect.other ? names[suspect.one] + " with " + names[*suspect.other] : names[suspect.one];
}

Diagnosis diagnose(const Job& job, const std::vector<TestedSetup>& tests) {
  refuse_triples(job, "a diagnosis");
  constexpr std::size_t most_contradictions = 10;
  Job any = job;
  any.needed = PairSet(job.parts());
  any.first.clear();
  check(any);
  const Evidence evidence(any, tests);
  if (any.start.empty() && !tests.empty()) {
    any.start = tests.back().setup;
  }
  Diagnosis found;
  found.passed = evidence.passed();
  found.failed = evidence.failed();
  found.contradictions = evidence.contradictions(most_contradictions);
  explain(evidence, found);
  if (found.explanations.empty()) {
    return found;
  }
  if (found.at_least == 1) {
    for (const Explanation& alone : found.explanations) {
      found.suspects.push_back(alone.front());
    }
    std::ranges::stable_partition(found.suspects, [](const Suspect& each) { return !each.other; });
  }
  found.next = splitting_test(evidence, found.explanations);
  if (found.next) {
    // gcc 12 returns the argument's type, gcc 14 int.
    found.least_tests = static_cast<std::uint64_t>(std::bit_width(found.explanations.size() - 1));
    return found;
  }
  std::vector<Suspect> open = found.explanations.front();
  std::erase_if(
      open, [&](const Suspect& each) { return std::ranges::binary_search(found.faults, each); });
  if (found.explanations.size() == 1 && !found.looked_at) {
    found.next = proving_test(evidence, open);
  }
  return found;
}

}  // namespace changeover
