// Internal: the finished steps of a job, with the checksums of their results, on the disk.
//
// A text file: a line that identifies the job, then a line for each finished step, in the order in
// which they finished:
//
//     step N RESULTS CHAIN
//
// RESULTS is the checksum of the results of the step ("-" if the job has no place for results).
// CHAIN is the first half of the checksum of all lines up to this one, without CHAIN itself. So a
// line counts only after the same lines as when it was written: a line that was edited, moved or
// taken from another journal does not count, and no line after it does. A step that is computed
// again gets a second line, which replaces the first. A line that a crash cut off does not count.
// off is as if it had not been begun.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"

namespace changeover {

/// A field that identifies a job.
struct JournalField {
  std::string name;
  std::string value;
};

struct JournalRecord {
  std::uint64_t step = 0;
  std::optional<Checksum> results;
};

class Journal {
 public:
  /// Opens, locks and reads the journal of a job with `steps` steps. The file is not changed before
  /// begin(); a new file is removed again without begin(). @throws BadInput if the file is the
  /// journal of another job, or no journal; MissingResource if it cannot be read or written, or
  /// another process uses it.
  Journal(const std::string& path, const std::vector<JournalField>& job, std::uint64_t steps);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The texts for "shares" and "share" in the first line of a journal, after the given fields of
  /// its job. @throws BadInput if it is another job's, MissingResource if it cannot be read
  [[nodiscard]] static std::pair<std::string, std::string> shares_in(
      const std::string& path, const std::vector<JournalField>& job);

  /// The recorded steps, in the order of the lines.
  [[nodiscard]] const std::vector<JournalRecord>& records() const { return records_; }

  /// One line about lines that do not count; empty if all count.
  [[nodiscard]] const std::string& note() const { return note_; }

  /// Prepares the file for record(): removes lines that do not count.
  void begin();

  /// Records a step and waits for the disk.
  void record(const JournalRecord& done);

 private:
  void open_locked();
  void read(const std::vector<JournalField>& job, std::uint64_t steps);
  void check_head(const std::string& found, const std::vector<JournalField>& job) const;
  void append(const std::string& text);
  [[nodiscard]] std::string line_of(const JournalRecord& done);
  [[nodiscard]] std::string text_up_to(std::uint64_t bytes) const;

  std::string path_;
  std::string head_;
  int file_ = -1;
  bool created_ = false;
  bool begun_ = false;
  std::uint64_t good_ = 0;  // total size of the lines that count
  Checksum chain_ = {};
  std::vector<JournalRecord> records_;
  std::string note_;
};

}  // namespace changeover
