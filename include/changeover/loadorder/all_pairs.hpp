// Runs an all-pairs job out of core: loads items in the order that was planned, computes every pair
// once.
//
//     FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});
//     PrefetchPlan plan = plan_prefetch(file.item_count(), room_for(file, 512 << 20));
//     AllPairsReport report = all_pairs(file, plan.order, [&](const PairWork& pair) {
//       gram(pair.first.bytes, pair.second.bytes);  // first = second: the pairs within one item
//     }, {.threads = 2, .read_ahead = plan.spare, .journal = "job.journal"});
//
// *Contract.* compute() is called exactly once for each pair of different items (each pair that the
// order is for, loadorder/wanted_pairs.hpp) and once for each item with itself that is loaded, by
// `threads` threads at once, with the bytes of both in memory. Loads run on threads of their own
// while pairs are computed (loadorder/workers.hpp, which also says why an order for one item less
// with read_ahead = 1 is often faster). Never more than room + read_ahead items are in memory or on
// their way: there are that many buffers, made at the start, and nothing else grows with the data.
//
// *Journal.* With a journal a step is recorded, and synced to the disk, after all its pairs are
// computed, on_step_done(step) has returned and `results` (loadorder/all_pairs.hpp) are on the
// disk, with the checksum of its results. When a job is started again with the same journal, the
// results of recorded steps are read again: a step whose checksum they have is not computed again;
// a step that has lost them, or was under way, is computed anew from its beginning. So results must
// be idempotent by step: PairWork says the step. Without `results` the journal can only say that
// on_step_done() has returned, and what became of them afterwards is the caller's affair.
//
// A journal belongs to one job: the name, the data, as far as ItemSource::fingerprint() knows them
// again, the order, the share and the place of the results. That of another job is refused before
// anything is touched. Each line vouches for those before it (src/loadorder/run/journal.hpp); what
// was edited, moved or added counts for nothing, nor does what follows. Checksums are no
// signatures: who writes wrong results together with a journal that was made to fit them is
// believed.
//
// *Several processes.* With share = {i, n} this process takes the i-th of n stretches of the order
// (loadorder/workers.hpp), or of the shares that it is given: all processes
// together compute what one alone would, each pair once, without talking to each other. Pairs that
// several stretches have are spread evenly, of up to 5,000 items or listed pairs; otherwise they
// are of the first that has them. With `earlier` journals another number of processes goes on where
// a run has ended: its pairs are left out, and what is then loaded for nothing, too.
// examples/all_pairs.cpp does that with the processes of mpirun.
//
// *Faults.* What the source throws ends the job after the pairs under way, naming the item; what
// compute() throws, too. A cancelled job returns a report that says so. Data that change while they
// are read are a fault at the end, since the results are then of neither. A killed or failed job
// has changed the results of its own steps only.
//
// Of an order for items of different size (plan_sized_order()) each load has a buffer of its item's
// size, given back when it is evicted: at most as many bytes as the order was planned for, and
// 4,096 for each item. What the next step evicts goes before its loads start.
//
// At most 65,535 items, so that pairs can be kept in mind: C(P,2) bits; any number if pairs are
// listed. An item is best a chunk of many vectors.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/workers.hpp"

namespace changeover {

// Where the results of an all-pairs job are, so that a journal can vouch for them.
//
//     class Distances final : public JobResults {
//      public:
//       std::string describe() const override { return "distances.f64, 300 rows of 300"; }
//       void open(const ResultsClaim& claim) override { file_.open(300 * 300 * 8, claim); }
//       Checksum checksum(const StepPairs& done) override;  // of what file_ holds for these pairs
//       void sync() override { file_.sync(); }
//      private:
//       ResultFile file_{"distances.f64"};
//     };
//
// all_pairs() calls, in this order: open(), when nothing speaks against the job any more (its
// journal is locked and belongs to it) and before anything is computed; checksum() for each step
// that an earlier run recorded, to compare; then for each step that was computed sync() and
// checksum(), which goes into the journal. Calls come from one thread, when compute() is not
// running.
//
// ResultFile is a file that is written at any place. While it is open it belongs to one job:
// processes that compute other shares of the same job may have it open too, no others. Locks end
// with the process that has them; they bind only those who ask for them, which is everybody who
// uses this class.

/// The part of an order that a process takes.
struct OrderShare {
  std::uint64_t index = 0;
  std::uint64_t of = 1;
};

/// Who wants to write results: a job, told from others by its checksum, and the share of it.
struct ResultsClaim {
  Checksum job = {};
  OrderShare share = {};
};

/// The pairs of a step: smaller item first, or an item with itself; sorted.
struct StepPairs {
  std::uint64_t step = 0;
  std::span<const std::pair<Element, Element>> pairs;
};

class JobResults {
 public:
  virtual ~JobResults() = default;
  JobResults(const JobResults&) = delete;
  JobResults& operator=(const JobResults&) = delete;

  /// Names the place and the shape of the results; a journal for others is refused.
  [[nodiscard]] virtual std::string describe() const = 0;

  /// Locks the place and gives it its shape. What fits stays as it is: it may be of an earlier run
  /// or of another share. @throws MissingResource if another job has the place, or there is no
  /// space: nothing has changed then.
  virtual void open(const ResultsClaim& claim) = 0;

  /// Of what is stored for these pairs now, read from where it is stored.
  virtual Checksum checksum(const StepPairs& done) = 0;

  /// Returns when everything that was written is on the disk.
  virtual void sync() = 0;

 protected:
  JobResults() = default;
};

/// A file of results that is written in pieces, at any place.
class ResultFile {
 public:
  /// Nothing is opened yet.
  explicit ResultFile(std::string path) : path_(std::move(path)) {}
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Opens or begins the file, locks it for the job and makes it so many bytes long, for which
  /// space is reserved where the file system can. @throws MissingResource if that is not possible
  /// or another process has the file for another job or for the same share, BadInput if it is not a
  /// regular file; nothing has changed then.
  void open(std::uint64_t bytes, const ResultsClaim& claim);

  /// Thread-safe. @throws MissingResource if the system refuses.
  void write(const void* bytes, std::size_t count, std::uint64_t offset) const;

  /// Thread-safe. @throws MissingResource if the system refuses or the file has become shorter.
  void read(void* bytes, std::size_t count, std::uint64_t offset) const;

  /// Waits for the disk. @throws MissingResource if the system refuses, or if the path no longer
  /// names this file or its size was changed: then the results would be lost without a
  /// word.
  void sync() const;

 private:
  void open_unlocked();
  void lock(const ResultsClaim& claim) const;
  void reserve(std::uint64_t bytes) const;
  [[nodiscard]] bool is_named() const;
  void close() noexcept;
  [[noreturn]] void refuse(const std::string& what) const;

  std::string path_;
  int file_ = -1;
  bool created_ = false;
  std::uint64_t bytes_ = 0;
};

// Where the items of an all-pairs job come from: a file of fixed-size items, or a function of
// yours.
//
//     FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});   // items of 32 MiB
//     file.item_count();                           // the last one may be shorter
//
// A source is read by several threads at once. Buffers are given by the reader; they start at a
// multiple of 4096 bytes and have buffer_bytes() bytes.

/// Start and length of buffers and of direct reads are multiples of it.
inline constexpr std::size_t buffer_alignment = 4096;

class ItemSource {
 public:
  virtual ~ItemSource() = default;
  ItemSource(const ItemSource&) = delete;
  ItemSource& operator=(const ItemSource&) = delete;

  [[nodiscard]] virtual std::uint64_t item_count() const = 0;

  /// Enough for any item.
  [[nodiscard]] virtual std::size_t buffer_bytes() const = 0;

  /// Reads an item and returns the part of `buffer` that it fills. Thread-safe. @throws BadInput if
  /// the item is malformed or cut off, MissingResource if it cannot be read; one line that names
  /// the item.
  virtual std::span<const std::byte> read(Element item, std::span<std::byte> buffer) = 0;

  /// Names the data in messages and in journals, e.g. the path and the size of a file.
  [[nodiscard]] virtual std::string describe() const = 0;

  /// One line that is another when the data are others, so that results of others are not taken for
  /// theirs; empty if the source cannot tell.
  [[nodiscard]] virtual std::string fingerprint() const { return {}; }

 protected:
  ItemSource() = default;
};

struct FileItemsOptions {
  std::uint64_t header_bytes = 0;  ///< before the first item
  /// Keep the data out of the page cache: O_DIRECT, or where a file system has none, ordinary reads
  /// whose pages are given back (posix_fadvise, POSIX_FADV_DONTNEED).
  bool bypass_cache = false;
};

/// A file cut into items of the same size.
class FileItems final : public ItemSource {
 public:
  /// @throws BadInput if item_bytes = 0, the file is not a regular one or holds no item;
  /// MissingResource if it cannot be opened.
  FileItems(const std::string& path, std::uint64_t item_bytes,
            const FileItemsOptions& options = {});
  ~FileItems() override;

  [[nodiscard]] std::uint64_t item_count() const override;
  [[nodiscard]] std::size_t buffer_bytes() const override;
  std::span<const std::byte> read(Element item, std::span<std::byte> buffer) override;
  [[nodiscard]] std::string describe() const override;

  /// The size, the times of the last change of the contents and of the file (the second cannot be
  /// set back), and a checksum of the first, the last and up to 62 other pages. So `touch`, `mv`
  /// and `chmod` make another fingerprint too.
  [[nodiscard]] std::string fingerprint() const override;

  /// Of all items together.
  [[nodiscard]] std::uint64_t data_bytes() const;

  /// How bytes are read: "direct", "dropped" (given back after reading) or "cached".
  [[nodiscard]] std::string access() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Items that a function makes.
class CallbackItems final : public ItemSource {
 public:
  /// Fills the buffer and returns how many bytes the item has. Thread-safe; may throw.
  using Read = std::function<std::size_t(Element item, std::span<std::byte> buffer)>;

  /// The fingerprint is yours to choose: a version, a checksum, …; see ItemSource::fingerprint().
  CallbackItems(std::uint64_t items, std::size_t bytes_per_item, Read read,
                std::string description = "a function", std::string fingerprint = {});

  [[nodiscard]] std::uint64_t item_count() const override { return items_; }
  [[nodiscard]] std::size_t buffer_bytes() const override { return bytes_; }
  std::span<const std::byte> read(Element item, std::span<std::byte> buffer) override;
  [[nodiscard]] std::string describe() const override { return description_; }
  [[nodiscard]] std::string fingerprint() const override { return fingerprint_; }

 private:
  std::uint64_t items_;
  std::size_t bytes_;
  Read read_;
  std::string description_;
  std::string fingerprint_;
};

/// How many items fit into `memory_bytes`. @throws BadInput if less than two do.
[[nodiscard]] std::uint64_t room_for(const ItemSource& source, std::uint64_t memory_bytes);

/// An item in memory.
struct ItemView {
  Element item = 0;
  std::span<const std::byte> bytes;  ///< until compute() returns, or for as long as keep() is held
  const std::shared_ptr<const std::byte>* memory =
      nullptr;  ///< of the executor, which owns the bytes

  /// Owns the bytes beyond the call: while it is held, they are not written to. The executor then
  /// takes other memory for the next item, beyond its room. Empty for a view that no executor made.
  [[nodiscard]] std::shared_ptr<const std::byte> keep() const {
    return memory == nullptr ? nullptr : *memory;
  }
};

/// What compute() is given: two items, the smaller number first, or one with itself.
struct PairWork {
  std::uint64_t step = 0;  ///< of this share, from 1; 0: of an earlier run's
  ItemView first;
  ItemView second;
};

using PairCompute = std::function<void(const PairWork&)>;

struct AllPairsProgress {
  std::uint64_t step = 0;   ///< finished
  std::uint64_t steps = 0;  ///< of this share
  std::uint64_t loads = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t pairs = 0;  ///< computed, items with themselves included
};

/// More threads than that, of either kind, are refused.
inline constexpr unsigned most_job_threads = 4096;

struct AllPairsOptions {
  unsigned threads = 1;          ///< that compute
  unsigned readers = 1;          ///< that load
  std::uint64_t read_ahead = 0;  ///< buffers beyond the order's room, for loads on their way
  OrderShare share = {};
  std::string journal = {};  ///< path; empty: none
  /// Journals of a run of the same job, and of those that it continued, in another number of
  /// shares: what they record is not computed again. They are not changed. All processes of this
  /// run are given the same, whenever they start.
  std::vector<std::string> earlier = {};
  /// An order that was not read before is read while its pairs are computed, and not first. If it
  /// is wrong the job fails at the end.
  bool verify_beside = false;
  JobResults* results = nullptr;  ///< where they are; opened even without a journal
  std::string job = {};  ///< names what is computed, so that a journal of something else is refused
  std::optional<std::uint64_t> memory_bytes = {};  ///< refuse to start if the buffers need more
  const std::atomic<bool>* cancelled = nullptr;    ///< looked at before each pair
  std::function<void(std::uint64_t step)> on_step_done = {};      ///< before it is recorded
  std::function<void(const AllPairsProgress&)> on_progress = {};  ///< after each step
};

struct AllPairsReport {
  bool finished = false;            ///< false: cancelled
  std::uint64_t steps = 0;          ///< of this share
  std::uint64_t steps_done = 0;     ///< of these, recorded ones included
  std::uint64_t steps_resumed = 0;  ///< recorded by an earlier run, results found again
  std::uint64_t steps_lost = 0;     ///< recorded, but without the results: computed again
  /// The same of steps of earlier shares that this one looked after.
  std::uint64_t earlier_resumed = 0;
  std::uint64_t earlier_lost = 0;
  std::string note;  ///< one line about lines of the journal that do not count, or empty
  std::uint64_t loads = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t pairs = 0;                 ///< calls of compute()
  std::uint64_t most_in_memory = 0;        ///< items, those on their way included
  std::uint64_t buffer_bytes = 0;          ///< of all buffers
  std::chrono::duration<double> waited{};  ///< for loads
  std::chrono::duration<double> elapsed{};
};

/// Runs a share of a job to its end. @throws BadInput if the order is none or not for the items of
/// the source, the buffers exceed memory_bytes, the share is none, there are too many threads, the
/// journal is another job's, or the data have changed at the end; ImpossibleParameters above 65,535
/// items; whatever the source, compute(), the results or a callback throws; MissingResource if the
/// journal cannot be written or is in use, or threads cannot be started.
AllPairsReport all_pairs(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
                         const AllPairsOptions& options = {});

/// The same for shares that were planned (split_load_order()), options.share.index of them; without
/// `earlier` journals. @throws as above; BadInput unless options.share.of is their number
AllPairsReport all_pairs(ItemSource& source, const WorkerSplit& shares, const PairCompute& compute,
                         const AllPairsOptions& options = {});

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
