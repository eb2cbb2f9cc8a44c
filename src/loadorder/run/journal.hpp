// Internal: which steps of a job are done, and the checksums of their results, on the disk.
//
// A text file: a line that names the job, then a line for each step that was finished, in that
// order:
//
//     step N RESULTS CHAIN
//
// RESULTS is the checksum of the results of the step ("-" if the job does not say where they are).
// CHAIN is the first half of the checksum of all lines up to this one, as far as it goes without
// itself. So a line counts only behind the lines that it was written behind: what was edited, moved
// or taken from another journal does not count, nor does anything after it. A step that is done
// again gets a second line, which counts. Only whole lines count, so a line that a crash has cut
// off is as if it had not been begun.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "changeover/loadorder/all_pairs.hpp"

namespace changeover {

/// What tells one job from another.
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
  /// Opens, locks and reads the journal of a job with so many steps. The file is not changed before
  /// begin(); if it is new, it goes away again without begin(). @throws BadInput if the file is the
  /// journal of another job or none at all; MissingResource if it cannot be read or written, or
  /// another process has it.
  Journal(const std::string& path, const std::vector<JournalField>& job, std::uint64_t steps);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// What the first line of a journal says of "shares" and "share", behind these fields of a job.
  /// @throws BadInput if it is another job's, MissingResource if it cannot be read
  [[nodiscard]] static std::pair<std::string, std::string> shares_in(
      const std::string& path, const std::vector<JournalField>& job);

  /// What was there, in the order of the lines.
  [[nodiscard]] const std::vector<JournalRecord>& records() const { return records_; }

  /// One line, if lines were there that do not count; else empty.
  [[nodiscard]] const std::string& note() const { return note_; }

  /// Makes the file ready for record(): cuts off what does not count.
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
  std::uint64_t good_ = 0;  // bytes of the lines that count
  Checksum chain_ = {};
  std::vector<JournalRecord> records_;
  std::string note_;
};

}  // namespace changeover
