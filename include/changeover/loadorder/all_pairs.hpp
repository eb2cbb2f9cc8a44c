// Runs an all-pairs job out of core: loads the items in the planned order and computes every pair
// once.
//
//     FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});
//     PrefetchPlan plan = plan_prefetch(file.item_count(), room_for(file, 512 << 20));
//     AllPairsReport report = all_pairs(file, plan.order, [&](const PairWork& pair) {
//       gram(pair.first.bytes, pair.second.bytes);  // first = second: the pairs within one item
//     }, {.threads = 2, .read_ahead = plan.spare, .journal = "job.journal"});
//
// *Contract.* compute() is called exactly once for each pair of different items that the order is
// for (loadorder/wanted_pairs.hpp), and once for each loaded item with itself. `threads` threads
// call it at the same time, with the bytes of both items in memory. Other threads load items while
// pairs are computed; loadorder/workers.hpp says why an order for one item less with read_ahead = 1
// is often faster. At most room + read_ahead items are in memory or being loaded. That many buffers
// are allocated at the start, and nothing else grows with the data.
//
// *Journal.* A step is recorded in the journal, and synced to the disk, after three things: all its
// pairs are computed, on_step_done(step) has returned, and the results (JobResults) are on the
// disk. The record has a checksum of the results of the step. A job that is restarted with the same
// journal reads the results of the recorded steps and compares the checksums. It computes a step
// again if its results are lost or it had not finished. So results must be idempotent per step,
// which PairWork names. Without `results` the journal only records that on_step_done() returned;
// keeping the results is then up to the caller.
//
// A journal belongs to one job: its name, its data (as identified by ItemSource::fingerprint()),
// its order, its share, and the place of its results. The journal of another job is refused before
// anything is changed. Each line has a checksum of all lines before it: from the first line that
// was edited, moved or added, no line counts. Checksums are not signatures: wrong results with a
// forged journal are accepted.
//
// *Several processes.* With share = {i, n} this process takes the i-th of n stretches of the order,
// or of the given shares (loadorder/workers.hpp). Together the processes compute each pair once, as
// one process alone would, without communicating. Pairs that several stretches have are spread
// evenly for up to 5,000 items and for listed pairs; otherwise the first stretch that has a pair
// computes it. With the `earlier` journals a different number of processes continues a run: pairs
// that it computed are left out, and so are loads that only they needed. examples/all_pairs.cpp
// does this with the processes of mpirun.
//
// *Faults.* An exception from the source or from compute() ends the job after the pairs in
// progress; one from the source names the item. A cancelled job returns a report that says so. Data
// that change during the job are a fault at the end, because the results then belong to neither
// version. A job that was killed or failed has changed the results of its own steps only.
//
// In an order for items of different sizes (plan_sized_order()) each load has a buffer of the size
// of its item, freed when the item is evicted. The buffers have at most the bytes that the order
// was planned for, and 4,096 more per item. What the next step evicts is freed before its loads
// start.
//
// At most 65,535 items, since computed pairs are tracked in C(P,2) bits; any number if pairs are
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
// all_pairs() calls, in this order: open(), once the journal is locked and known to belong to the
// job, and before anything is computed; checksum(), for each step that an earlier run recorded, to
// compare; then, for each computed step, sync() and checksum(), whose value goes into the journal.
// All calls come from one thread, while compute() is not running.
//
// ResultFile is a file that can be written at any offset. While it is open it belongs to one job:
// processes that compute other shares of the same job may have it open, too; other jobs may not.
// The operating system frees the locks when the process ends. Locks are advisory: they bind every
// user of this class, and no other program.

/// The part of an order that a process takes.
struct OrderShare {
  std::uint64_t index = 0;
  std::uint64_t of = 1;
};

/// The job that wants to write results, identified by its checksum, and its share.
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

  /// Names the place and the shape of the results; a journal of another place or shape is refused.
  [[nodiscard]] virtual std::string describe() const = 0;

  /// Locks the place and allocates it. Contents of the right shape stay: they may come from an
  /// earlier run or another share. @throws MissingResource if another job has the place, or there
  /// is no space; then nothing has changed.
  virtual void open(const ResultsClaim& claim) = 0;

  /// The checksum of what is stored for these pairs now, read back from the storage.
  virtual Checksum checksum(const StepPairs& done) = 0;

  /// Returns when everything that was written is on the disk.
  virtual void sync() = 0;

 protected:
  JobResults() = default;
};

/// A file of results that is written in pieces, at any place.
class ResultFile {
 public:
  /// Opens nothing yet.
  explicit ResultFile(std::string path) : path_(std::move(path)) {}
  ~ResultFile();
  ResultFile(const ResultFile&) = delete;
  ResultFile& operator=(const ResultFile&) = delete;

  /// Opens or creates the file, locks it for the job, and sets its length, reserving the space
  /// where the file system can. @throws MissingResource if that fails, or another process has the
  /// file open for another job or for the same share; BadInput if it is not a regular file. After a
  /// fault nothing has changed.
  void open(std::uint64_t bytes, const ResultsClaim& claim);

  /// Writes at an offset. Thread-safe. @throws MissingResource if the system refuses.
  void write(const void* bytes, std::size_t count, std::uint64_t offset) const;

  /// Reads from an offset. Thread-safe. @throws MissingResource if the system refuses or the file
  /// has become shorter.
  void read(void* bytes, std::size_t count, std::uint64_t offset) const;

  /// Waits until the disk has the data. @throws MissingResource if the system refuses, or if the
  /// path no longer names this file or its size was changed: without the fault the results would be
  /// lost silently.
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

// The source of the items of an all-pairs job: a file of fixed-size items, or a function of the
// caller.
//
//     FileItems file("vectors.f32", 32 << 20, {.bypass_cache = true});   // items of 32 MiB
//     file.item_count();                           // the last one may be shorter
//
// Several threads read a source at the same time. The reader provides the buffers: each starts at a
// multiple of 4096 bytes and has buffer_bytes() bytes.

/// Buffers and direct reads start at multiples of this and have a length that is a multiple of it.
inline constexpr std::size_t buffer_alignment = 4096;

class ItemSource {
 public:
  virtual ~ItemSource() = default;
  ItemSource(const ItemSource&) = delete;
  ItemSource& operator=(const ItemSource&) = delete;

  [[nodiscard]] virtual std::uint64_t item_count() const = 0;

  /// The size in bytes of a buffer that holds any item.
  [[nodiscard]] virtual std::size_t buffer_bytes() const = 0;

  /// Reads an item and returns the part of `buffer` that it fills. Thread-safe. @throws BadInput if
  /// the item is malformed or cut off, MissingResource if it cannot be read; one line that names
  /// the item.
  virtual std::span<const std::byte> read(Element item, std::span<std::byte> buffer) = 0;

  /// Describes the data in messages and journals, e.g. the path and the size of a file.
  [[nodiscard]] virtual std::string describe() const = 0;

  /// A line that changes when the data change, so that a journal never mixes results of different
  /// data; empty if the source cannot tell.
  [[nodiscard]] virtual std::string fingerprint() const { return {}; }

 protected:
  ItemSource() = default;
};

struct FileItemsOptions {
  std::uint64_t header_bytes = 0;  ///< before the first item
  /// Keeps the data out of the page cache: with O_DIRECT or, where a file system lacks it, by
  /// ordinary reads whose pages are dropped afterwards (posix_fadvise, POSIX_FADV_DONTNEED).
  bool bypass_cache = false;
  /// Refuses a file whose last item would be shorter than the others.
  bool whole_items = false;
};

/// A file that is cut into items of the same size.
class FileItems final : public ItemSource {
 public:
  /// @throws BadInput if item_bytes = 0, the file is not a regular one or holds no item, or its
  /// last item is short and may not be; MissingResource if it cannot be opened.
  FileItems(const std::string& path, std::uint64_t item_bytes,
            const FileItemsOptions& options = {});
  ~FileItems() override;

  [[nodiscard]] std::uint64_t item_count() const override;
  [[nodiscard]] std::size_t buffer_bytes() const override;
  std::span<const std::byte> read(Element item, std::span<std::byte> buffer) override;
  [[nodiscard]] std::string describe() const override;

  /// The size, the modification and change times (the change time cannot be set back), and a
  /// checksum of the first, the last and up to 62 other pages. So `touch`, `mv` and `chmod` change
  /// the fingerprint, too.
  [[nodiscard]] std::string fingerprint() const override;

  /// The total size of all items.
  [[nodiscard]] std::uint64_t data_bytes() const;

  /// How bytes are read: "direct", "dropped" (pages are dropped after reading) or "cached".
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

  /// The caller chooses the fingerprint: a version, a checksum, …; see ItemSource::fingerprint().
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
  std::span<const std::byte>
      bytes;  ///< valid until compute() returns, or while the result of keep() is held
  const std::shared_ptr<const std::byte>* memory =
      nullptr;  ///< owned by the executor, like the bytes

  /// Shares ownership of the bytes: they stay unchanged while the result is held, also after the
  /// call. The executor then allocates other memory for the next item, beyond its room. Empty for a
  /// view that no executor made.
  [[nodiscard]] std::shared_ptr<const std::byte> keep() const {
    return memory == nullptr ? nullptr : *memory;
  }
};

/// The arguments of compute(): two items, the smaller number first, or one item twice.
struct PairWork {
  std::uint64_t step = 0;  ///< within this share, from 1; 0 for a step of an earlier run
  ItemView first;
  ItemView second;
};

using PairCompute = std::function<void(const PairWork&)>;

struct AllPairsProgress {
  std::uint64_t step = 0;   ///< that finished
  std::uint64_t steps = 0;  ///< in this share
  std::uint64_t loads = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t pairs = 0;  ///< computed, including items with themselves
};

/// The limit for either number of threads.
inline constexpr unsigned most_job_threads = 4096;

struct AllPairsOptions {
  unsigned threads = 1;          ///< that compute pairs
  unsigned readers = 1;          ///< that load items
  std::uint64_t read_ahead = 0;  ///< buffers beyond the room of the order, for loads in progress
  OrderShare share = {};
  std::string journal = {};  ///< path; empty for none
  /// Journals of an earlier run of the same job with another number of shares, and of the runs that
  /// it continued: what they record is not computed again. They stay unchanged. All processes of
  /// this run must be given the same journals, whenever they start.
  std::vector<std::string> earlier = {};
  /// Checks an unverified order while its pairs are computed, and not before. If the order is
  /// wrong, the job fails at the end.
  bool verify_beside = false;
  JobResults* results = nullptr;  ///< their place; opened even without a journal
  std::string job = {};           ///< name of the computation; a journal of another one is refused
  std::optional<std::uint64_t> memory_bytes = {};  ///< the job is refused if its buffers need more
  const std::atomic<bool>* cancelled = nullptr;    ///< checked before each pair
  std::function<void(std::uint64_t step)> on_step_done =
      {};  ///< called before the step is recorded
  std::function<void(const AllPairsProgress&)> on_progress = {};  ///< called after each step
};

struct AllPairsReport {
  bool finished = false;            ///< false if the job was cancelled
  std::uint64_t steps = 0;          ///< in this share
  std::uint64_t steps_done = 0;     ///< including recorded ones
  std::uint64_t steps_resumed = 0;  ///< recorded by an earlier run, with matching results
  std::uint64_t steps_lost = 0;     ///< recorded, but computed again because the results were lost
  /// Steps of earlier shares that this share has checked: recorded with matching results, and
  /// computed again because the results were lost.
  std::uint64_t earlier_resumed = 0;
  std::uint64_t earlier_lost = 0;
  std::string note;  ///< one line about journal lines that do not count; empty if all count
  std::uint64_t loads = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t pairs = 0;                 ///< calls of compute()
  std::uint64_t most_in_memory = 0;        ///< items, including those being loaded
  std::uint64_t buffer_bytes = 0;          ///< of all buffers together
  std::chrono::duration<double> waited{};  ///< time spent waiting for loads
  std::chrono::duration<double> elapsed{};
};

/// Runs a share of a job to its end. @throws BadInput if the order is empty or not for the items of
/// the source, the buffers exceed memory_bytes, the share does not exist, there are too many
/// threads, the journal is another job's, or the data changed during the job; ImpossibleParameters
/// above 65,535 items; MissingResource if the journal cannot be written or is in use, or threads
/// cannot be started; and what the source, compute(), the results or a callback throws.
AllPairsReport all_pairs(ItemSource& source, const LoadOrder& order, const PairCompute& compute,
                         const AllPairsOptions& options = {});

/// Runs one of the planned shares (split_load_order()) to its end: share options.share.index.
/// `earlier` journals are not supported. @throws as above; BadInput unless options.share.of is the
/// number of shares
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

/// An item in memory that the caller may change.
struct HeldItem {
  Element item = 0;
  std::span<std::byte> bytes;
  /// The owner of the bytes. The memory is used for another item when this one is evicted.
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
