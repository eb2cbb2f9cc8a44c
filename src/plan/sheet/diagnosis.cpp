#include "changeover/plan/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/prices.hpp"
#include "plan/job/setup_list.hpp"
#include "run/portable_math.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_of_two = 100;
constexpr std::size_t most_tests = 1000;
constexpr std::size_t most_exhausted = 12;  // parts of suspects
constexpr std::uint64_t most_tried = 4096;

using Members = std::vector<bool>;  // by part

Members members_of(const Job& job, const Block& setup) {
  if (setup.empty() || setup.size() > job.at_once) {
    throw BadInput(fmt::format("a test that was done has {}; it has 1 to {}",
                               count_of(setup.size(), "part"), job.at_once));
  }
  Members members(job.names.size(), false);
  for (const Element x : setup) {
    if (x >= job.parts() || members[x]) {
      throw BadInput("a test that was done names a part twice, or one that there is not");
    }
    members[x] = true;
  }
  return members;
}

bool has(const Members& members, const Suspect& suspect) {
  return members[suspect.one] && (!suspect.other || members[*suspect.other]);
}

// Parts and pairs out of these parts that none of the tests that passed has.
std::vector<Suspect> suspects_among(const std::vector<Element>& parts, const Meetings& passed) {
  std::vector<Suspect> suspects;
  const auto add = [&](const Suspect& suspect) {
    if (!passed.met(suspect.one, suspect.other.value_or(suspect.one))) {
      suspects.push_back(suspect);
    }
  };
  for (const Element x : parts) {
    add({x, std::nullopt});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      add({parts[i], parts[j]});
    }
  }
  return suspects;
}

// The parts that all of some tests have.
std::vector<Element> common_parts(const Job& job, const std::vector<Members>& tests) {
  std::vector<Element> parts;
  for (Element x = 0; x < job.parts(); ++x) {
    if (std::all_of(tests.begin(), tests.end(), [&](const Members& test) { return test[x]; })) {
      parts.push_back(x);
    }
  }
  return parts;
}

std::vector<std::pair<Suspect, Suspect>> two_that_explain(const Job& job,
                                                          const std::vector<Members>& failed,
                                                          const Meetings& passed) {
  std::vector<std::pair<Suspect, Suspect>> two;
  for (const Suspect& one : suspects_among(common_parts(job, {failed.front()}), passed)) {
    stop_if_asked();
    std::vector<Members> others;
    std::copy_if(failed.begin(), failed.end(), std::back_inserter(others),
                 [&](const Members& test) { return !has(test, one); });
    for (const Suspect& other : suspects_among(common_parts(job, others), passed)) {
      if (two.size() == most_of_two) {
        return two;
      }
      const bool known = std::any_of(two.begin(), two.end(), [&](const auto& both) {
        return both.first == other && both.second == one;
      });
      if (!known) {
        two.emplace_back(one, other);
      }
    }
  }
  return two;
}

// What failed, and what passed though it had all of it. Only where all pairs of a set-up that failed met in tests that
// passed is one looked for: among those with its rarest part.
std::vector<std::pair<Block, Block>> contradictions_in(const Job& job,
                                                       const std::vector<TestedSetup>& tests,
                                                       const Meetings& passed) {
  constexpr std::size_t enough = 10;
  std::vector<std::vector<std::size_t>> with(job.names.size());  // by part: what passed
  for (std::size_t i = 0; i < tests.size(); ++i) {
    for (const Element x : tests[i].failed ? Block() : tests[i].setup) {
      with[x].push_back(i);
    }
  }
  std::vector<std::pair<Block, Block>> found;
  for (const TestedSetup& bad : tests) {
    stop_if_asked();
    const Block& setup = bad.setup;
    const bool all_met = bad.failed && std::all_of(setup.begin(), setup.end(), [&](Element x) {
                           return std::all_of(setup.begin(), setup.end(),
                                              [&](Element y) { return passed.met(x, y); });
                         });
    if (!all_met) {
      continue;
    }
    const Element rarest = *std::min_element(setup.begin(), setup.end(), [&](Element x, Element y) {
      return with[x].size() < with[y].size();
    });
    for (const std::size_t i : with[rarest]) {
      const Block& good = tests[i].setup;
      if (std::all_of(setup.begin(), setup.end(), [&](Element x) {
            return std::find(good.begin(), good.end(), x) != good.end();
          })) {
        found.emplace_back(setup, good);
        if (found.size() == enough) {
          return found;
        }
      }
    }
  }
  return found;
}

class NextTests {
 public:
  NextTests(const Job& job, Diagnosis& found)
      : job_(job), found_(&found), random_(1, found.suspects.size()) {
    job_.needed = PairSet(job.parts());
  }

  void run() { found_->most_cost = grow(found_->suspects, {}, job_.start); }

 private:
  struct Choice {
    Block setup;
    Amount cost;
    double worth = 0;
  };

  // The tests for these suspects, from this bench on; returns what they cost at most.
  Amount grow(const std::vector<Suspect>& left, const std::vector<bool>& after,
              const Block& bench) {
    if (left.size() < 2 || found_->tests.size() == most_tests) {
      return {};
    }
    job_.start = bench;
    const Choice choice = best(left);
    if (choice.worth <= 0) {
      return {};
    }
    const RunSheet sheet = run_sheet(job_, {choice.setup});
    if (!sheet.faults.empty()) {
      throw InternalError("a test to tell faults apart: " + sheet.faults.front());
    }
    const RunStep& step = sheet.steps.front();
    NextTest test{.after = after,
                  .setup = step.setup,
                  .take_out = step.take_out,
                  .put_in = step.put_in,
                  .cost = step.cost,
                  .if_it_fails = {},
                  .if_it_passes = {}};
    const Members members = members_of(job_, choice.setup);
    for (const Suspect& suspect : left) {
      (has(members, suspect) ? test.if_it_fails : test.if_it_passes).push_back(suspect);
    }
    found_->tests.push_back(test);
    Amount most;
    for (const bool fails : {true, false}) {
      std::vector<bool> then = after;
      then.push_back(fails);
      most = std::max(most, grow(fails ? test.if_it_fails : test.if_it_passes, then, test.setup));
    }
    return most + test.cost;
  }

  Choice best(const std::vector<Suspect>& left) {
    std::vector<Element> parts;  // of the suspects
    for (const Suspect& suspect : left) {
      parts.push_back(suspect.one);
      parts.push_back(suspect.other.value_or(suspect.one));
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    std::erase_if(parts, [&](Element x) { return is_in(job_.mounted, x); });
    // What fills the slots is no suspect if possible, and on the bench if possible.
    std::vector<Element> fillers;
    for (const bool on_bench : {true, false}) {
      for (Element x = 0; x < job_.parts(); ++x) {
        if (is_in(job_.start, x) == on_bench && !is_in(parts, x)) {
          fillers.push_back(x);
        }
      }
    }
    const Fitting fitting(job_);
    Choice best;
    const auto consider = [&](const Block& chosen) {
      Choice choice = judged(left, fitting, fillers, chosen);
      if (choice.worth > best.worth) {
        best = std::move(choice);
      }
    };
    if (parts.size() <= most_exhausted) {
      for (unsigned bits = 0; bits < 1U << parts.size(); ++bits) {
        Block chosen;
        for (std::size_t i = 0; i < parts.size(); ++i) {
          if ((bits >> i & 1U) != 0) {
            chosen.push_back(parts[i]);
          }
        }
        consider(chosen);
      }
      return best;
    }
    for (std::uint64_t i = 0; i < most_tried; ++i) {
      Block chosen;
      for (std::uint64_t size = 1 + random_.below(static_cast<std::uint32_t>(job_.room()));
           size > 0; --size) {
        const Element x = parts[random_.below(static_cast<std::uint32_t>(parts.size()))];
        if (!is_in(chosen, x)) {
          chosen.push_back(x);
        }
      }
      consider(chosen);
    }
    return best;
  }

  static bool is_in(const std::vector<Element>& parts, Element x) {
    return std::find(parts.begin(), parts.end(), x) != parts.end();
  }

  // What a test of these parts, of the mounted ones and of what the slots need is worth; nothing if it cannot be.
  Choice judged(const std::vector<Suspect>& left, const Fitting& fitting,
                const std::vector<Element>& fillers, const Block& chosen) const {
    stop_if_asked();
    Block setup = job_.mounted;
    setup.insert(setup.end(), chosen.begin(), chosen.end());
    if (setup.size() > job_.room()) {
      return {};
    }
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (job_.never.contains(setup[i], setup[j])) {
          return {};
        }
      }
    }
    const auto whole = fitting.completed(std::move(setup), fillers);
    if (!whole || whole->empty()) {
      return {};
    }
    Choice choice{*whole, job_.test_cost, 0};
    for (const Element x : *whole) {
      if (!is_in(job_.start, x)) {
        choice.cost += job_.change_costs[x];
      }
    }
    const Members members = members_of(job_, *whole);
    const auto hit = static_cast<std::size_t>(
        std::count_if(left.begin(), left.end(), [&](const Suspect& s) { return has(members, s); }));
    const std::size_t most = std::max(hit, left.size() - hit);
    choice.worth = natural_log(static_cast<double>(left.size()) / static_cast<double>(most)) /
                   (static_cast<double>(choice.cost.millionths) + 1.0);
    return choice;
  }

  Job job_;
  Diagnosis* found_;
  Random random_;
};

}  // namespace

std::string in_words(const Suspect& suspect, const std::vector<std::string>& names) {
  return suspect.other ? names[suspect.one] + " with " + names[*suspect.other] : names[suspect.one];
}

Diagnosis diagnose(const Job& job, const std::vector<TestedSetup>& tests) {
  refuse_replacing(job, "choosing the next test of a diagnosis");
  refuse_triples(job, "a diagnosis");
  Job any = job;
  any.needed = PairSet(job.parts());
  any.first.clear();
  check(any);
  Diagnosis found;
  Meetings passed(job.parts(), false);
  std::vector<Members> failed;
  for (const TestedSetup& test : tests) {
    stop_if_asked();
    Members members = members_of(job, test.setup);
    if (test.failed) {
      failed.push_back(std::move(members));
    } else {
      passed.add(job, test.setup);
      ++found.passed;
    }
  }
  found.failed = failed.size();
  if (failed.empty()) {
    return found;
  }
  found.contradictions = contradictions_in(job, tests, passed);
  found.suspects = suspects_among(common_parts(job, failed), passed);
  if (found.suspects.empty()) {
    found.two = two_that_explain(job, failed, passed);
  }
  if (any.start.empty() && !tests.empty()) {
    any.start = tests.back().setup;
  }
  NextTests(any, found).run();
  return found;
}

}  // namespace changeover
