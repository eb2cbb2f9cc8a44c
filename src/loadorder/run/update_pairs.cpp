
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/run/compute_pool.hpp"
#include "loadorder/run/journal.hpp"
#include "loadorder/run/versioned_items.hpp"

namespace changeover {
namespace {

std::uint64_t workers_of(const LoadOrderFacts& facts) {
  return std::max<std::uint64_t>(1, facts.lockstep);
}

/// Replays a whole order: checks it, and returns a checksum that identifies it. @throws BadInput
Checksum checksum_of(const LoadOrder& order, const ComputeRules& compute) {
  const LoadOrderFacts& facts = order.facts();
  const ScheduleRules rules = order.rules(compute);
  ScheduleCheck check(rules);
  StepWork work(order.stream(), rules);
  Sha256 hash;
  for (Step step; work.next(step);) {
    check.read(step);
    for (const std::vector<Element>& list : {step.evict, step.load}) {
      hash.add(list.data(), list.size() * sizeof(Element));
      hash.add("|");
    }
    for (const auto& [x, y] : step.compute) {
      hash.add(fmt::format("{},{} ", x, y));
    }
  }
  const ScheduleVerdict verdict = check.finish();
  if (!verdict.valid() || verdict.steps != facts.steps) {
    throw BadInput(fmt::format("this is not an order of {} for {} with room for {}: {}{} missing",
                               count_of(facts.items, "item"), count_of(workers_of(facts), "worker"),
                               facts.room,
                               verdict.fault.empty() ? std::string() : verdict.fault + "; ",
                               count_of(verdict.missing, "pair")));
  }
  return hash.finish();
}

/// The memory of a worker.
class Memory {
 public:
  Memory(std::uint64_t room, std::uint64_t item_bytes) {
    for (std::uint64_t i = 0; i < room; ++i) {
      free_.push_back(
          std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(item_bytes)));
    }
  }

  std::span<std::byte> take(Element x) {
    held_.emplace_back(x, std::move(free_.back()));
    free_.pop_back();
    return *held_.back().second;
  }

  void drop(Element x) {
    const auto place = find(x);
    free_.push_back(std::move(place->second));
    held_.erase(place);
  }

  [[nodiscard]] HeldItem item(Element x) {
    const auto& memory = find(x)->second;
    return {x, *memory, &memory};
  }

 private:
  using Bytes = std::shared_ptr<std::vector<std::byte>>;

  std::vector<std::pair<Element, Bytes>>::iterator find(Element x) {
    const auto place =
        std::ranges::find_if(held_, [x](const auto& each) { return each.first == x; });
    if (place == held_.end()) {
      throw InternalError(fmt::format("item {} is not held", x));
    }
    return place;
  }

  std::vector<std::pair<Element, Bytes>> held_;
  std::vector<Bytes> free_;
};

class UpdateJob {
 public:
  UpdateJob(const LoadOrder& order, const PairUpdater& update, const UpdateOptions& options)
      : facts_(order.facts()),
        update_(update),
        options_(options),
        beside_(options.data + ".versions"),
        order_checksum_(checksum_of(order, options.work)),
        work_(order.stream(), order.rules(options.work)),
        steps_(static_cast<std::size_t>(workers_of(facts_))),
        stores_(steps_.size()),
        held_(steps_.size()),
        changed_(static_cast<std::size_t>(facts_.items), false) {}

  UpdateReport run() {
    const auto begin = std::chrono::steady_clock::now();
    report_.steps = facts_.steps;
    check_data();
    const std::vector<JournalField> fields = {
        {"job", fmt::format("'{}'", options_.job)},
        {"data", fmt::format("'{}', items of {} bytes", options_.data, options_.item_bytes)},
        {"order", to_hex(order_checksum_)}};
    Sha256 claim;
    for (const JournalField& field : fields) {
      claim.add(field.value + "\n");
    }
    VersionedItems items(options_.data, beside_, facts_.items, options_.item_bytes,
                         {claim.finish(), {}}, options_.before_write);
    if (!has_journal() && is_there(beside_)) {
      throw BadInput(fmt::format(
          "{}: is there, but its journal {} is not, so {} may be half changed; bring the journal "
          "back, or restore the data and remove this file",
          beside_, options_.journal, options_.data));
    }
    Journal journal(options_.journal, fields, facts_.steps + 1);
    report_.note = journal.note();
    if (!journal.records().empty() && journal.records().back().step == facts_.steps + 1) {
      std::filesystem::remove(beside_);
      report_.finished = true;
      report_.steps_done = report_.steps_resumed = facts_.steps;
      return report_;
    }
    check_beside(journal);
    // A refused file is not changed: a journal whose last lines do not count keeps them until the
    // items are known to match the line before. A new journal is created before its second file,
    // which would belong to no job without it.
    const bool goes_on = !journal.records().empty();
    if (!goes_on) {
      journal.begin();
    }
    before_write();
    items.begin();
    for (std::uint64_t w = 0; w < workers_of(facts_); ++w) {
      memories_.emplace_back(std::min(facts_.room, facts_.items), options_.item_bytes);
    }
    ComputePool pool(static_cast<unsigned>(workers_of(facts_)));
    go_on(journal, items, pool);
    if (goes_on) {
      journal.begin();
    }
    while (report_.steps_done < facts_.steps && !cancelled()) {
      compute_step(items, pool);
      if (report_.steps_done % options_.checkpoint_every == 0 ||
          report_.steps_done == facts_.steps || cancelled()) {
        checkpoint(journal, items, pool);
      }
      if (options_.on_step) {
        options_.on_step(report_.steps_done);
      }
    }
    if (report_.steps_done == facts_.steps) {
      items.copy_back();
      before_write();
      journal.record({facts_.steps + 1, items.checksum()});
      before_write();
      std::filesystem::remove(beside_);
      report_.finished = true;
    }
    report_.elapsed = std::chrono::steady_clock::now() - begin;
    return report_;
  }

 private:
  [[nodiscard]] bool cancelled() const {
    return options_.cancelled != nullptr && options_.cancelled->load(std::memory_order_relaxed);
  }

  void before_write() const {
    if (options_.before_write) {
      options_.before_write();
    }
  }

  void check_data() const {
    if (options_.item_bytes == 0 || options_.journal.empty()) {
      throw BadInput(options_.journal.empty()
                         ? "a job whose items change needs a journal; name a file for it"
                         : "items of 0 bytes; give at least 1");
    }
    if (options_.checkpoint_every == 0) {
      throw BadInput("checkpoint_every 0: give at least 1 step");
    }
    std::error_code error;
    if (!std::filesystem::is_regular_file(options_.data, error)) {
      throw BadInput(options_.data +
                     ": is not there, or not a regular file; name the file of the items");
    }
    const std::uint64_t bytes = std::filesystem::file_size(options_.data);
    if (bytes != checked_multiply(facts_.items, options_.item_bytes)) {
      throw BadInput(
          fmt::format("{}: has {} bytes, but {} of {} make {}; give the right number and size",
                      options_.data, bytes, count_of(facts_.items, "item"), options_.item_bytes,
                      facts_.items * options_.item_bytes));
    }
  }

  // What cannot be looked at is not there; what opens it says why.
  [[nodiscard]] static bool is_there(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
  }

  // Whether there is a journal with something in it. @throws BadInput for what cannot be one
  [[nodiscard]] bool has_journal() const {
    std::error_code ignored;
    const auto status = std::filesystem::status(options_.journal, ignored);
    if (!std::filesystem::exists(status)) {
      return false;
    }
    if (!std::filesystem::is_regular_file(status)) {
      throw BadInput(options_.journal +
                     ": is not a regular file, so it cannot be a journal; name another");
    }
    const auto bytes = std::filesystem::file_size(options_.journal, ignored);
    return !ignored && bytes > 0;
  }

  // Checks that the second file matches the journal.
  void check_beside(const Journal& journal) const {
    const bool there = is_there(beside_);
    if (journal.records().empty()) {
      if (there && !journal.note().empty()) {
        throw BadInput(fmt::format(
            "{}: its first step is damaged, and {} is there, so {} may be half changed; bring the "
            "journal back, or restore the data and remove both",
            options_.journal, beside_, options_.data));
      }
      return;
    }
    if (!there) {
      throw BadInput(
          fmt::format("{}: is not there, and without it {} cannot go on; restore both, "
                      "or restore the data and remove the journal",
                      beside_, options_.journal));
    }
    const std::uint64_t bytes = std::filesystem::file_size(beside_);
    if (bytes != facts_.items * options_.item_bytes) {
      throw BadInput(fmt::format(
          "{}: has {} bytes, and {} has {}; restore both, or restore the data and remove this file "
          "and the journal",
          beside_, bytes, options_.data, facts_.items * options_.item_bytes));
    }
  }

  // Computes what the next step of each worker stores, and which changed items are held after it.
  // False at the end.
  bool plan_step() {
    for (Step& step : steps_) {
      if (!work_.next(step)) {
        return false;
      }
    }
    for (std::size_t w = 0; w < steps_.size(); ++w) {
      const Step& loads = steps_[w];
      stores_[w].clear();
      for (const Element x : loads.evict) {
        if (changed_[x]) {
          stores_[w].push_back(x);
          changed_[x] = false;
        }
        std::erase(held_[w], x);
      }
    }
    // Done afterwards, because another worker may load an item that one has dropped.
    for (std::size_t w = 0; w < steps_.size(); ++w) {
      const Step& loads = steps_[w];
      held_[w].insert(held_[w].end(), loads.load.begin(), loads.load.end());
      for (const auto& [x, y] : steps_[w].compute) {
        changed_[x] = true;
        changed_[y] = true;
      }
    }
    return true;
  }

  // The stores of a checkpoint: changed items in memory.
  void plan_checkpoint() {
    for (std::size_t w = 0; w < steps_.size(); ++w) {
      stores_[w].clear();
      for (const Element x : held_[w]) {
        if (changed_[x]) {
          stores_[w].push_back(x);
          changed_[x] = false;
        }
      }
    }
  }

  // Restores the state of the journal's last line.
  void go_on(const Journal& journal, VersionedItems& items, ComputePool& pool) {
    std::vector<Element> stored;
    const auto note_stores = [&] {
      for (const std::vector<Element>& each : stores_) {
        stored.insert(stored.end(), each.begin(), each.end());
      }
    };
    for (const JournalRecord& record : journal.records()) {
      while (report_.steps_done < record.step && plan_step()) {
        ++report_.steps_done;
        note_stores();
      }
      plan_checkpoint();
      note_stores();
      items.replay(stored);
      stored.clear();
    }
    report_.steps_resumed = report_.steps_done;
    items.read_all();
    if (journal.records().empty()) {
      return;
    }
    if (items.checksum() != journal.records().back().results) {
      throw BadInput(fmt::format(
          "{}: with {} it is not what the journal recorded after step {}: something else has "
          "changed it; restore both, or restart from the original data",
          options_.data, beside_, report_.steps_done));
    }
    pool.run(steps_.size(), [&](std::size_t w) {
      for (const Element x : held_[w]) {
        items.read(x, memories_[w].take(x));
      }
    });
    for (const std::vector<Element>& each : held_) {
      report_.loads += each.size();
    }
  }

  void store(VersionedItems& items, ComputePool& pool) {
    pool.run(steps_.size(), [&](std::size_t w) {
      for (const Element x : stores_[w]) {
        items.store(x, memories_[w].item(x).bytes);
      }
    });
  }

  void compute_step(VersionedItems& items, ComputePool& pool) {
    if (!plan_step()) {
      throw InternalError("the order ended before its last step");
    }
    ++report_.steps_done;
    store(items, pool);
    // All workers have stored, so items can move between workers.
    pool.run(steps_.size(), [&](std::size_t w) {
      for (const Element x : steps_[w].evict) {
        memories_[w].drop(x);
      }
      for (const Element x : steps_[w].load) {
        items.read(x, memories_[w].take(x));
      }
      for (const auto& [x, y] : steps_[w].compute) {
        update_({report_.steps_done, w, memories_[w].item(x), memories_[w].item(y)});
      }
    });
    for (std::size_t w = 0; w < steps_.size(); ++w) {
      report_.loads += steps_[w].load.size();
      report_.stores += stores_[w].size();
      report_.updates += steps_[w].compute.size();
    }
  }

  void checkpoint(Journal& journal, VersionedItems& items, ComputePool& pool) {
    plan_checkpoint();
    store(items, pool);
    for (const std::vector<Element>& each : stores_) {
      report_.checkpoint_stores += each.size();
    }
    items.sync();
    before_write();
    journal.record({report_.steps_done, items.checksum()});
    items.commit();
  }

  const LoadOrderFacts& facts_;
  const PairUpdater& update_;
  const UpdateOptions& options_;
  std::string beside_;
  Checksum order_checksum_;
  StepWork work_;
  std::vector<Step> steps_;                   // by worker: its step
  std::vector<std::vector<Element>> stores_;  // by worker: items that it stores now
  std::vector<std::vector<Element>> held_;    // by worker
  std::vector<bool> changed_;                 // by item: since it was loaded or stored
  std::vector<Memory> memories_;
  UpdateReport report_;
};

}  // namespace

UpdateReport update_pairs(const LoadOrder& order, const PairUpdater& update,
                          const UpdateOptions& options) {
  const std::uint64_t workers = workers_of(order.facts());
  if (order.facts().sizes) {
    throw BadInput("items that change have one size, item_bytes; give an order without sizes");
  }
  if (workers > most_job_threads) {
    throw BadInput(fmt::format("{} workers: a job has at most {}", workers, most_job_threads));
  }
  return UpdateJob(order, update, options).run();
}

}  // namespace changeover
