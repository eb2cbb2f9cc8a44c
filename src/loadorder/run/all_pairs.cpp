#include "changeover/loadorder/all_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "core/words.hpp"
#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/run/compute_pool.hpp"
#include "loadorder/run/earlier_shares.hpp"
#include "loadorder/run/journal.hpp"
#include "loadorder/run/reader.hpp"

namespace changeover {
namespace {

/// FNV-1a over all steps of the order, independent of the share.
std::uint64_t hash_of(const LoadOrder& order) {
  std::uint64_t hash = 14695981039346656037ULL;
  const auto mix = [&](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
      hash = (hash ^ (value >> (8 * i) & 0xff)) * 1099511628211ULL;
    }
  };
  Step step;
  for (const auto steps = order.stream(); steps->next(step);) {
    mix(step.evict.size());
    for (const Element x : step.evict) {
      mix(x);
    }
    for (const Element x : step.load) {
      mix(x);
    }
  }
  return hash;
}

/// The fields that identify a job: the computation, its data, its steps, and the place of the
/// results. All shares of a job have the same, except for their number.
std::vector<JournalField> fields_of(const ItemSource& source, const LoadOrder& order,
                                    const std::string& fingerprint,
                                    const AllPairsOptions& options) {
  const LoadOrderFacts& facts = order.facts();
  return {
      {"job", fmt::format("'{}'", options.job)},
      {"data", fmt::format("'{}'", source.describe())},
      {"time and contents of the data", fingerprint.empty() ? "unknown" : fingerprint},
      {"results",
       options.results == nullptr ? "not named" : fmt::format("'{}'", options.results->describe())},
      {"order",
       fmt::format("{} items, room {}, steps {:016x}{}", facts.items, facts.room, hash_of(order),
                   facts.wanted.are_all() ? std::string()
                                          : fmt::format(", pairs {:016x}", facts.wanted.hash()))}};
}

class Job {
 public:
  /// Shares of the order, or the given ones.
  Job(ItemSource& source, const LoadOrder& order, const WorkerSplit* shares,
      const PairCompute& compute, const AllPairsOptions& options)
      : source_(source),
        compute_(compute),
        options_(options),
        order_(order),
        items_(order.facts().items),
        room_of_order_(shares != nullptr ? shares->facts().room : order.facts().room),
        // A sum that overflows is more than all items, too.
        room_(options.read_ahead < items_ - std::min(room_of_order_, items_)
                  ? room_of_order_ + options.read_ahead
                  : items_),
        split_(shares) {}

  AllPairsReport run() {
    const auto begin = std::chrono::steady_clock::now();
    if (order_.facts().epochs > 1 || (split_ != nullptr && split_->facts().epochs > 1)) {
      throw BadInput(
          "all_pairs() computes each pair once: give an order of one epoch, or take "
          "update_pairs()");
    }
    const auto& sizes = order_.facts().sizes;
    if (sizes != nullptr && options_.read_ahead > 0) {
      throw BadInput("items have sizes, and memory is for all that is loaded: give no read_ahead");
    }
    report_.buffer_bytes =
        sizes != nullptr ? checked_add(sizes->memory, checked_multiply(room_, buffer_alignment))
                         : checked_multiply(room_, source_.buffer_bytes());
    if (options_.memory_bytes && report_.buffer_bytes > *options_.memory_bytes) {
      throw BadInput(
          fmt::format("room for {} takes {} bytes, but {} are allowed; plan for room {}",
                      count_of(room_, "item"), report_.buffer_bytes, *options_.memory_bytes,
                      *options_.memory_bytes / std::max<std::size_t>(1, source_.buffer_bytes())));
    }
    const std::string fingerprint = source_.fingerprint();
    const std::vector<JournalField> fields = fields_of(source_, order_, fingerprint, options_);
    earlier_ = EarlierShares(options_.earlier, fields, order_);
    if (split_ == nullptr) {
      const auto computed = [this](Element x, Element y) { return earlier_.computed(x, y); };
      own_.emplace(shares_of(order_, options_.share.of,
                             options_.earlier.empty()
                                 ? std::function<bool(Element, Element)>()
                                 : std::function<bool(Element, Element)>(computed)));
      split_ = &*own_;
    }
    report_.steps = split_->facts().workers[static_cast<std::size_t>(options_.share.index)].steps;
    assigner_.emplace(items_, room_, order_.facts().wanted, 0, false, split_->owners(),
                      order_.facts().sizes);
    std::optional<Journal> journal;
    if (!options_.journal.empty() || options_.results != nullptr) {
      claim_results(journal, fields);
    }
    compute_what_was_lost();
    skip_what_others_compute(*assigner_);
    if (report_.steps_done < report_.steps && !cancelled()) {
      compute_steps(journal);
    }
    report_.finished = report_.steps_done == report_.steps && lost_are_computed_;
    if (options_.results != nullptr) {
      options_.results->sync();
    }
    if (report_.finished && source_.fingerprint() != fingerprint) {
      throw BadInput(source_.describe() +
                     ": has changed while it was read, so the results are of neither; start again");
    }
    report_.elapsed = std::chrono::steady_clock::now() - begin;
    return report_;
  }

 private:
  [[nodiscard]] bool cancelled() const {
    return options_.cancelled != nullptr && options_.cancelled->load(std::memory_order_relaxed);
  }

  // Makes all checks first, and only then changes files.
  void claim_results(std::optional<Journal>& journal, std::vector<JournalField> fields) {
    fields.push_back({"shares", name_of_shares(*split_, earlier_.checksum())});
    Sha256 job;
    for (const JournalField& field : fields) {
      job.add(field.value);
      job.add(std::string_view("\n"));
    }
    if (!options_.journal.empty()) {
      fields.push_back({"share", fmt::format("{}", options_.share.index)});
      journal.emplace(options_.journal, fields, report_.steps);
      report_.note = journal->note();
    }
    if (options_.results != nullptr) {
      options_.results->open({job.finish(), options_.share});
    }
    if (journal) {
      find_again(journal->records());
      journal->begin();
    }
  }

  // The recorded steps whose results match.
  void find_again(const std::vector<JournalRecord>& records) {
    if (records.empty()) {
      return;
    }
    std::vector<const JournalRecord*> last(static_cast<std::size_t>(report_.steps), nullptr);
    for (const JournalRecord& record : records) {
      last[static_cast<std::size_t>(record.step - 1)] = &record;
    }
    is_done_.assign(last.size(), false);
    PairAssigner assigner(items_, room_, order_.facts().wanted, 0, false, split_->owners(),
                          order_.facts().sizes);
    skip_what_others_compute(assigner);
    for (std::size_t i = 0; i < last.size() && assigner.next(step_); ++i) {
      if (last[i] == nullptr) {
        continue;
      }
      is_done_[i] = options_.results == nullptr || checksum_of_step() == last[i]->results;
      ++(is_done_[i] ? report_.steps_resumed : report_.steps_lost);
    }
    report_.steps_done = report_.steps_resumed;
  }

  // The checksum of the stored results of the pairs of step_.
  std::optional<Checksum> checksum_of_step() {
    if (options_.results == nullptr) {
      return std::nullopt;
    }
    step_pairs_.assign(step_.pairs.begin(), step_.pairs.end());
    for (std::size_t i = 0; i < step_.step.load.size(); ++i) {
      if (step_.is_new[i]) {
        step_pairs_.emplace_back(step_.step.load[i], step_.step.load[i]);
      }
    }
    // Read-ahead changes the order within a step, but not its results.
    std::ranges::sort(step_pairs_);
    return options_.results->checksum({step_.step.number, step_pairs_});
  }

  // Pairs of the shares before are marked as computed, unless owners assign the pairs.
  void skip_what_others_compute(PairAssigner& assigner) {
    for (std::uint64_t w = 0; split_->owners() == nullptr && w < options_.share.index; ++w) {
      assigner.start(split_->stream(w));
      while (assigner.next(step_)) {
      }
    }
    assigner.start(split_->stream(options_.share.index));
  }

  // Computes first what an earlier run with another number of shares recorded and whose results do
  // not match; each of these steps is computed by one share.
  void compute_what_was_lost() {
    if (options_.results == nullptr) {
      for (std::uint64_t i = options_.share.index; i < earlier_.steps().size();
           i += options_.share.of) {
        ++report_.earlier_resumed;
      }
      return;
    }
    std::optional<ComputePool> pool;
    std::uint64_t number = 0;
    for (const EarlierShares::Done& done : earlier_.steps()) {
      if (number++ % options_.share.of != options_.share.index) {
        continue;
      }
      if (cancelled()) {
        lost_are_computed_ = false;
        return;
      }
      if (options_.results->checksum({done.step, done.pairs}) == done.results) {
        ++report_.earlier_resumed;
        continue;
      }
      if (!pool) {
        pool.emplace(std::max(1U, options_.threads));
      }
      compute_again(*pool, done);
      lost_are_computed_ = lost_are_computed_ && !cancelled();
    }
  }

  void compute_again(ComputePool& pool, const EarlierShares::Done& done) {
    std::vector<Element> needed;
    for (const auto& [x, y] : done.pairs) {
      needed.push_back(x);
      needed.push_back(y);
    }
    std::ranges::sort(needed);
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    Reader reader(source_, items_, room_, options_.readers, order_.facts().sizes);
    request(reader, needed);
    for (const Element x : needed) {
      static_cast<void>(reader.wait(x));
    }
    pool.run(done.pairs.size(), [&](std::size_t task) {
      if (!cancelled()) {
        const auto& [x, y] = done.pairs[task];
        compute_({0, reader.view(x), reader.view(y)});
      }
    });
    report_.loads += reader.requests();
    report_.bytes_read += reader.bytes_read();
    report_.most_in_memory = std::max(report_.most_in_memory, reader.most_used());
    report_.waited += reader.waited();
    pairs_ += done.pairs.size();
    ++report_.earlier_lost;
  }

  [[nodiscard]] bool is_to_do(std::uint64_t step) const {
    return step <= report_.steps &&
           (is_done_.empty() || !is_done_[static_cast<std::size_t>(step - 1)]);
  }

  void compute_steps(std::optional<Journal>& journal) {
    ComputePool pool(std::max(1U, options_.threads));
    for (std::vector<Element> memory = assigner_->memory(); !cancelled() && assigner_->next(step_);
         memory = assigner_->memory()) {
      if (is_to_do(step_.step.number)) {
        compute_stretch(pool, journal, memory);
      }
    }
  }

  // Computes steps from step_ on, up to one that is done already. Items in `memory` at its first
  // step have to be loaded again.
  void compute_stretch(ComputePool& pool, std::optional<Journal>& journal,
                       std::vector<Element> memory) {
    Reader reader(source_, items_, room_, options_.readers, order_.facts().sizes);
    std::erase_if(memory, [&](Element x) {
      return std::ranges::find(step_.step.evict, x) != step_.step.evict.end();
    });
    request(reader, memory);
    request(reader, step_.step.load);
    for (const Element x : memory) {
      static_cast<void>(reader.wait(x));
    }
    const AllPairsReport before = report_;
    while (true) {
      const bool goes_on = is_to_do(step_.step.number + 1);
      const bool computed = compute_step(reader, pool, goes_on);
      // Loads in progress end before their buffers do.
      report_.loads = before.loads + reader.requests();
      report_.bytes_read = before.bytes_read + reader.bytes_read();
      report_.most_in_memory = std::max(before.most_in_memory, reader.most_used());
      report_.waited = before.waited + reader.waited();
      if (!computed) {
        return;
      }
      finish_step(journal);
      if (!goes_on || cancelled() || !assigner_->next(step_)) {
        return;
      }
    }
  }

  static void request(Reader& reader, const std::vector<Element>& items) {
    for (const Element x : items) {
      reader.request(x);
    }
  }

  static void release(Reader& reader, const std::vector<Element>& items) {
    for (const Element x : items) {
      reader.release(x);
    }
  }

  // Computes the pairs of the step's arrivals, and starts the next loads as soon as their places
  // are free.
  bool compute_step(Reader& reader, ComputePool& pool, bool goes_on) {
    std::size_t from = 0;
    for (std::size_t i = 0; i < step_.step.load.size(); ++i) {
      const Element x = step_.step.load[i];
      const bool is_last = i + 1 == step_.step.load.size();
      const ItemView arrived = reader.wait(x);
      const std::size_t end = is_last ? step_.before : step_.arrival_end[i];
      // An item with itself goes first: it may be the longest task.
      const std::size_t alone = step_.is_new[i] ? 1 : 0;
      compute(reader, pool, from, end, alone, arrived);
      from = end;
    }
    if (cancelled()) {
      return false;
    }
    release(reader, step_.evicted_first);
    if (goes_on) {
      request(reader, assigner_->loaded_next());
    }
    compute(reader, pool, from, step_.pairs.size(), 0, {});
    if (cancelled()) {
      return false;
    }
    release(reader, step_.evicted_late);
    return true;
  }

  void compute(Reader& reader, ComputePool& pool, std::size_t from, std::size_t end,
               std::size_t alone, const ItemView& self) {
    pool.run(end - from + alone, [&](std::size_t task) {
      if (cancelled()) {
        return;
      }
      if (task < alone) {
        compute_({step_.step.number, self, self});
      } else {
        const auto& [x, y] = step_.pairs[from + task - alone];
        compute_({step_.step.number, reader.view(x), reader.view(y)});
      }
    });
    pairs_ += end - from + alone;
  }

  void finish_step(std::optional<Journal>& journal) {
    ++report_.steps_done;
    report_.pairs = pairs_;
    if (options_.on_step_done) {
      options_.on_step_done(step_.step.number);
    }
    if (journal) {
      if (options_.results != nullptr) {
        options_.results->sync();
      }
      journal->record({step_.step.number, checksum_of_step()});
    }
    if (options_.on_progress) {
      options_.on_progress(
          {report_.steps_done, report_.steps, report_.loads, report_.bytes_read, pairs_});
    }
  }

  ItemSource& source_;
  const PairCompute& compute_;
  const AllPairsOptions& options_;
  const LoadOrder& order_;
  std::uint64_t items_;
  std::uint64_t room_of_order_;
  std::uint64_t room_;
  const WorkerSplit* split_;  // own_, or the given one
  std::optional<WorkerSplit> own_;
  EarlierShares earlier_;
  bool lost_are_computed_ = true;  // for earlier shares
  std::optional<PairAssigner> assigner_;
  AssignedStep step_;
  std::vector<ItemPair> step_pairs_;
  std::vector<bool> is_done_;  // by step; empty if none is done
  std::uint64_t pairs_ = 0;
  AllPairsReport report_;
};

}  // namespace

namespace {

AllPairsReport run(ItemSource& source, const LoadOrder& order, const WorkerSplit* shares,
                   const PairCompute& compute, const AllPairsOptions& options) {
  const LoadOrderFacts& facts = order.facts();
  if (source.item_count() != facts.items) {
    throw BadInput(fmt::format("{} has {}, but the order is for {}; make an order for that number",
                               source.describe(), count_of(source.item_count(), "item"),
                               facts.items));
  }
  if (facts.items > max_elements_in_memory && facts.wanted.graph() == nullptr) {
    throw ImpossibleParameters(
        fmt::format("{} items: a job has at most {}; group items into larger ones", facts.items,
                    max_elements_in_memory));
  }
  if (options.threads > most_job_threads || options.readers > most_job_threads) {
    const bool is_threads = options.threads > most_job_threads;
    throw BadInput(fmt::format("{} {} are too many; give at most {}",
                               is_threads ? options.threads : options.readers,
                               is_threads ? "threads" : "readers", most_job_threads));
  }
  if (options.share.index >= options.share.of) {
    throw BadInput(fmt::format(
        "share {} of {}: shares are numbered from 0; give a number below that of the shares",
        options.share.index, options.share.of));
  }
  if (facts.every_step_read) {
    return Job(source, order, shares, compute, options).run();
  }
  // An unverified order is verified now, or during the work: in that case the results count only if
  // the order was right.
  const auto read = [&] {
    const auto steps = shares != nullptr ? shares->stream() : order.stream();
    const ScheduleVerdict verdict = check_schedule(
        *steps,
        {.items = facts.items, .room = facts.room, .wanted = facts.wanted, .sizes = facts.sizes});
    if (!verdict.valid() || verdict.steps != facts.steps) {
      throw BadInput(fmt::format("this is not a load order of {} with room for {}: {}{}",
                                 count_of(facts.items, "item"), facts.room, verdict.fault,
                                 verdict.example));
    }
  };
  if (!options.verify_beside) {
    read();
    return Job(source, order, shares, compute, options).run();
  }
  auto verdict = std::async(std::launch::async, read);
  AllPairsReport report = Job(source, order, shares, compute, options).run();
  verdict.get();
  return report;
}

}  // namespace

AllPairsReport all_pairs(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
                         const AllPairsOptions& options) {
  return run(source, order, nullptr, compute, options);
}

AllPairsReport all_pairs(ItemSource& source, const WorkerSplit& shares, const PairCompute& compute,
                         const AllPairsOptions& options) {
  if (options.share.of != shares.facts().workers.size()) {
    throw BadInput(fmt::format("share {} of {}: these are shares of {}", options.share.index,
                               options.share.of,
                               count_of(shares.facts().workers.size(), "worker")));
  }
  if (!options.earlier.empty()) {
    throw BadInput(
        "shares that were planned cannot use journals of an earlier run; give the order instead");
  }
  // With groups of items, the order that was cut has groups as items.
  LoadOrderFacts facts = shares.order().facts();
  facts.items = shares.facts().items;
  facts.room = shares.facts().room;
  facts.steps = 0;
  for (const WorkerFacts& worker : shares.facts().workers) {
    facts.steps += worker.steps;
  }
  const LoadOrder order(std::move(facts), [&shares] { return shares.stream(); });
  return run(source, order, &shares, compute, options);
}

}  // namespace changeover
