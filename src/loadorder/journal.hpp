// Internal: which steps of a job are done, on the disk.
//
// A text file: a line that names the job, then one line "step N" for each step that is done, in order.
// Only whole lines count, so a line that a crash has cut off is as if it had not been begun.
#pragma once

#include <cstdint>
#include <string>

namespace changeover {

class Journal {
 public:
  /// Opens or begins the journal of a job, `identity` in one line. @throws BadInput if the file is the
  /// journal of another job or none at all; MissingResource if it cannot be read or written.
  Journal(const std::string& path, const std::string& identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The last step that is recorded; 0 if none.
  [[nodiscard]] std::uint64_t last() const { return last_; }

  /// Records the step after last() and waits for the disk.
  void record(std::uint64_t step);

 private:
  void append(const std::string& text);

  std::string path_;
  int file_ = -1;
  std::uint64_t last_ = 0;
};

}  // namespace changeover
