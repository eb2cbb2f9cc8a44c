// One process at a time for a file that is read, changed and replaced as a whole.
//
//     FileLock lock("mine.csv");             // "mine.csv.lock", until the end of the block
//
// The file itself cannot carry the lock, for writing replaces it (io/output.hpp). The lock file
// says what it is, and its owner removes it, also on a signal; one that a killed process left does
// no harm, because the system drops the lock with the process. All names of a file, links included,
// have the same lock.
#pragma once

#include <string>

namespace changeover {

class FileLock {
 public:
  /// Takes the lock of `path`. @throws MissingResource with one line if another process has the
  /// lock, or if it cannot be made; BadInput if a file of another kind has its name: that file
  /// stays as it is.
  explicit FileLock(const std::string& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  void acquire(const std::string& path);

  std::string lock_path_;
  int descriptor_ = -1;
  int slot_ = -1;         // of io/file/unfinished.hpp
  bool removes_ = false;  // known at once: it was made here, or has our words
};

}  // namespace changeover
