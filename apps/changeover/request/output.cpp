#include "request/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"

namespace changeover::cli {
void OutputRequest::add_to(Verb& verb, const std::vector<std::string>& formats) {
  usual_ = formats.front();
  verb.choice("-f,--format", asked_, formats, "how the answer is written (default " + usual_ + ")");
  for (const std::string& word : formats) {
    if (word == "xlsx") {
      endings_ = {{".xlsx", word}};
      binary_ = {word};
    }
    if (word == "json" || word == "jsonl") {
      json_word_ = word;
      verb.flag("--json", json_,
                "the same as --format " + word + (word == "json" ? "" : ": one object a line"));
    }
  }
  verb.require([this] {
    const bool to_terminal = (path.empty() || path == "-") && isatty(STDOUT_FILENO) == 1;
    const std::string& word = format();
    if (to_terminal && std::find(binary_.begin(), binary_.end(), word) != binary_.end()) {
      throw UsageError{fmt::format("{} is no text for a terminal; give -o FILE", word)};
    }
  });
  verb.option("-o,--output", path, "FILE", "write to FILE instead of standard output");
}

const std::string& OutputRequest::format() const {
  if (json_ && !asked_.empty() && asked_ != json_word_) {
    throw UsageError{"--json and --format " + asked_ + " exclude each other"};
  }
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto by_name = std::find_if(endings_.begin(), endings_.end(),
                                    [&](const auto& each) { return each.first == ending; });
  if (knows_all_endings_ && !json_ && asked_.empty() && ending.size() > 1 &&
      by_name == endings_.end()) {
    std::vector<std::string> known;
    for (const auto& [each, word] : endings_) {
      known.push_back(each);
    }
    throw UsageError{fmt::format("{}: which format is that? there are {}; or name it by --format",
                                 path, fmt::join(known, ", "))};
  }
  return json_                       ? json_word_
         : !asked_.empty()           ? asked_
         : by_name != endings_.end() ? by_name->second
                                     : usual_;
}

void OutputRequest::guess_by_name(std::vector<std::pair<std::string, std::string>> endings) {
  endings_ = std::move(endings);
  knows_all_endings_ = true;
}

void OutputRequest::require(const std::string& option,
                            const std::vector<std::string>& formats) const {
  if (std::find(formats.begin(), formats.end(), format()) == formats.end()) {
    throw UsageError{fmt::format("{} has no meaning with --format {}; it is for {}", option,
                                 format(), fmt::join(formats, ", "))};
  }
}

void OutputRequest::check_writable() const {
  if (path.empty() || path == "-") {
    // What is precious goes elsewhere then.
    const int flags = precious ? O_WRONLY : ::fcntl(STDOUT_FILENO, F_GETFL);
    if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) {
      throw MissingResource(
          "<stdout>: cannot write: the stream is closed; keep it open, or name a file");
    }
    return;
  }
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool as_a_whole = !exists(status) || is_regular_file(status) || is_directory(status);
  if (as_a_whole) {
    const OutputFile trial(path);  // Goes away without a trace.
  } else if (is_socket(status) || ::access(path.c_str(), W_OK) != 0) {
    throw MissingResource(path + ": cannot be written; write to a place where you may");
  }
}

}  // namespace changeover::cli
