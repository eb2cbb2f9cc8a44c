// Where the results of an all-pairs job are, so that a journal can vouch for them.
//
//     class Distances final : public JobResults {
//      public:
//       std::string describe() const override { return "distances.f64, 300 rows of 300"; }
//       void open(const ResultsClaim& claim) override { file_.open(300 * 300 * 8, claim); }
//       Checksum checksum(const StepPairs& done) override;      // of what file_ holds for these pairs
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
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "changeover/core/block.hpp"
#include "changeover/core/sha256.hpp"

namespace changeover {

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
  /// names this file or somebody has changed its size: then the results would be lost without a
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

}  // namespace changeover
