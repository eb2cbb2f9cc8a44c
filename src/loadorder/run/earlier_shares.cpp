#include "loadorder/run/earlier_shares.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "changeover/core/error.hpp"
#include "changeover/core/pair_set.hpp"
#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/shares/owners/pair_table.hpp"
#include "loadorder/shares/split_maker.hpp"

namespace changeover {
namespace {

constexpr std::string_view follows = ", after ";

std::string_view after(std::string_view shares) {
  const std::size_t at = shares.find(follows);
  return at == std::string_view::npos ? std::string_view() : shares.substr(at + follows.size());
}

std::uint64_t leading_number(std::string_view text) {
  std::uint64_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

WorkerSplit shares_of(const LoadOrder& order, std::uint64_t shares,
                      const std::function<bool(Element, Element)>& computed) {
  const LoadOrderFacts& facts = order.facts();
  LoadOrder same(facts, order.maker());
  WorkerSplit split = split_order(std::move(same), facts.items, facts.room, shares);
  SplitMaker::spread(split, computed);
  return split;
}

std::string name_of_shares(const WorkerSplit& split, const std::string& after) {
  return fmt::format("{}{}{}{}", split.facts().workers.size(),
                     split.facts().cut_by_loads ? ", even in loads" : "",
                     split.owners() != nullptr ? ", even in pairs" : "",
                     after.empty() ? "" : std::string(follows) + after);
}

/// One journal, given by its first line.
struct EarlierShares::Run {
  std::string path;
  std::string shares;
  std::uint64_t of = 0;
  std::uint64_t index = 0;
};

EarlierShares::EarlierShares(const std::vector<std::string>& journals,
                             const std::vector<JournalField>& fields, const LoadOrder& order)
    : wanted_(order.facts().wanted) {
  if (journals.empty()) {
    return;
  }
  const std::uint64_t items = order.facts().items;
  if (items > most_items_of_a_table && wanted_.graph() == nullptr) {
    throw BadInput(
        fmt::format("a job of {} items goes on with as many shares as before; of at most {} "
                    "items their number may change",
                    items, most_items_of_a_table));
  }
  items_.assign(static_cast<std::size_t>(items), false);
  pairs_.assign(static_cast<std::size_t>(wanted_.graph() != nullptr ? 2 * wanted_.graph()->pairs()
                                                                    : items * (items - 1) / 2),
                false);
  std::vector<Run> runs;
  for (const std::string& path : journals) {
    const auto [shares, share] = Journal::shares_in(path, fields);
    runs.push_back({path, shares, leading_number(shares), leading_number(share)});
    if (runs.back().of == 0 || runs.back().index >= runs.back().of) {
      throw BadInput(path + ": is the journal of another version; name the journals of this job");
    }
  }
  std::ranges::sort(runs, [](const Run& a, const Run& b) {
    return std::pair(a.shares, a.index) < std::pair(b.shares, b.index);
  });
  while (!runs.empty()) {
    const auto next = std::stable_partition(
        runs.begin(), runs.end(), [&](const Run& run) { return after(run.shares) != checksum_; });
    if (next == runs.end()) {
      throw BadInput(
          runs.front().path +
          ": continues a run whose journals are missing or have changed; name all of them");
    }
    const std::vector<Run> now(next, runs.end());
    runs.erase(next, runs.end());
    // All of them started with the same earlier steps.
    const std::size_t first = steps_.size();
    Sha256 all;
    all.add(std::string_view(checksum_));
    for (const Run& run : now) {
      read(run, fields, order);
    }
    for (std::size_t i = first; i < steps_.size(); ++i) {
      for (const auto& [x, y] : steps_[i].pairs) {
        if (x == y) {
          items_[x] = true;
        } else {
          pairs_[static_cast<std::size_t>(wanted_.graph() != nullptr ? *wanted_.graph()->place(x, y)
                                                                     : PairSet::rank(x, y))] = true;
        }
        all.add(fmt::format("{} {} ", x, y));
      }
      all.add(steps_[i].results ? to_hex(*steps_[i].results) : std::string("-"));
    }
    checksum_ = to_hex(all.finish()).substr(0, 16);
  }
}

void EarlierShares::read(const Run& run, const std::vector<JournalField>& fields,
                         const LoadOrder& order) {
  std::function<bool(Element, Element)> done_before;
  if (!checksum_.empty()) {
    done_before = [this](Element x, Element y) { return computed(x, y); };
  }
  const WorkerSplit split = shares_of(order, run.of, done_before);
  std::vector<JournalField> head = fields;
  head.push_back({"shares", name_of_shares(split, checksum_)});
  head.push_back({"share", fmt::format("{}", run.index)});
  const std::uint64_t count = split.facts().workers[static_cast<std::size_t>(run.index)].steps;
  const Journal journal(run.path, head, count);
  std::vector<const JournalRecord*> last(static_cast<std::size_t>(count), nullptr);
  for (const JournalRecord& record : journal.records()) {
    last[static_cast<std::size_t>(record.step - 1)] = &record;
  }
  const SplitFacts& facts = split.facts();
  PairAssigner assigner(facts.items, facts.room, wanted_, 0, false, split.owners());
  assigner.start(split.stream(run.index));
  AssignedStep step;
  for (const JournalRecord* const record : last) {
    if (!assigner.next(step)) {
      return;
    }
    if (record == nullptr) {
      continue;
    }
    Done done{step.step.number, {step.pairs.begin(), step.pairs.end()}, record->results};
    for (std::size_t i = 0; i < step.step.load.size(); ++i) {
      if (step.is_new[i]) {
        done.pairs.emplace_back(step.step.load[i], step.step.load[i]);
      }
    }
    std::ranges::sort(done.pairs);
    steps_.push_back(std::move(done));
  }
}

bool EarlierShares::computed(Element x, Element y) const {
  if (items_.empty()) {
    return false;
  }
  if (x == y) {
    return items_[x];
  }
  if (wanted_.graph() == nullptr) {
    return pairs_[static_cast<std::size_t>(PairSet::rank(x, y))];
  }
  const auto place = wanted_.graph()->place(x, y);
  return place && pairs_[static_cast<std::size_t>(*place)];
}

}  // namespace changeover
