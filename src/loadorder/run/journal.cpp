#include "loadorder/run/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "changeover/core/error.hpp"
#include "core/words.hpp"
#include "io/file/remedies.hpp"

namespace changeover {
namespace {

constexpr std::string_view title = "changeover journal 2: ";

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw MissingResource(
      fmt::format("{}: {}: {}; {}", path, what, std::strerror(errno), how_to_write(errno)));
}

// The name of a new file is in its folder, which must be synced, too.
void sync_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor >= 0) {
    static_cast<void>(::fsync(descriptor));
    ::close(descriptor);
  }
}

std::string part_of_head(const JournalField& field) {
  std::string text = field.name + " " + field.value + "; ";
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// The record in a line, without its chain; nullopt if there is none.
std::optional<JournalRecord> record_in(std::string_view line, std::uint64_t steps) {
  constexpr std::string_view step = "step ";
  JournalRecord record;
  if (line.substr(0, step.size()) != step) {
    return std::nullopt;
  }
  const char* const end = line.data() + line.size();
  const auto [rest, failure] = std::from_chars(line.data() + step.size(), end, record.step);
  if (failure != std::errc() || record.step == 0 || record.step > steps || rest == end) {
    return std::nullopt;
  }
  const std::string_view results(rest + 1, static_cast<std::size_t>(end - rest - 1));
  const std::string_view word = results.substr(0, results.find(' '));
  record.results = checksum_from_hex(word);
  return record.results || word == "-" ? std::optional(record) : std::nullopt;
}

}  // namespace

Journal::Journal(const std::string& path, const std::vector<JournalField>& job, std::uint64_t steps)
    : path_(path), head_(title) {
  for (const JournalField& field : job) {
    head_ += part_of_head(field);
  }
  head_.back() = '\n';
  chain_ = sha256(head_);
  try {
    open_locked();
    read(job, steps);
  } catch (...) {
    if (created_) {
      ::unlink(path_.c_str());
    }
    ::close(file_);
    throw;
  }
}

std::pair<std::string, std::string> Journal::shares_in(const std::string& path,
                                                       const std::vector<JournalField>& job) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  if (!file || !std::getline(file, line)) {
    throw MissingResource(path + ": the journal cannot be read, or is empty; name another file");
  }
  std::string head(title);
  for (const JournalField& field : job) {
    head += part_of_head(field);
  }
  constexpr std::string_view shares = "shares ";
  constexpr std::string_view share = "; share ";
  const std::size_t middle = line.find(share, head.size());
  if (line.compare(0, head.size(), head) != 0 ||
      line.compare(head.size(), shares.size(), shares) != 0 || middle == std::string::npos) {
    throw BadInput(path + ": is the journal of another job; name journals of this one");
  }
  const std::size_t begin = head.size() + shares.size();
  const std::size_t end = middle + share.size();
  return {line.substr(begin, middle - begin), line.substr(end, line.find(';', end) - end)};
}

Journal::~Journal() {
  if (created_ && !begun_) {
    ::unlink(path_.c_str());
  }
  ::close(file_);
}

void Journal::open_locked() {
  // Another process may remove its new journal between opening and locking: then try again.
  for (int attempt = 0; attempt < 100; ++attempt) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
    created_ = file_ < 0 && errno == ENOENT;
    if (created_) {
      file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (file_ < 0 && errno == EEXIST) {
        created_ = false;
        continue;
      }
    }
    struct stat mine {};
    if (file_ < 0 || ::fstat(file_, &mine) != 0) {
      created_ = false;
      refuse(path_, "the journal cannot be opened");
    }
    if (!S_ISREG(mine.st_mode)) {
      throw BadInput(path_ + ": is not a regular file, so it cannot be a journal; name another");
    }
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
      created_ = false;
      if (errno != EWOULDBLOCK) {
        refuse(path_, "the journal cannot be locked");
      }
      throw MissingResource(path_ + ": another process writes this file; wait until it finishes");
    }
    struct stat named {};
    if (::stat(path_.c_str(), &named) == 0 && named.st_ino == mine.st_ino &&
        named.st_dev == mine.st_dev) {
      return;
    }
    ::close(file_);
    file_ = -1;
    created_ = false;
  }
  throw MissingResource(path_ + ": other processes keep replacing this journal; wait for them");
}

std::string Journal::text_up_to(std::uint64_t bytes) const {
  std::string text;
  char piece[65536];
  while (text.size() < bytes) {
    const auto wanted =
        static_cast<std::size_t>(std::min<std::uint64_t>(sizeof piece, bytes - text.size()));
    const ssize_t got = ::pread(file_, piece, wanted, static_cast<off_t>(text.size()));
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      refuse(path_, "the journal cannot be read");
    }
    if (got == 0) {
      break;
    }
    text.append(piece, static_cast<std::size_t>(got));
  }
  return text;
}

void Journal::check_head(const std::string& found, const std::vector<JournalField>& job) const {
  if (found == head_) {
    return;
  }
  if (found.compare(0, title.size(), title) != 0) {
    throw BadInput(path_ + ": is not a journal of this version; name another file, or remove it");
  }
  std::string differs = "job";
  std::size_t at = title.size();
  for (const JournalField& field : job) {
    const std::string part = part_of_head(field);
    // Includes the semicolon, so that "shares 4" does not match the beginning of "shares 4, even in
    // loads". After the last one the line ends.
    if (at > found.size() || found.compare(at, part.size() - 1, part, 0, part.size() - 1) != 0) {
      differs = field.name;
      const std::size_t value = at + field.name.size() + 1;
      if (field.name == "shares" && value < found.size()) {
        differs += fmt::format(", there '{}', now '{}'",
                               found.substr(value, found.find_first_of(";\n", value) - value),
                               field.value);
      }
      break;
    }
    at += part.size();
  }
  throw BadInput(
      fmt::format("{}: is the journal of another job, which differs in: {}; name another file, or "
                  "remove this one to restart from the beginning",
                  path_, differs));
}

void Journal::read(const std::vector<JournalField>& job, std::uint64_t steps) {
  // Reads the first line only, since the file may be anything.
  const std::string found = text_up_to(head_.size());
  if (found.size() < head_.size() && head_.compare(0, found.size(), found) == 0) {
    return;  // new, or cut off in its first line
  }
  check_head(found, job);
  const std::string text = text_up_to(UINT64_MAX);
  good_ = head_.size();
  std::uint64_t number = 1;
  for (std::size_t end = text.find('\n', head_.size()); end != std::string::npos;
       end = text.find('\n', static_cast<std::size_t>(good_))) {
    const std::string_view line =
        std::string_view(text).substr(static_cast<std::size_t>(good_), end - good_);
    ++number;
    const std::optional<JournalRecord> record = record_in(line, steps);
    const Checksum before = chain_;
    if (!record || line_of(*record) != std::string(line) + "\n") {
      chain_ = before;
      const auto left =
          std::count(text.begin() + static_cast<std::ptrdiff_t>(good_), text.end(), '\n');
      note_ = fmt::format(
          "{}: line {} does not continue the lines before it, so {} from there on count{} for "
          "nothing",
          path_, number, count_of(static_cast<std::uint64_t>(left), "line"), left == 1 ? "s" : "");
      return;
    }
    records_.push_back(*record);
    good_ = end + 1;
  }
}

// Updates the chain.
std::string Journal::line_of(const JournalRecord& done) {
  std::string line =
      fmt::format("step {} {}", done.step, done.results ? to_hex(*done.results) : "-");
  Sha256 hash;
  hash.add(chain_);
  hash.add(line);
  chain_ = hash.finish();
  return line + " " + to_hex(chain_).substr(0, 32) + "\n";
}

void Journal::begin() {
  if (::ftruncate(file_, static_cast<off_t>(good_)) != 0 ||
      ::lseek(file_, static_cast<off_t>(good_), SEEK_SET) < 0) {
    refuse(path_, "the journal cannot be written");
  }
  if (good_ == 0) {
    append(head_);
    sync_folder_of(path_);
  }
  begun_ = true;
}

void Journal::append(const std::string& text) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::write(file_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      refuse(path_, "the journal cannot be written");
    }
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fdatasync(file_) != 0) {
    refuse(path_, "the journal cannot be written");
  }
}

void Journal::record(const JournalRecord& done) { append(line_of(done)); }

}  // namespace changeover
