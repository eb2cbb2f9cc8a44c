// Runs an order whose items change: training, out of core, with several workers, that goes on after
// a crash as if there had been none.
//
//     LoadOrder order = plan_disjoint_order(24, 5, 2);
//     UpdateOptions options{
//         .data = "embeddings.f32", .item_bytes = 4096, .journal = "job.journal"};
//     options.checkpoint_every = 10;
//     UpdateReport report = update_pairs(order, [&](const PairUpdate& pair) {
//       train(pair.first.bytes, pair.second.bytes);          // both may be written
//     }, options);
//
// *Contract.* `update` is called once for each pair that StepWork gives, with the bytes of both
// items in memory: pairs of one worker one after another, those of different workers at the same
// time, in the order of the steps. No item is with two workers at once, so `update` may write both
// items without a lock, and if it depends on nothing else the result depends on the order and the
// data alone. A worker is a task of a pool of as many threads.
//
// *A step.* All workers store what they evict if it has changed; when all have done so, they load
// and compute.
//
// *What survives.* The file has two places for each item: its own, and one in a file beside it,
// DATA.versions. What is stored goes to the place that the last checkpoint does not need. After
// every `checkpoint_every` steps, and at the end, what has changed and is still held is stored,
// too; both files reach the disk; then a line of the journal says which step it was, with one
// checksum of all items. From there on the other places count. So at every moment the disk holds
// the state after the step of the journal's last line, whole; what was stored later is as if it had
// not been. A job that is started again with the same journal reads all items, compares the
// checksum, and goes on after that step: what was computed after it is computed again, from the
// state before, so nothing is applied twice. At the end items are copied to their own places, and
// DATA.versions goes.
//
// While a job is under way, the data file alone is no state of anything: it, the journal and
// DATA.versions belong together. If DATA.versions is there without its journal, or the items are
// not those of the journal's last line, the job is refused, and nothing is changed. A journal is
// for one job: the same data, order, options, and name.
//
// *What it costs.* Twice the space of the data; one more reading of them at the beginning; a store
// of what is held for each checkpoint; SHA-256 of what is stored. Loads do not overlap computation.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "changeover/loadorder/workers.hpp"

namespace changeover {

/// An item in memory that may be written.
struct HeldItem {
  Element item = 0;
  std::span<std::byte> bytes;
  /// Owns the bytes, which another item takes when this one goes.
  const std::shared_ptr<std::vector<std::byte>>* memory = nullptr;
};

/// What `update` is given: first = second for an item alone.
struct PairUpdate {
  std::uint64_t step = 0;
  std::uint64_t worker = 0;
  HeldItem first;
  HeldItem second;
};

using PairUpdater = std::function<void(const PairUpdate&)>;

struct UpdateOptions {
  std::string data;  ///< items of the same size, which are changed; DATA.versions is beside it
  std::uint64_t item_bytes = 0;                  ///< of each
  std::string journal;                           ///< path
  std::uint64_t checkpoint_every = 100;          ///< steps, at least 1
  std::string job = {};                          ///< names what is computed
  ComputeRules work = {};                        ///< which pairs: both ways, items alone, shuffled
  const std::atomic<bool>* cancelled = nullptr;  ///< looked at after each step
  std::function<void(std::uint64_t step)> on_step = {};  ///< after each step
  std::function<void()> before_write = {};  ///< before anything is written; for tests of crashes
};

struct UpdateReport {
  bool finished = false;            ///< false: cancelled, with a checkpoint
  std::uint64_t steps = 0;          ///< of the order
  std::uint64_t steps_done = 0;     ///< recorded ones included
  std::uint64_t steps_resumed = 0;  ///< by the journal
  std::uint64_t loads = 0;
  std::uint64_t stores = 0;             ///< of what was evicted
  std::uint64_t checkpoint_stores = 0;  ///< of what was held at checkpoints
  std::uint64_t updates = 0;            ///< calls
  std::string note;                     ///< about lines of the journal that do not count, or empty
  std::chrono::duration<double> elapsed{};
};

/// Runs a job to its end. @throws BadInput if the order is none, the data are not its items, or the
/// journal is another job's or says otherwise than the data; MissingResource if something cannot be
/// read or written, or is in use; whatever `update` throws.
UpdateReport update_pairs(const LoadOrder& order, const PairUpdater& update,
                          const UpdateOptions& options);

}  // namespace changeover
