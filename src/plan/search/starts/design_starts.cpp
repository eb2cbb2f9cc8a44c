#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"
#include "changeover/search/local_search.hpp"
#include "core/each.hpp"
#include "core/words.hpp"
#include "plan/job/pair_numbers.hpp"
#include "plan/search/budget.hpp"
#include "plan/search/starts/starts.hpp"
#include "run/threads.hpp"

namespace changeover {
namespace {

// Parts that have needed pairs and do not stay mounted.
std::vector<Element> free_parts(const Job& job) {
  std::vector<bool> used(job.names.size());
  job.needed.for_each(all_of_them, [&](Element x, Element y) { used[x] = used[y] = true; });
  for (const Element m : job.mounted) {
    used[m] = false;
  }
  std::vector<Element> parts;
  for (Element x = 0; x < job.parts(); ++x) {
    if (used[x]) {
      parts.push_back(x);
    }
  }
  return parts;
}

// The blocks of a design as set-ups: elements with few introductions become the expensive parts,
// and those of the first block become parts that are mounted already.
std::vector<Block> as_setups(const Job& job, const std::vector<Element>& parts,
                             const Design& design, bool backwards) {
  const std::size_t v = parts.size();
  const std::size_t b = design.block_count();
  const auto block = [&](std::size_t i) { return design.block(backwards ? b - 1 - i : i); };
  std::vector<std::uint64_t> introduced(v, 0);
  std::vector<std::size_t> last_seen(v, b + 1);
  for (std::size_t i = 0; i < b; ++i) {
    for (const Element x : block(i)) {
      introduced[x] += last_seen[x] + 1 == i ? 0U : 1U;
      last_seen[x] = i;
    }
  }
  std::vector<bool> in_first(v, false);
  for (const Element x : block(0)) {
    in_first[x] = true;
  }
  const auto on_bench = [&](Element part) {
    return std::find(job.start.begin(), job.start.end(), part) != job.start.end();
  };
  // Matches elements and parts: first those of the first block with the parts of the start, then
  // the rest, with few introductions for expensive parts.
  std::vector<Element> elements(v);
  std::iota(elements.begin(), elements.end(), Element{0});
  std::stable_sort(elements.begin(), elements.end(),
                   [&](Element x, Element y) { return introduced[x] < introduced[y]; });
  std::vector<Element> by_cost = parts;
  std::stable_sort(by_cost.begin(), by_cost.end(),
                   [&](Element x, Element y) { return job.change_costs[x] > job.change_costs[y]; });
  std::vector<Element> part_of(v, 0);
  std::vector<bool> given(v, false);
  std::vector<Element> rest;
  auto next = elements.begin();
  for (const Element part : by_cost) {
    next = on_bench(part)
               ? std::find_if(next, elements.end(), [&](Element x) { return in_first[x]; })
               : next;
    if (on_bench(part) && next != elements.end()) {
      part_of[*next] = part;
      given[*next++] = true;
    } else {
      rest.push_back(part);
    }
  }
  auto part = rest.begin();
  for (const Element x : elements) {
    if (!given[x]) {
      part_of[x] = *part++;
    }
  }
  std::vector<Block> setups;
  for (std::size_t i = 0; i < b; ++i) {
    setups.push_back(job.mounted);
    for (const Element x : block(i)) {
      setups.back().push_back(part_of[x]);
    }
  }
  return setups;
}

std::vector<Block> cheaper_direction(const Job& job, const std::vector<Element>& parts,
                                     const Design& design, RunControl& control) {
  std::vector<Block> forwards = as_setups(job, parts, design, false);
  if (control.stop_wanted()) {
    return forwards;
  }
  std::vector<Block> backwards = as_setups(job, parts, design, true);
  const bool better = run_sheet(job, backwards).cost < run_sheet(job, forwards).cost;
  return better ? backwards : forwards;
}

// A design as a list of set-ups, with what the list costs.
struct DesignStart {
  Start start;
  Amount cost;
  Parameters parameters;
  std::uint64_t blocks = 0;
  std::string by;  // a construction
};

// Designs over these parts as lists of set-ups.
class DesignStarts {
 public:
  DesignStarts(const Job& job, std::vector<Element> parts, RunControl& control)
      : job_(&job), parts_(std::move(parts)), control_(&control) {}

  // The best known m-change design, if there is one.
  [[nodiscard]] std::optional<DesignStart> known(std::uint64_t k, std::uint64_t m) const {
    const Parameters p{.v = parts_.size(),
                       .k = k,
                       .change = m,
                       .kind = Kind::linear,
                       .strength = job_->triples.empty() ? 2U : 3U};
    if (impossibility(p) || control_->stop_wanted()) {
      return std::nullopt;
    }
    const std::optional<Design> design = best_known_design(p);
    if (!design) {
      return std::nullopt;
    }
    return made(p, *design, design->recipe ? design->recipe->construction : "a recipe");
  }

  // One with fewer blocks, if local search finds it with so many moves and it costs less.
  void improve_by_search(DesignStart& from, std::uint64_t moves) const {
    constexpr std::uint64_t most_improved = 4;
    const Parameters& p = from.parameters;
    if (p.change > most_improved || from.blocks <= lower_bound(p).blocks ||
        control_->stop_wanted()) {
      return;
    }
    try {
      RunControl own(*control_, 1U);
      const ImproveResult better = improve(p, {.moves = moves}, own);
      if (better.design && better.design->block_count() < from.blocks) {
        DesignStart found =
            made(p, *better.design, fmt::format("local search; {} by {}", from.blocks, from.by));
        if (found.cost < from.cost) {
          from = std::move(found);
        }
      }
    } catch (const Stopped&) {
      // the known design is used
    } catch (const ImpossibleParameters&) {
      // the cost overflows, that of the known design does not
    }
  }

 private:
  [[nodiscard]] DesignStart made(const Parameters& p, const Design& design,
                                 const std::string& how) const {
    DesignStart made{.start = {change_name(p.change) + " design",
                               fmt::format("linear {} with {} ({})", name(p, false),
                                           count_of(design.block_count(), "block"), how),
                               cheaper_direction(*job_, parts_, design, *control_)},
                     .cost = {},
                     .parameters = p,
                     .blocks = design.block_count(),
                     .by = how};
    made.cost = run_sheet(*job_, made.start.setups).cost;
    return made;
  }

  const Job* job_;
  std::vector<Element> parts_;
  RunControl* control_;
};

}  // namespace

std::vector<Start> design_starts(const Job& job, std::uint64_t moves, RunControl& control) {
  const std::vector<Element> parts = free_parts(job);
  const std::uint64_t k = job.room() - job.mounted.size();
  if (job.never.size() > 0 || !job.slots.empty() || parts.empty()) {
    return {};
  }
  if (parts.size() <= k) {
    Block all = job.mounted;
    all.insert(all.end(), parts.begin(), parts.end());
    return {{"one set-up", "all parts fit at once", {all}}};
  }
  constexpr std::uint64_t most_changed = 6;
  const std::uint64_t most = std::min({k, parts.size() - k, most_changed});
  if (k < (job.triples.empty() ? 2U : 3U)) {
    return {};
  }
  control.tell({.phase = "looking for designs"});
  std::vector<std::optional<DesignStart>> found(static_cast<std::size_t>(most));
  // Other lists need the time more: most of it, and nearly all of it once the known ones are there.
  constexpr double share_of_known = 0.4;
  ShareOfTime for_known(control, share_of_known);
  const DesignStarts designs(job, parts, for_known.control());
  in_parallel(for_known.control(), found.size(), [&](std::size_t i) {
    try {
      found[i] = designs.known(k, i + 1);
    } catch (const ImpossibleParameters&) {
      // its cost overflows, that of others does not
    }
  });
  std::erase(found, std::nullopt);
  if (moves > 0 && job.triples.empty()) {
    // Searches take time, and there may be none for the last ones.
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a->cost < b->cost; });
    constexpr double share_of_searches = 0.125;
    ShareOfTime for_searches(control, share_of_searches);
    const DesignStarts searches(job, parts, for_searches.control());
    in_parallel(for_searches.control(), found.size(),
                [&](std::size_t i) { searches.improve_by_search(*found[i], moves); });
  }
  return each_of<Start>(found,
                        [&](std::optional<DesignStart>& each) { return std::move(each->start); });
}

}  // namespace changeover
