#include "changeover/loadorder/all_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/workers.hpp"
#include "core/checked.hpp"
#include "loadorder/order/pair_assigner.hpp"
#include "loadorder/run/compute_pool.hpp"
#include "loadorder/run/journal.hpp"
#include "loadorder/run/reader.hpp"

namespace changeover {
namespace {

/// FNV-1a over all steps of the order, whatever the share.
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

/// What tells jobs apart, all shares of a job having the same: what is computed of which data, in
/// which steps, and where results go.
std::vector<JournalField> fields_of(const ItemSource& source, const LoadOrder& order,
                                    const std::string& fingerprint, bool cut_by_loads,
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
                                          : fmt::format(", pairs {:016x}", facts.wanted.hash()))},
      {"shares", fmt::format("{}{}", options.share.of, cut_by_loads ? ", even in loads" : "")}};
}

class Job {
 public:
  Job(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
      const AllPairsOptions& options)
      : source_(source),
        compute_(compute),
        options_(options),
        // A sum that wraps is more than all items, too.
        room_(options.read_ahead <
                      order.facts().items - std::min(order.facts().room, order.facts().items)
                  ? order.facts().room + options.read_ahead
                  : order.facts().items),
        split_(split_order(order_for_split(order), order.facts().items, order.facts().room,
                           options.share.of)),
        assigner_(order.facts().items, room_, order.facts().wanted) {}

  AllPairsReport run() {
    const auto begin = std::chrono::steady_clock::now();
    const SplitFacts& facts = split_.facts();
    report_.steps = facts.workers[static_cast<std::size_t>(options_.share.index)].steps;
    report_.buffer_bytes = checked_multiply(room_, source_.buffer_bytes());
    if (options_.memory_bytes && report_.buffer_bytes > *options_.memory_bytes) {
      throw BadInput(
          fmt::format("room for {} items takes {} bytes, but {} are allowed; plan for room {}",
                      room_, report_.buffer_bytes, *options_.memory_bytes,
                      *options_.memory_bytes / std::max<std::size_t>(1, source_.buffer_bytes())));
    }
    const std::string fingerprint = source_.fingerprint();
    std::optional<Journal> journal;
    if (!options_.journal.empty() || options_.results != nullptr) {
      claim_results(journal, fingerprint);
    }
    skip_what_others_compute(assigner_);
    if (report_.steps_done < report_.steps && !cancelled()) {
      compute_steps(journal);
    }
    report_.finished = report_.steps_done == report_.steps;
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
  static LoadOrder order_for_split(const LoadOrder& order) {
    return {order.facts(), [order_maker = &order] { return order_maker->stream(); }};
  }

  [[nodiscard]] bool cancelled() const {
    return options_.cancelled != nullptr && options_.cancelled->load(std::memory_order_relaxed);
  }

  // First everything that can speak against the job, and only then what changes files.
  void claim_results(std::optional<Journal>& journal, const std::string& fingerprint) {
    std::vector<JournalField> fields =
        fields_of(source_, split_.order(), fingerprint, split_.facts().cut_by_loads, options_);
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

  // Which recorded steps have the results that were recorded.
  void find_again(const std::vector<JournalRecord>& records) {
    if (records.empty()) {
      return;
    }
    std::vector<const JournalRecord*> last(static_cast<std::size_t>(report_.steps), nullptr);
    for (const JournalRecord& record : records) {
      last[static_cast<std::size_t>(record.step - 1)] = &record;
    }
    is_done_.assign(last.size(), false);
    PairAssigner assigner(split_.facts().items, room_, split_.order().facts().wanted);
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

  // Of what is stored for the pairs of step_.
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
    std::sort(step_pairs_.begin(), step_pairs_.end());
    return options_.results->checksum({step_.step.number, step_pairs_});
  }

  // Pairs of the shares before are spoken for.
  void skip_what_others_compute(PairAssigner& assigner) {
    for (std::uint64_t w = 0; w < options_.share.index; ++w) {
      assigner.start(split_.stream(w));
      while (assigner.next(step_)) {
      }
    }
    assigner.start(split_.stream(options_.share.index));
  }

  [[nodiscard]] bool is_to_do(std::uint64_t step) const {
    return step <= report_.steps &&
           (is_done_.empty() || !is_done_[static_cast<std::size_t>(step - 1)]);
  }

  void compute_steps(std::optional<Journal>& journal) {
    ComputePool pool(std::max(1U, options_.threads));
    for (std::vector<Element> memory = assigner_.memory(); !cancelled() && assigner_.next(step_);
         memory = assigner_.memory()) {
      if (is_to_do(step_.step.number)) {
        compute_stretch(pool, journal, memory);
      }
    }
  }

  // Steps from step_ on, one after another, up to one that is done already. What is in `memory`
  // when the first of them begins has to be loaded again.
  void compute_stretch(ComputePool& pool, std::optional<Journal>& journal,
                       std::vector<Element> memory) {
    Reader reader(source_, split_.facts().items, room_, options_.readers);
    std::erase_if(memory, [&](Element x) {
      return std::find(step_.step.evict.begin(), step_.step.evict.end(), x) !=
             step_.step.evict.end();
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
      // Loads under way end before their buffers do.
      report_.loads = before.loads + reader.requests();
      report_.bytes_read = before.bytes_read + reader.bytes_read();
      report_.most_in_memory = std::max(before.most_in_memory, reader.most_used());
      report_.waited = before.waited + reader.waited();
      if (!computed) {
        return;
      }
      finish_step(journal);
      if (!goes_on || cancelled() || !assigner_.next(step_)) {
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

  // Computes what the step's arrivals bring, and starts the next loads as soon as their places are
  // free.
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
      request(reader, assigner_.loaded_next());
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
  std::uint64_t room_;
  WorkerSplit split_;
  PairAssigner assigner_;
  AssignedStep step_;
  std::vector<ItemPair> step_pairs_;
  std::vector<bool> is_done_;  // by step; empty if none is
  std::uint64_t pairs_ = 0;
  AllPairsReport report_;
};

}  // namespace

AllPairsReport all_pairs(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
                         const AllPairsOptions& options) {
  const LoadOrderFacts& facts = order.facts();
  if (source.item_count() != facts.items) {
    throw BadInput(fmt::format("{} has {} items, but the order is for {}", source.describe(),
                               source.item_count(), facts.items));
  }
  if (facts.items > max_elements_in_memory && facts.wanted.graph() == nullptr) {
    throw ImpossibleParameters(fmt::format("{} items: a job has at most {}; make items larger",
                                           facts.items, max_elements_in_memory));
  }
  if (options.threads > most_job_threads || options.readers > most_job_threads) {
    throw BadInput(fmt::format("{} threads and {} readers: give at most {} of each",
                               options.threads, options.readers, most_job_threads));
  }
  if (options.share.index >= options.share.of) {
    throw BadInput(fmt::format("share {} of {}: shares are numbered from 0", options.share.index,
                               options.share.of));
  }
  if (!facts.every_step_read) {
    const auto steps = order.stream();
    const ScheduleVerdict verdict =
        check_schedule(*steps, {.items = facts.items, .room = facts.room, .wanted = facts.wanted});
    if (!verdict.valid() || verdict.steps != facts.steps) {
      throw BadInput(fmt::format("this is no load order of {} items with room for {}: {}{}",
                                 facts.items, facts.room, verdict.fault, verdict.example));
    }
  }
  return Job(source, order, compute, options).run();
}

}  // namespace changeover
