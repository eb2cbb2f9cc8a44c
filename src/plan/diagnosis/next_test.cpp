// Chooses the test to run next: its set-up, and what its results would mean.
#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/plan/run_plan.hpp"
#include "changeover/run/control.hpp"
#include "core/contains.hpp"
#include "plan/diagnosis/evidence.hpp"
#include "plan/job/choices.hpp"
#include "plan/job/fitting.hpp"
#include "plan/search/benches/step_costs.hpp"
#include "run/portable_math.hpp"
#include "run/random.hpp"

namespace changeover {
namespace {

constexpr std::size_t most_exhausted = 12;  // parts of suspects
constexpr std::uint64_t most_suspects_looked_at = 40'000'000;
constexpr std::uint64_t least_climbs = 3;
constexpr std::uint64_t most_climbs = 24;

Block parts_of(const std::vector<Explanation>& sets) {
  std::set<Element> parts;
  for (const Explanation& set : sets) {
    for (const Suspect& suspect : set) {
      parts.insert(suspect.one);
      parts.insert(suspect.other.value_or(suspect.one));
    }
  }
  return {parts.begin(), parts.end()};
}

// The possible set-ups with some parts, completed for the slots, and their costs.
class SetUps {
 public:
  SetUps(const Evidence& evidence, const Block& wanted)
      : job_(&evidence.job()), fitting_(evidence.job()) {
    if (job_->model != nullptr) {
      values_ = std::make_unique<ChoiceSolver>(*job_);
    }
    // Parts that fill slots are, if possible, no suspects, known to work, and already mounted.
    for (const bool suspect : {false, true}) {
      for (const bool cleared : {true, false}) {
        for (const bool on_bench : {true, false}) {
          for (Element x = 0; x < job_->parts(); ++x) {
            if (contains(wanted, x) == suspect &&
                evidence.is_cleared({x, std::nullopt}) == cleared &&
                contains(job_->start, x) == on_bench) {
              fillers_.push_back(x);
            }
          }
        }
      }
    }
  }

  // These parts, the mounted ones and those that the slots need, increasing; nullopt if that is
  // impossible.
  [[nodiscard]] std::optional<Block> with(const Block& chosen) const {
    stop_if_asked();
    Block setup = job_->mounted;
    for (const Element x : chosen) {
      if (!contains(setup, x)) {
        setup.push_back(x);
      }
    }
    if (setup.size() > job_->room()) {
      return std::nullopt;
    }
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (job_->never.contains(setup[i], setup[j])) {
          return std::nullopt;
        }
      }
    }
    auto whole = values_ ? values_->testing(setup, fillers_)
                         : fitting_.completed(std::move(setup), fillers_);
    if (!whole || whole->empty() || setup_defect(*job_, *whole)) {
      return std::nullopt;
    }
    std::ranges::sort(*whole);
    return whole;
  }

  [[nodiscard]] Amount cost(const Block& setup) const { return step_costs(*job_, {setup}).front(); }

 private:
  const Job* job_;
  Fitting fitting_;
  std::unique_ptr<ChoiceSolver> values_;  // for a model
  std::vector<Element> fillers_;
};

NextTest test_of(const Job& job, const Block& setup) {
  const RunSheet sheet = run_sheet(job, {setup});
  if (!sheet.faults.empty()) {
    throw InternalError("a test to tell faults apart: " + sheet.faults.front());
  }
  const RunStep& step = sheet.steps.front();
  return {.setup = step.setup,
          .take_out = step.take_out,
          .put_in = step.put_in,
          .cost = step.cost,
          .if_it_fails = {},
          .if_it_passes = {}};
}

using Members = std::vector<bool>;  // by part

Members members_of(const Job& job, const Block& setup) {
  Members members(job.names.size());
  for (const Element x : setup) {
    members[x] = true;
  }
  return members;
}

bool fails_under(const Members& setup, const Explanation& faults) {
  return std::ranges::any_of(faults, [&](const Suspect& fault) {
    return setup[fault.one] && setup[fault.other.value_or(fault.one)];
  });
}

// A sample that is large enough to choose a test.
std::vector<Explanation> some_of(const std::vector<Explanation>& sets) {
  const std::size_t step = (sets.size() + max_explanations - 1) / max_explanations;
  std::vector<Explanation> some;
  for (std::size_t i = 0; i < sets.size(); i += step) {
    some.push_back(sets[i]);
  }
  return some;
}

// Searches for the set-up that splits the explanations best for its cost.
class Splitter {
 public:
  Splitter(const Evidence& evidence, const std::vector<Explanation>& sets)
      : evidence_(&evidence),
        sets_(some_of(sets)),
        parts_(parts_of(sets)),
        setups_(evidence, parts_),
        random_(1, sets.size()),
        in_a_set_(evidence.job().names.size(), Members(evidence.job().names.size())) {
    std::erase_if(parts_, [&](Element x) { return contains(evidence.job().mounted, x); });
    for (const Explanation& set : sets) {
      for (const Suspect& suspect : set) {
        in_a_set_[suspect.one][suspect.other.value_or(suspect.one)] = true;
      }
    }
  }

  std::optional<Block> run() {
    if (parts_.size() <= most_exhausted) {
      for (unsigned bits = 0; bits < 1U << parts_.size(); ++bits) {
        Block chosen;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
          if ((bits >> i & 1U) != 0) {
            chosen.push_back(parts_[i]);
          }
        }
        consider(chosen);
      }
      return best_.setup;
    }
    const std::uint64_t of_a_climb = 4 * parts_.size() * sets_.size() * sets_.front().size();
    const std::uint64_t climbs =
        std::clamp(most_suspects_looked_at / of_a_climb, least_climbs, most_climbs);
    for (std::uint64_t i = 0; i < climbs; ++i) {
      climb();
    }
    return best_.setup;
  }

 private:
  struct Choice {
    std::optional<Block> setup;
    double worth = 0;
  };

  double consider(const Block& chosen) {
    const auto setup = setups_.with(chosen);
    const double worth = setup ? worth_of(*setup) : -1;
    if (worth > best_.worth) {
      best_ = {setup, worth};
    }
    return worth;
  }

  // The information that is gained for sure, per cost; suspects in no explanation make it uncertain
  // what failed.
  [[nodiscard]] double worth_of(const Block& setup) const {
    const Members members = members_of(evidence_->job(), setup);
    const auto fails = static_cast<std::size_t>(std::ranges::count_if(
        sets_, [&](const Explanation& set) { return fails_under(members, set); }));
    const std::size_t most = std::max(fails, sets_.size() - fails);
    if (most == sets_.size()) {
      return 0;
    }
    std::uint64_t others = 0;
    for (std::size_t i = 0; i < setup.size(); ++i) {
      for (std::size_t j = i; j < setup.size(); ++j) {
        others += in_a_set_[setup[i]][setup[j]] || evidence_->has_met(setup[i], setup[j]) ? 0U : 1U;
      }
    }
    return natural_log(static_cast<double>(sets_.size()) / static_cast<double>(most)) /
           (static_cast<double>(setups_.cost(setup).millionths) + 1.0) /
           (1.0 + static_cast<double>(others));
  }

  // Starting with some parts, adds or removes one as long as that helps.
  void climb() {
    Block chosen = some_parts();
    double worth = consider(chosen);
    for (bool better = true; better;) {
      better = false;
      Block order = parts_;
      shuffle(order, random_);
      for (const Element x : order) {
        Block other = chosen;
        if (contains(other, x)) {
          std::erase(other, x);
        } else {
          other.push_back(x);
        }
        const double then = consider(other);
        if (then > worth) {
          worth = then;
          chosen = std::move(other);
          better = true;
        }
      }
    }
  }

  Block some_parts() {
    Block order = parts_;
    shuffle(order, random_);
    const std::size_t most = std::min<std::size_t>(order.size(), evidence_->job().room());
    order.resize(1 + random_.below(static_cast<std::uint32_t>(most)));
    return order;
  }

  const Evidence* evidence_;
  std::vector<Explanation> sets_;
  Block parts_;
  SetUps setups_;
  Random random_;
  std::vector<Members> in_a_set_;  // by suspect: its first part, or both
  Choice best_;
};

// Whether a failure would prove the fault: the test has no other suspect. For a part, the only
// other suspects may be pairs of it, with partners that were in no failed test that has only such
// pairs.
bool would_prove(const Evidence& evidence, const Block& setup, const Suspect& fault) {
  const std::vector<Suspect> suspects = evidence.suspects_among(setup);
  if (suspects.size() == 1) {
    return true;
  }
  const auto others = fault.other ? std::nullopt : Evidence::companions(suspects, fault.one);
  const auto is_new = [&](const Block& before) {
    return std::ranges::none_of(before, [&](Element x) { return contains(*others, x); });
  };
  return others && std::ranges::all_of(evidence.companions_of(fault.one), is_new);
}

}  // namespace

std::optional<NextTest> splitting_test(const Evidence& evidence,
                                       const std::vector<Explanation>& sets) {
  if (sets.size() < 2) {
    return std::nullopt;
  }
  const std::optional<Block> setup = Splitter(evidence, sets).run();
  if (!setup) {
    return std::nullopt;
  }
  NextTest test = test_of(evidence.job(), *setup);
  const Members members = members_of(evidence.job(), test.setup);
  for (const Explanation& set : sets) {
    (fails_under(members, set) ? test.if_it_fails : test.if_it_passes).push_back(set);
  }
  return test;
}

std::optional<NextTest> proving_test(const Evidence& evidence,
                                     const std::vector<Suspect>& suspects) {
  std::optional<NextTest> best;
  for (const Suspect& fault : suspects) {
    Block parts{fault.one};
    if (fault.other) {
      parts.push_back(*fault.other);
    }
    const SetUps setups(evidence, parts);
    // Alone, and with each mounted part, which may be cheaper to leave in place.
    std::vector<Block> choices{parts};
    choices.push_back(parts);
    for (const Element x : evidence.job().start) {
      choices.back().push_back(x);
      choices.push_back(parts);
      choices.back().push_back(x);
    }
    for (const Block& chosen : choices) {
      Block once = chosen;
      std::ranges::sort(once);
      once.erase(std::unique(once.begin(), once.end()), once.end());
      const auto setup = setups.with(once);
      if (!setup || !would_prove(evidence, *setup, fault)) {
        continue;
      }
      if (!best || setups.cost(*setup) < best->cost) {
        best = test_of(evidence.job(), *setup);
        best->proves = fault;
      }
    }
  }
  return best;
}

}  // namespace changeover
