#include "loadorder/shares/groups/known_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "core/each.hpp"
#include "core/words.hpp"
#include "loadorder/shares/groups/even_shares.hpp"
#include "loadorder/shares/groups/idle_workers.hpp"
#include "loadorder/shares/groups/larger_groups.hpp"
#include "loadorder/shares/groups/planes.hpp"

namespace changeover {
namespace {

constexpr const char* lines_of_table[] = {
#include "loadorder/shares/groups/share_table.inc"
};

/// A line of the table as text.
struct Base {
  std::uint64_t groups = 0;
  std::uint64_t step = 0;
  std::vector<GroupShare> shares;

  [[nodiscard]] std::uint64_t workers() const { return shares.size() * (groups / step); }
  [[nodiscard]] std::uint64_t held() const { return shares.front().held.size(); }
  [[nodiscard]] std::uint64_t all() const { return held() + shares.front().streamed.size(); }
  [[nodiscard]] ShareShape shape() const { return {workers(), groups, held(), all()}; }
};

Base parsed(std::string_view line) {
  Base base;
  std::vector<Element>* list = nullptr;
  int numbers = 0;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    if (word == "|") {
      list = &base.shares.emplace_back().held;
    } else if (word == "/") {
      list = &base.shares.back().streamed;
    } else {
      std::uint64_t number = 0;
      std::from_chars(word.data(), word.data() + word.size(), number);
      if (list != nullptr) {
        list->push_back(static_cast<Element>(number));
      } else {
        (numbers++ == 0 ? base.groups : base.step) = number;
      }
    }
  }
  return base;
}

const std::vector<Base>& bases() {
  static const std::vector<Base> all = each_of<Base>(lines_of_table, parsed);
  return all;
}

std::string sets_in_words(const Base& base) {
  const std::uint64_t streamed = base.all() - base.held();
  const std::string held = count_of(base.held(), "group");
  return streamed == 0 ? fmt::format("has {} of them", held)
                       : fmt::format("holds {} and streams {} {}", held, streamed,
                                     streamed == 1 ? "other" : "others");
}

GroupShares developed(const Base& base) {
  GroupShares shares;
  shares.groups = base.groups;
  const bool covers = base.all() == base.held();
  shares.method = covers ? "quorums" : "held and streamed groups";
  shares.explanation = fmt::format("the numbers modulo {}; each of {} workers {}", base.groups,
                                   base.workers(), sets_in_words(base));
  shares.explanation += base.step == base.groups
                            ? std::string(".")
                            : fmt::format(", translates of {} by multiples of {}.",
                                          count_of(base.shares.size(), "base share"), base.step);
  for (const GroupShare& share : base.shares) {
    for (std::uint64_t by = 0; by < base.groups; by += base.step) {
      const auto moved = [&](const std::vector<Element>& set) {
        std::vector<Element> out = each_of<Element>(set, [&](const Element group) {
          return static_cast<Element>((group + by) % base.groups);
        });
        std::ranges::sort(out);
        return out;
      };
      shares.workers.push_back({moved(share.held), moved(share.streamed)});
    }
  }
  return shares;
}

/// The best shares so far, and those with few more loads.
class Choice {
 public:
  struct Candidate {
    std::uint64_t makespan = 0;
    std::uint64_t loads = 0;
    GroupShares shares;
  };

  Choice(std::uint64_t items, std::uint64_t room, std::uint64_t than)
      : items_(items), room_(room), than_(than) {}

  /// Whether shares may be good enough.
  [[nodiscard]] bool is_hopeful(const ShareShape& shape) const {
    return mean_of(shape) <= most() && shape.held * (items_ / shape.groups) <= room_;
  }

  /// A makespan up to a thirtieth more than the least one is accepted if pairs are more even then.
  [[nodiscard]] std::uint64_t most() const {
    return std::min(than_ - 1, least_ + std::min(least_, than_) / 30);
  }

  void consider(GroupShares shares) {
    shares = with_larger_spread(std::move(shares), items_, room_);
    const ItemGroups groups{items_, shares.groups};
    Candidate one;
    for (const GroupShare& share : shares.workers) {
      const ShareCost cost = cost_of(share, groups, room_);
      if (cost.steps == 0) {
        return;
      }
      one.makespan = std::max(one.makespan, cost.loads);
      one.loads += cost.loads;
    }
    if (one.makespan > most()) {
      return;
    }
    one.shares = std::move(shares);
    least_ = std::min(least_, one.makespan);
    candidates_.push_back(std::move(one));
  }

  /// The items of a share: no worker less busy than that is the busiest.
  [[nodiscard]] std::uint64_t mean_of(const ShareShape& shape) const {
    return shape.all * items_ / shape.groups;
  }

  /// Sorted by makespan, then by loads.
  [[nodiscard]] std::vector<Candidate> take() {
    std::erase_if(candidates_, [&](const Candidate& one) { return one.makespan > most(); });
    std::ranges::stable_sort(candidates_, [](const Candidate& a, const Candidate& b) {
      return std::pair(a.makespan, a.loads) < std::pair(b.makespan, b.loads);
    });
    return std::move(candidates_);
  }

 private:
  std::uint64_t items_, room_;
  std::uint64_t than_;
  std::uint64_t least_ = std::numeric_limits<std::uint64_t>::max() / 2;
  std::vector<Candidate> candidates_;
};

ShareShape shape_of(const GroupShares& shares) {
  const GroupShare& first = shares.workers.front();
  return {shares.workers.size(), shares.groups, first.held.size(),
          first.held.size() + first.streamed.size()};
}

// Worker i holds group i and streams the next half of the groups.
GroupShares halves(std::uint64_t workers) {
  Base base{workers, 1, {{{0}, {}}}};
  for (std::uint64_t i = 1; i <= workers / 2; ++i) {
    base.shares[0].streamed.push_back(static_cast<Element>(i));
  }
  return developed(base);
}

}  // namespace

std::span<const char* const> share_table() { return lines_of_table; }

GroupShares developed_shares(std::string_view line) { return developed(parsed(line)); }

void each_group_shares(std::uint64_t workers, std::uint64_t items,
                       const std::function<bool(const ShareShape& shape)>& is_hopeful,
                       const std::function<void(GroupShares shares)>& visit) {
  constexpr std::uint64_t largest_order = 101;
  constexpr std::uint64_t most_streamed_groups = 600;  // whose pairs are given one by one
  for (const bool affine : {false, true}) {
    std::uint64_t q = 2;
    while (q < largest_order && (q + 1) * (q + 1) + (q + 1) + (affine ? 0 : 1) <= workers) {
      ++q;
    }
    while (q > 1 && !FiniteField::of_order(q)) {
      --q;
    }
    const std::uint64_t on_a_line = q + (affine ? 0 : 1);
    const ShareShape shape{q * q + q + (affine ? 0 : 1), q * q + (affine ? 0 : q + 1), on_a_line,
                           on_a_line};
    if (q > 1 && shape.workers <= workers && shape.groups <= items && is_hopeful(shape)) {
      visit(plane_shares(q, affine));
    }
    const ShareShape streamed{shape.workers, shape.groups, on_a_line - 1, on_a_line};
    if (q > 1 && shape.workers <= workers &&
        shape.groups <= std::min(items, most_streamed_groups) && is_hopeful(streamed)) {
      visit(streamed_plane_shares(q, affine));
    }
  }
  const std::uint64_t ring = std::min(workers, items);
  if (ring > 1 && is_hopeful({ring, ring, 1, 1 + ring / 2})) {
    visit(halves(ring));
  }
  for (const Base& base : bases()) {
    if (base.workers() <= workers && base.groups <= items && is_hopeful(base.shape())) {
      visit(developed(base));
    }
  }
}

std::optional<GroupShares> best_group_shares(std::uint64_t items, std::uint64_t room,
                                             std::uint64_t workers, std::uint64_t than) {
  Choice choice(items, room, than);
  std::vector<GroupShares> hopeful;
  each_group_shares(
      workers, items, [&](const ShareShape& shape) { return choice.is_hopeful(shape); },
      [&](GroupShares shares) { hopeful.push_back(std::move(shares)); });
  // Those with the smallest shares first: most others are not looked at then.
  std::ranges::stable_sort(
      hopeful, {}, [&](const GroupShares& shares) { return choice.mean_of(shape_of(shares)); });
  for (GroupShares& shares : hopeful) {
    if (choice.is_hopeful(shape_of(shares))) {
      choice.consider(std::move(shares));
    }
  }
  // Loads matter more than even pairs.
  constexpr std::size_t most_looks = 6;
  constexpr double even = 1.05;
  std::vector<Choice::Candidate> candidates = choice.take();
  candidates.resize(std::min(candidates.size(), most_looks));
  std::optional<GroupShares> best;
  double least = 0;
  for (Choice::Candidate& one : candidates) {
    GroupShares shares =
        with_idle_workers(std::move(one.shares), items, room, workers, one.makespan);
    double uneven = unevenness(shares, items, workers);
    if (uneven > even) {
      shares = with_more_held(shares, items, room);
      uneven = unevenness(shares, items, workers);
    }
    // With as many loads, or else with the fewest more that are enough.
    for (const std::uint64_t part : {0U, 120U, 60U, 30U}) {
      if (uneven <= even || shares.workers.size() < workers) {
        break;
      }
      const std::uint64_t makespan = one.makespan + (part > 0 ? one.makespan / part : 0);
      GroupShares changed = with_even_pairs(shares, items, room, std::min(makespan, choice.most()));
      const double now = unevenness(changed, items, workers);
      if (now <= even || (part == 0 && now < uneven)) {
        uneven = now;
        shares = std::move(changed);
      }
    }
    if (!best || (least > even && uneven < least - 0.01)) {
      least = uneven;
      best = std::move(shares);
    }
    if (least <= even) {
      break;
    }
  }
  return best;
}

}  // namespace changeover
