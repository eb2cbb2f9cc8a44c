#include "plan/search/lists/lists_search.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "plan/search/anneal/cooling.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/lists/lists_annealer.hpp"
#include "run/random.hpp"
#include "run/threads.hpp"

namespace changeover {
namespace {

// For a fixed penalty, as multiples of the mean cost of a target that meets. If some pairs weigh
// far more than others, exceeding a budget needs a far higher penalty, too.
struct FixedStyle {
  double penalty;
  double hot;
  double cold;
  double over;
};
constexpr std::array<FixedStyle, 4> fixed_styles{{{2.0, 0.25, 0.08, 4.0},
                                                  {1.8, 0.25, 0.10, 30.0},
                                                  {2.2, 0.60, 0.10, 8.0},
                                                  {2.5, 0.30, 0.06, 100.0}}};

// Whether moves are wide, for a fixed penalty. Of a model every other attempt is: a value that
// costs much is best changed in several set-ups at a time.
bool is_fixed(const Job& job, const ListsSearch& options, std::size_t attempt) {
  return options.aim == Aim::most_weight ||
         (job.model == nullptr ? job.replaces() : attempt % 2 == 1);
}

std::uint64_t suitable_steps(const Lists& lists, const ListsSearch& options, bool fixed) {
  const std::uint64_t room = lists.most_room();
  const std::uint64_t a_move = lists.of_triples() ? room * room : room;
  constexpr std::uint64_t least = 100'000;
  constexpr std::uint64_t a_place = 12'000;
  const std::uint64_t most = fixed ? 4'000'000 : 30'000'000;
  const std::uint64_t work = fixed ? 40'000'000 : 160'000'000;
  // With a clock, every move examines every test.
  const std::uint64_t slow = lists.has_clock() ? 1 + lists.tests() / 8 : 1;
  constexpr unsigned most_longer = 5;  // later rounds take longer
  const std::uint64_t longer = std::uint64_t{1} << std::min(options.round, most_longer);
  return longer * std::clamp<std::uint64_t>(
                      std::min(lists.tests() * room * a_place, work / a_move / slow), least, most);
}

ListsSchedule fixed_schedule(const ListsJob& job, const Lists& lists, const ListsSearch& options,
                             std::size_t attempt) {
  const FixedStyle& style = fixed_styles[attempt % fixed_styles.size()];
  const auto everything = static_cast<double>(options.everything);
  const bool budget = options.aim == Aim::most_weight;
  // The approximate cost of a millionth of weight.
  const auto costs = static_cast<double>(budget ? options.whole : lists.total());
  const double a_millionth = std::max(1.0, costs) / std::max(1.0, everything);
  const std::size_t things =
      lists.of_triples() ? job.common->triples.size() : job.common->needed.size();
  const double typical = everything / static_cast<double>(std::max<std::uint64_t>(1, things));
  const double scale = budget ? 1.5 : 1.0;
  const double unit = scale * style.penalty * a_millionth;
  return {.penalty = unit,
          .hot = style.hot * unit * typical,
          .cold = style.cold * unit * typical,
          .over = style.over};
}

struct Best {
  std::optional<Rank> rank;
  BenchLists lists;

  void take(const Lists& found, const ListsSearch& options) {
    const auto other = rank_of(found, options);
    if (other && (!rank || *other < *rank)) {
      rank = other;
      lists = found.lists();
    }
  }
};

}  // namespace

FoundLists search_lists(const ListsJob& job, const std::vector<BenchLists>& starts,
                        const ListsSearch& asked, RunControl& control) {
  ListsSearch options = asked;
  options.everything = Lists(job, BenchLists(job.jobs.size())).missing();
  std::vector<Best> bests(options.attempts);
  std::vector<std::uint64_t> steps(options.attempts, 0);
  in_parallel(control, options.attempts, [&](std::size_t i) {
    Lists lists(job, starts[i % starts.size()]);
    bests[i].take(lists, options);
    ListsSchedule schedule;
    // The rest is for the work after each attempt, and for what the time limit does not include.
    constexpr double share = 0.9;
    const auto time = time_of_attempt(control, i, options.attempts, share);
    const bool fixed = is_fixed(*job.jobs.front(), options, i);
    if (fixed) {
      schedule = fixed_schedule(job, lists, options, i);
      schedule.time = lists.of_model() ? time : std::nullopt;
    } else {
      // A later round stays near the best lists, and so does one with too few moves per place.
      constexpr double few = 0.001;  // seconds
      const bool hurries =
          time && time->count() < few * static_cast<double>(lists.tests() * lists.most_room());
      const bool stay_near = hurries || (options.round > 0 && (i + options.round) % 4 != 0);
      const HeatStyle& style =
          stay_near ? warm_style : heat_styles[(i + options.round) % heat_styles.size()];
      if (stay_near) {
        lists = Lists(job, starts.front());
      }
      schedule = {.hot = style.hot, .cold = style.cold, .time = time};
    }
    Random random(control.seed(), 4'000'000 + std::uint64_t{options.round} * options.attempts + i);
    ListsAnnealer annealer(lists, options, schedule, random);
    steps[i] = annealer.run(
        options.steps > 0 ? options.steps : suitable_steps(lists, options, fixed), control);
    if (annealer.best_rank()) {
      Lists best(job, annealer.best());
      bests[i].take(best, options);
      prune(best, control);
      best.retime();
      bests[i].take(best, options);
    }
    if (options.aim != Aim::most_weight && !control.stop_wanted() && complete(lists, control)) {
      prune(lists, control);
      lists.retime();
      bests[i].take(lists, options);
    }
    const Lists rebuilt(job, lists.lists());
    if (rebuilt.total() != lists.total() || rebuilt.missing() != lists.missing()) {
      throw InternalError("the search for lists lost count");
    }
  });
  FoundLists found;
  const Best* best = nullptr;
  for (const Best& each : bests) {
    if (each.rank && (best == nullptr || *each.rank < *best->rank)) {
      best = &each;
    }
  }
  if (best == nullptr) {
    if (control.stop_wanted()) {
      throw Stopped(control.why_stopped());  // before any list was counted
    }
    throw InternalError("no list to start from");
  }
  found.lists = best->lists;
  for (const std::uint64_t each : steps) {
    found.steps += each;
  }
  return found;
}

}  // namespace changeover
