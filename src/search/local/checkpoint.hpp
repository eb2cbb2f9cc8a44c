// The state of a local search in a file, so that it can continue after it was killed.
//
//     changeover-checkpoint 1
//     # changeover design v=30 k=6 change=2 kind=linear
//     seed 7
//     attempts 41
//     moves 123456789
//     arm 2 7 1 0 524288 786432 1 3
//     how base blocks under an automorphism of order 7, cut
//     block 0 1 2 3 4 5
//     …
//     check 9ae16a3b2f90404f
//
// Files are replaced as a whole (io/output.hpp), so a process killed at any moment leaves the old
// or the new one. The last line is the FNV-1a hash of all before it. A file that is damaged or has
// other parameters is refused with one line, and never overwritten. A file need not be trusted
// beyond that: the design is verified before it is used, and every number must be possible for a
// search with these parameters.
//
// One search at a time uses a file: CheckpointFile locks FILE.lock as long as it lives, with a lock
// of the operating system that ends with the process. If another process replaces the file, its
// content is read before it is replaced again.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/developed.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/verify/verdict.hpp"
#include "io/file/file_lock.hpp"

namespace changeover {

/// One kind of attempt of local_search.hpp, and its cost so far.
struct SearchArm {
  /// Blocks without symmetry, from a random list (free, and cold at low temperatures), from the
  /// best design (reheated) or, for linear designs, from the best circular one (opened); base
  /// blocks of an imposed automorphism. Checkpoints have the numbers.
  enum class Method : std::uint8_t { free, reheated, imposed, cold, opened };
  Method method = Method::free;
  std::uint32_t order = 0;   ///< n of an imposed automorphism
  std::uint32_t fixed = 0;   ///< its fixed elements
  std::uint64_t extra = 0;   ///< elements above v, to be truncated
  std::uint64_t budget = 0;  ///< moves of the next attempt
  std::uint64_t spent = 0;   ///< moves so far
  std::uint64_t step = 1;    ///< how far below the best design it aims
  std::uint64_t missed = 0;  ///< what the last attempt at the nearest aim missed

  [[nodiscard]] bool from_random_list() const {
    return method == Method::free || method == Method::cold;
  }
  /// Whether it aims at one block fewer than the best design has, never at fewer.
  [[nodiscard]] bool from_design() const {
    return method == Method::reheated || method == Method::opened;
  }

  /// The imposed automorphism of designs on v elements; nullopt if there is none.
  [[nodiscard]] std::optional<Automorphism> automorphism(std::uint64_t v) const {
    return Automorphism::on(v + extra, order, fixed);
  }

  static constexpr std::uint32_t most_fixed = 2;
  static constexpr std::uint64_t most_extra = 3;
  static constexpr std::uint64_t most_moves = std::uint64_t{1}
                                              << 60;  ///< limit for budget and for spent
  static constexpr std::uint64_t most_step = std::uint64_t{1} << 40;
  static constexpr std::uint64_t most_missed = std::uint64_t{1} << 60;

  bool operator==(const SearchArm&) const = default;
};

struct Checkpoint {
  Parameters parameters;
  std::uint64_t seed = 1;
  std::uint64_t attempts = 0;
  std::uint64_t moves = 0;
  std::vector<SearchArm> arms;
  std::string how;                     ///< one line
  std::optional<VerifiedDesign> best;  ///< without labels and recipe
};

/// Writes the file, replacing an old one. @throws MissingResource if it cannot be written; the old
/// file is then intact.
void write_checkpoint(const Checkpoint& checkpoint, const std::string& path);

/// Reads the file; nullopt if it does not exist. @throws BadInput with one line if the file is
/// damaged, of another version, of other parameters than p, or not a regular file; MissingResource
/// if it cannot be read.
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::string& path,
                                                        const Parameters& p);

/// The checkpoint of a running search, locked. Not shared between threads.
class CheckpointFile {
 public:
  /// Locks the file (io/file/file_lock.hpp). @throws as FileLock, and MissingResource with one line
  /// if it cannot be written, so that this is known at the start and not after hours.
  CheckpointFile(std::string path, const Parameters& p);
  CheckpointFile(const CheckpointFile&) = delete;
  CheckpointFile& operator=(const CheckpointFile&) = delete;

  /// As read_checkpoint().
  [[nodiscard]] std::optional<Checkpoint> read();

  /// As write_checkpoint().
  void write(const Checkpoint& checkpoint);

  /// Whether the file is another one than was read or written last.
  [[nodiscard]] bool was_replaced() const;

 private:
  using Identity = std::array<std::int64_t, 5>;  // device, inode, size, time of change
  [[nodiscard]] std::optional<Identity> identity() const;

  std::string path_;
  Parameters parameters_;
  FileLock lock_;
  std::optional<Identity> known_;
};

}  // namespace changeover
