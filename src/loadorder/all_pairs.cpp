#include "changeover/loadorder/all_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "changeover/core/checked.hpp"
#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/loadorder/load_check.hpp"
#include "changeover/loadorder/workers.hpp"
#include "loadorder/compute_pool.hpp"
#include "loadorder/journal.hpp"
#include "loadorder/pair_assigner.hpp"
#include "loadorder/reader.hpp"

namespace changeover {
namespace {

/// One line that tells jobs apart: what is computed of which data, in which steps.
std::string identity_of(const ItemSource& source, const WorkerSplit& split,
                        const AllPairsOptions& options) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a over all steps
  const auto mix = [&](std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
      hash = (hash ^ (value >> (8 * i) & 0xff)) * 1099511628211ULL;
    }
  };
  LoadStep step;
  for (const auto steps = split.stream(options.share.index); steps->next(step);) {
    mix(step.evict.size());
    for (const Element x : step.evict) {
      mix(x);
    }
    for (const Element x : step.load) {
      mix(x);
    }
  }
  std::string identity =
      fmt::format("job '{}', data '{}', {} items, room {}, share {} of {}, steps {:016x}",
                  options.job, source.describe(), split.facts().items, split.facts().room,
                  options.share.index, options.share.of, hash);
  std::replace(identity.begin(), identity.end(), '\n', ' ');
  return identity;
}

class Job {
 public:
  Job(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
      const AllPairsOptions& options)
      : source_(source),
        compute_(compute),
        options_(options),
        room_(std::min(order.facts().room + options.read_ahead, order.facts().items)),
        split_(split_order(order_for_split(order), order.facts().items, order.facts().room,
                           options.share.of)),
        assigner_(order.facts().items, room_) {}

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
    std::optional<Journal> journal;
    if (!options_.journal.empty()) {
      journal.emplace(options_.journal, identity_of(source_, split_, options_));
      report_.steps_resumed = std::min(journal->last(), report_.steps);
    }
    skip_what_is_done();
    if (report_.steps_done < report_.steps && !cancelled()) {
      compute_steps(journal);
    }
    report_.finished = report_.steps_done == report_.steps;
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

  // Pairs of the workers before, and of the steps of an earlier run, are spoken for.
  void skip_what_is_done() {
    for (std::uint64_t w = 0; w < options_.share.index; ++w) {
      assigner_.start(split_.stream(w));
      while (assigner_.next(step_)) {
      }
    }
    assigner_.start(split_.stream(options_.share.index));
    for (; report_.steps_done < report_.steps_resumed; ++report_.steps_done) {
      if (!assigner_.next(step_)) {
        throw InternalError("a journal has more steps than its job");
      }
    }
  }

  void compute_steps(std::optional<Journal>& journal) {
    Reader reader(source_, split_.facts().items, room_, options_.readers);
    ComputePool pool(std::max(1U, options_.threads));
    // What is in memory when the first step begins has to be loaded again.
    std::vector<Element> again = assigner_.memory();
    bool requested = false;
    while (!cancelled() && assigner_.next(step_)) {
      if (!requested) {
        std::erase_if(again, [&](Element x) {
          return std::find(step_.step.evict.begin(), step_.step.evict.end(), x) !=
                 step_.step.evict.end();
        });
        request(reader, again);
        request(reader, step_.step.load);
        for (const Element x : again) {
          static_cast<void>(reader.wait(x));
        }
        requested = true;
      }
      if (!compute_step(reader, pool)) {
        break;
      }
      finish_step(reader, journal);
    }
    // Loads under way end before their buffers do.
    report_.loads = reader.requests();
    report_.bytes_read = reader.bytes_read();
    report_.most_in_memory = reader.most_used();
    report_.waited = reader.waited();
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

  // Computes what the step's arrivals bring, and starts the next loads as soon as their places are free.
  bool compute_step(Reader& reader, ComputePool& pool) {
    std::size_t from = 0;
    for (std::size_t i = 0; i < step_.step.load.size(); ++i) {
      const Element x = step_.step.load[i];
      const bool is_last = i + 1 == step_.step.load.size();
      const std::span<const std::byte> bytes = reader.wait(x);
      const std::size_t end = is_last ? step_.before : step_.arrival_end[i];
      // An item with itself goes first: it may be the longest task.
      const std::size_t alone = step_.is_new[i] ? 1 : 0;
      compute(reader, pool, from, end, alone, {x, bytes});
      from = end;
    }
    if (cancelled()) {
      return false;
    }
    release(reader, step_.evicted_first);
    request(reader, assigner_.loaded_next());
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
        compute_({step_.step.number, {x, reader.bytes(x)}, {y, reader.bytes(y)}});
      }
    });
    pairs_ += end - from + alone;
  }

  void finish_step(const Reader& reader, std::optional<Journal>& journal) {
    ++report_.steps_done;
    report_.pairs = pairs_;
    if (options_.on_step_done) {
      options_.on_step_done(step_.step.number);
    }
    if (journal) {
      journal->record(step_.step.number);
    }
    if (options_.on_progress) {
      options_.on_progress(
          {report_.steps_done, report_.steps, reader.requests(), reader.bytes_read(), pairs_});
    }
  }

  ItemSource& source_;
  const PairCompute& compute_;
  const AllPairsOptions& options_;
  std::uint64_t room_;
  WorkerSplit split_;
  PairAssigner assigner_;
  AssignedStep step_;
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
  if (facts.items > max_elements_in_memory) {
    throw ImpossibleParameters(fmt::format("{} items: a job has at most {}; make items larger",
                                           facts.items, max_elements_in_memory));
  }
  if (options.share.index >= options.share.of) {
    throw BadInput(fmt::format("share {} of {}: shares are numbered from 0", options.share.index,
                               options.share.of));
  }
  if (!facts.every_step_read) {
    const auto steps = order.stream();
    const LoadVerdict verdict = check_loads(*steps, facts.items, facts.room);
    if (!verdict.valid() || verdict.steps != facts.steps) {
      throw BadInput(fmt::format("this is no load order of {} items with room for {}: {}{}",
                                 facts.items, facts.room, verdict.fault,
                                 verdict.uncovered_example));
    }
  }
  return Job(source, order, compute, options).run();
}

}  // namespace changeover
