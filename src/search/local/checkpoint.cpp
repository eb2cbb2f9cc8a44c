#include "search/local/checkpoint.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/verify/verdict.hpp"
#include "core/lines.hpp"
#include "core/parsed.hpp"
#include "search/local/segment_orbits.hpp"

namespace changeover {
namespace {

constexpr std::string_view first_line = "changeover-checkpoint 1";
constexpr std::size_t most_bytes_of_a_checkpoint = std::size_t{1} << 30;
constexpr std::size_t most_arms = 100'000;
constexpr std::size_t longest_how = 1000;

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return hash;
}

// Reads one line after another, and one word of a line after another.
class CheckpointLines {
 public:
  CheckpointLines(std::string_view text, std::string path) : lines_(text), path_(std::move(path)) {}

  [[nodiscard]] bool next() {
    const bool more = lines_.next();
    line_ = more ? lines_.line() : line_;
    return more;
  }

  [[nodiscard]] std::string_view line() const { return line_; }

  [[nodiscard]] std::string_view word() {
    const std::size_t end = line_.find(' ');
    const std::string_view word = line_.substr(0, end);
    line_.remove_prefix(end == std::string_view::npos ? line_.size() : end + 1);
    return word;
  }

  /// The next word, a number from `least` to `most`.
  template <typename Number>
  [[nodiscard]] Number number(Number least = 0, Number most = std::numeric_limits<Number>::max()) {
    const auto value = parsed<Number>(word());
    if (!value || *value < least || *value > most) {
      damaged();
    }
    return *value;
  }

  /// Checks that the line has no further words.
  void end() const {
    if (!line_.empty()) {
      damaged();
    }
  }

  [[noreturn]] void damaged() const {
    throw BadInput(fmt::format(
        "{}: the checkpoint is damaged; remove it to restart, or name another file", path_));
  }

 private:
  Lines lines_;
  std::string_view line_;  // unread part of it
  std::string path_;
};

SearchArm read_arm(CheckpointLines& lines, const Parameters& p) {
  SearchArm arm;
  arm.method = static_cast<SearchArm::Method>(
      lines.number<unsigned>(0, static_cast<unsigned>(SearchArm::Method::opened)));
  arm.order = lines.number<std::uint32_t>();
  arm.fixed = lines.number<std::uint32_t>(0, SearchArm::most_fixed);
  arm.extra = lines.number<std::uint64_t>(0, SearchArm::most_extra);
  arm.budget = lines.number<std::uint64_t>(1, SearchArm::most_moves);
  arm.spent = lines.number<std::uint64_t>(0, SearchArm::most_moves);
  arm.step = lines.number<std::uint64_t>(0, SearchArm::most_step);
  arm.missed = lines.number<std::uint64_t>(0, SearchArm::most_missed);
  lines.end();
  const bool imposed = arm.method == SearchArm::Method::imposed;
  if (imposed ? arm.order < 2 || arm.order > p.v + arm.extra || !arm.automorphism(p.v)
              : arm.order != 0 || arm.fixed != 0 || arm.extra != 0) {
    lines.damaged();
  }
  return arm;
}

// The text is shown to the user: it must not contain control characters.
std::string read_how(CheckpointLines& lines) {
  const std::string_view how = lines.line();
  const bool words = std::ranges::all_of(how, [](char c) { return c >= ' ' && c <= '~'; });
  if (!words || how.size() > longest_how) {
    lines.damaged();
  }
  return std::string(how);
}

Block read_block(CheckpointLines& lines, const Parameters& p) {
  Block block;
  while (!lines.line().empty()) {
    block.push_back(lines.number<Element>());
    if (block.size() > p.k) {
      lines.damaged();
    }
  }
  return block;
}

}  // namespace

void write_checkpoint(const Checkpoint& checkpoint, const std::string& path) {
  std::string text = fmt::format("{}\n# {}\nseed {}\nattempts {}\nmoves {}\n", first_line,
                                 header_words(checkpoint.parameters), checkpoint.seed,
                                 checkpoint.attempts, checkpoint.moves);
  for (const SearchArm& arm : checkpoint.arms) {
    text +=
        fmt::format("arm {} {} {} {} {} {} {} {}\n", static_cast<unsigned>(arm.method), arm.order,
                    arm.fixed, arm.extra, arm.budget, arm.spent, arm.step, arm.missed);
  }
  if (!checkpoint.how.empty()) {
    text += fmt::format("how {}\n", checkpoint.how);
  }
  if (checkpoint.best) {
    for (std::size_t i = 0; i < checkpoint.best->block_count(); ++i) {
      text += fmt::format("block {}\n", fmt::join(checkpoint.best->block(i), " "));
    }
  }
  text += fmt::format("check {:016x}\n", fnv1a(text));
  OutputFile file(path);
  file.write(text);
  file.commit();
}

std::optional<Checkpoint> read_checkpoint(const std::string& path, const Parameters& p) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!std::filesystem::exists(status)) {
    return std::nullopt;
  }
  // A pipe would block, and a device might never end.
  if (!std::filesystem::is_regular_file(status)) {
    throw BadInput(fmt::format("{}: a checkpoint must be a regular file; name another one", path));
  }
  const std::string text =
      read_to_end(*open_input(path), most_bytes_of_a_checkpoint, "name another file");
  if (!text.starts_with("changeover-checkpoint ")) {
    throw BadInput(fmt::format("{}: this is not a checkpoint; name another file", path));
  }
  CheckpointLines lines(text, path);
  if (!lines.next() || lines.line() != first_line) {
    throw BadInput(fmt::format("{}: the checkpoint is of another version ({}); name another file",
                               path, lines.line()));
  }
  const std::size_t check = text.rfind("\ncheck ");
  if (check == std::string::npos ||
      text.substr(check + 1) !=
          fmt::format("check {:016x}\n", fnv1a(std::string_view(text).substr(0, check + 1)))) {
    lines.damaged();
  }
  if (!lines.next() || !lines.line().starts_with("# ")) {
    lines.damaged();
  }
  if (lines.line().substr(2) != header_words(p)) {
    throw BadInput(
        fmt::format("{}: the checkpoint belongs to another search ({}, not {}); name another file",
                    path, lines.line().substr(2), header_words(p)));
  }
  Checkpoint checkpoint;
  checkpoint.parameters = p;
  Design best(p);
  while (lines.next()) {
    const std::string_view key = lines.word();
    if (key == "seed") {
      checkpoint.seed = lines.number<std::uint64_t>();
      lines.end();
    } else if (key == "attempts") {
      checkpoint.attempts = lines.number<std::uint64_t>(0, SearchArm::most_moves);
      lines.end();
    } else if (key == "moves") {
      checkpoint.moves = lines.number<std::uint64_t>(0, SearchArm::most_moves);
      lines.end();
    } else if (key == "arm") {
      checkpoint.arms.push_back(read_arm(lines, p));
      if (checkpoint.arms.size() > most_arms) {
        lines.damaged();
      }
    } else if (key == "how") {
      checkpoint.how = read_how(lines);
    } else if (key == "block") {
      try {
        best.append(read_block(lines, p));
      } catch (const BadInput&) {
        lines.damaged();
      }
    } else if (key != "check") {
      lines.damaged();
    }
  }
  if (best.block_count() > 0) {
    checkpoint.best = verified(std::move(best));
    if (!checkpoint.best) {
      lines.damaged();
    }
  }
  return checkpoint;
}

CheckpointFile::CheckpointFile(std::string path, const Parameters& p)
    : path_(std::move(path)), parameters_(p), lock_(path_) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path_, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    const OutputFile trial(path_);  // is removed without a trace
  }
}

std::optional<CheckpointFile::Identity> CheckpointFile::identity() const {
  struct stat status {};
  if (::stat(path_.c_str(), &status) != 0) {
    return std::nullopt;
  }
  return Identity{
      static_cast<std::int64_t>(status.st_dev), static_cast<std::int64_t>(status.st_ino),
      static_cast<std::int64_t>(status.st_size), static_cast<std::int64_t>(status.st_mtim.tv_sec),
      static_cast<std::int64_t>(status.st_mtim.tv_nsec)};
}

std::optional<Checkpoint> CheckpointFile::read() {
  const auto there = identity();
  auto checkpoint = read_checkpoint(path_, parameters_);
  known_ = there;  // a file that cannot be read stays unknown, and is not replaced
  return checkpoint;
}

void CheckpointFile::write(const Checkpoint& checkpoint) {
  write_checkpoint(checkpoint, path_);
  known_ = identity();
}

bool CheckpointFile::was_replaced() const {
  const auto now = identity();
  return now && now != known_;
}

}  // namespace changeover
