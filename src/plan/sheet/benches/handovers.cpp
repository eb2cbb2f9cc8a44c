#include "plan/sheet/benches/handovers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/contains.hpp"
#include "plan/sheet/benches/bench_calendar.hpp"

namespace changeover {
namespace {

struct Moment {
  Amount begin;
  std::size_t bench = 0;
  std::size_t step = 0;
};

std::vector<Moment> moments_of(const BenchCount& plan) {
  std::vector<Moment> moments;
  for (std::size_t bench = 0; bench < plan.times.size(); ++bench) {
    for (std::size_t step = 0; step < plan.times[bench].size(); ++step) {
      moments.push_back({plan.times[bench][step].begin, bench, step});
    }
  }
  std::ranges::stable_sort(moments, {}, &Moment::begin);
  return moments;
}

// Follows the pieces of one part through a plan.
class Pieces {
 public:
  Pieces(Element part, std::uint64_t pieces, const Job& job, const BenchCount& plan)
      : part_(part), plan_(&plan), has_(plan.benches.size()), done_(plan.benches.size()) {
    std::uint64_t held = 0;
    for (std::size_t b = 0; b < plan.benches.size(); ++b) {
      const Bench& bench = plan.benches[b];
      has_[b] = !is_own(b) && contains(bench.start.value_or(job.start), part);
      held += has_[b] ? 1U : 0U;
    }
    fresh_ = pieces - std::min(pieces, held);
  }

  void run(const std::vector<Moment>& moments, std::vector<Handover>& found) {
    for (auto at = moments.begin(); at != moments.end();) {
      const auto same =
          std::find_if(at, moments.end(), [&](const Moment& m) { return at->begin < m.begin; });
      // What is taken out can be put in elsewhere at once.
      std::for_each(at, same, [&](const Moment& m) { take_out(m); });
      std::for_each(at, same, [&](const Moment& m) { put_in(m, found); });
      at = same;
    }
  }

 private:
  [[nodiscard]] bool is_own(std::size_t bench) const {
    return contains(plan_->benches[bench].own, part_);
  }
  [[nodiscard]] const RunStep& step_of(const Moment& m) const {
    return plan_->sheets[m.bench].steps[m.step];
  }

  void take_out(const Moment& m) {
    done_[m.bench] = m.step + 1;
    const RunStep& step = step_of(m);
    // What a bench gave up during a wait it may still have when it puts it in again.
    if (has_[m.bench] && contains(step.take_out, part_) && !contains(step.put_in, part_)) {
      has_[m.bench] = false;
      aside_.push_back(m.bench);
    }
  }

  void put_in(const Moment& m, std::vector<Handover>& found) {
    if (is_own(m.bench) || has_[m.bench] || !contains(step_of(m).put_in, part_)) {
      return;
    }
    has_[m.bench] = true;
    if (const auto own = std::ranges::find(aside_, m.bench); own != aside_.end()) {
      aside_.erase(own);
    } else if (fresh_ > 0) {
      --fresh_;
    } else if (!aside_.empty()) {
      found.push_back({.part = part_, .from = aside_.front(), .to = m.bench, .step = m.step});
      aside_.erase(aside_.begin());
    } else if (const auto from = first_done_with_it(m)) {
      has_[*from] = false;
      found.push_back(
          {.part = part_,
           .from = *from,
           .to = m.bench,
           .step = m.step,
           .is_early = true,
           .after = done_[*from] == 0 ? std::nullopt : std::optional(done_[*from] - 1)});
    }
  }

  // The bench that has been done with it longest.
  [[nodiscard]] std::optional<std::size_t> first_done_with_it(const Moment& m) const {
    std::optional<std::pair<Amount, std::size_t>> first;
    for (std::size_t b = 0; b < has_.size(); ++b) {
      const std::vector<RunStep>& steps = plan_->sheets[b].steps;
      const std::size_t next = done_[b];
      const Amount end = next == 0 ? Amount{} : plan_->times[b][next - 1].end;
      const bool needs_it =
          m.begin < end || (next < steps.size() && !contains(steps[next].take_out, part_));
      if (b != m.bench && has_[b] && !needs_it && (!first || end < first->first)) {
        first = {end, b};
      }
    }
    return first ? std::optional(first->second) : std::nullopt;
  }

  Element part_;
  const BenchCount* plan_;
  std::vector<bool> has_;           // by bench
  std::vector<std::size_t> done_;   // by bench: how many of its steps have begun
  std::uint64_t fresh_ = 0;         // pieces that no bench has had
  std::vector<std::size_t> aside_;  // benches that had the others, the first one first
};

// "day 2, hour 3"; without days "at 12".
std::string when(Amount begin, const Money& money, const BenchCalendar& calendar) {
  if (!calendar.has_days()) {
    return "at " + money(begin);
  }
  const std::uint64_t day = calendar.day(begin);
  const std::string date = calendar.date(day);
  return fmt::format("day {}{}, {} {}", day, date.empty() ? "" : " (" + date + ")", calendar.unit(),
                     money(calendar.hour(begin)));
}

}  // namespace

std::vector<Handover> handovers(const Job& job, const BenchCount& plan) {
  std::vector<Handover> found;
  if (job.model != nullptr) {
    return found;
  }
  const std::vector<Moment> moments = moments_of(plan);
  for (Element x = 0; x < job.quantities.size(); ++x) {
    if (job.quantities[x] < plan.benches.size()) {
      Pieces(x, job.quantities[x], job, plan).run(moments, found);
    }
  }
  std::ranges::stable_sort(found, {}, [&](const Handover& each) {
    return std::tuple(plan.times[each.to][each.step].begin, each.to);
  });
  return found;
}

HandoverLines handover_lines(const Job& job, const BenchCount& plan, const Money& money,
                             const BenchCalendar& calendar) {
  HandoverLines lines;
  for (const RunSheet& sheet : plan.sheets) {
    lines.emplace_back(sheet.steps.size());
  }
  for (const Handover& each : handovers(job, plan)) {
    const std::string& part = job.names[each.part];
    lines[each.to][each.step].push_back(
        fmt::format("{} from {}", part, name_of(plan.benches, each.from)));
    if (each.is_early && !lines[each.from].empty()) {
      lines[each.from][each.after.value_or(0)].push_back(fmt::format(
          "take out {} {} it: {} needs it for step {} {}", part, each.after ? "after" : "before",
          name_of(plan.benches, each.to), plan.benches[each.to].steps_before() + each.step + 1,
          when(plan.times[each.to][each.step].begin, money, calendar)));
    }
  }
  return lines;
}

}  // namespace changeover
