#include "changeover/search/checkpoint.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <string_view>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output_file.hpp"
#include "changeover/io/text.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover {
namespace {

constexpr std::string_view first_line = "changeover-checkpoint 1";
constexpr std::size_t most_bytes = std::size_t{1} << 30;

std::uint64_t fnv1a(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return hash;
}

// One line after another, and one word of a line after another.
class Lines {
 public:
  Lines(std::string_view text, std::string path) : rest_(text), path_(std::move(path)) {}

  [[nodiscard]] bool next() {
    if (rest_.empty()) {
      return false;
    }
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return true;
  }

  [[nodiscard]] std::string_view line() const { return line_; }

  [[nodiscard]] std::string_view word() {
    const std::size_t end = line_.find(' ');
    const std::string_view word = line_.substr(0, end);
    line_.remove_prefix(end == std::string_view::npos ? line_.size() : end + 1);
    return word;
  }

  template <typename Number>
  [[nodiscard]] Number number() {
    const std::string_view digits = word();
    Number value{};
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc{} || end != digits.data() + digits.size()) {
      damaged();
    }
    return value;
  }

  [[noreturn]] void damaged() const {
    throw BadInput(fmt::format(
        "{}: the checkpoint is damaged; remove it to begin anew, or name another file", path_));
  }

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string path_;
};

SearchArm read_arm(Lines& lines) {
  SearchArm arm;
  const auto method = lines.number<unsigned>();
  if (method > static_cast<unsigned>(SearchArm::Method::imposed)) {
    lines.damaged();
  }
  arm.method = static_cast<SearchArm::Method>(method);
  arm.order = lines.number<std::uint32_t>();
  arm.fixed = lines.number<std::uint32_t>();
  arm.extra = lines.number<std::uint64_t>();
  arm.budget = lines.number<std::uint64_t>();
  arm.spent = lines.number<std::uint64_t>();
  arm.step = lines.number<std::uint64_t>();
  arm.missed = lines.number<std::uint64_t>();
  return arm;
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
  if (!std::filesystem::exists(path, ignored)) {
    return std::nullopt;
  }
  const std::string text = read_to_end(*open_input(path), most_bytes);
  if (!text.starts_with("changeover-checkpoint ")) {
    throw BadInput(fmt::format("{}: this is not a checkpoint; name another file", path));
  }
  Lines lines(text, path);
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
        fmt::format("{}: the checkpoint is of another search ({}, not {}); name another file", path,
                    lines.line().substr(2), header_words(p)));
  }
  Checkpoint checkpoint;
  checkpoint.parameters = p;
  Design best(p);
  while (lines.next()) {
    const std::string_view key = lines.word();
    if (key == "seed") {
      checkpoint.seed = lines.number<std::uint64_t>();
    } else if (key == "attempts") {
      checkpoint.attempts = lines.number<std::uint64_t>();
    } else if (key == "moves") {
      checkpoint.moves = lines.number<std::uint64_t>();
    } else if (key == "arm") {
      checkpoint.arms.push_back(read_arm(lines));
    } else if (key == "how") {
      checkpoint.how = lines.line();
    } else if (key == "block") {
      Block block;
      while (!lines.line().empty()) {
        block.push_back(lines.number<Element>());
      }
      try {
        best.append(block);
      } catch (const BadInput&) {
        lines.damaged();
      }
    } else if (key != "check") {
      lines.damaged();
    }
  }
  if (best.block_count() > 0) {
    if (!verify(best).valid()) {
      lines.damaged();
    }
    checkpoint.best = std::move(best);
  }
  return checkpoint;
}

}  // namespace changeover
