#include "request/output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "changeover/io/output.hpp"

namespace changeover::cli {
void OutputRequest::add_to(Verb& verb, const std::vector<std::string>& formats) {
  usual_ = formats.front();
  verb.choice("-f,--format", asked_, formats, "how the answer is written (default " + usual_ + ")");
  for (const std::string& word : formats) {
    workbook_word_ = word == "xlsx" ? word : workbook_word_;
    if (word == "json" || word == "jsonl") {
      json_word_ = word;
      verb.flag("--json", json_,
                "the same as --format " + word + (word == "json" ? "" : ": one object a line"));
    }
  }
  verb.require([this] {
    const bool to_terminal = (path.empty() || path == "-") && isatty(STDOUT_FILENO) == 1;
    if (to_terminal && format() == workbook_word_) {
      throw UsageError{"a workbook is no text for a terminal; give -o FILE"};
    }
    static_cast<void>(format());
  });
  verb.option("-o,--output", path, "FILE", "write to FILE instead of standard output");
}

const std::string& OutputRequest::format() const {
  if (json_ && !asked_.empty() && asked_ != json_word_) {
    throw UsageError{"--json and --format " + asked_ + " exclude each other"};
  }
  const bool by_name = !workbook_word_.empty() && path.ends_with(".xlsx");
  return json_ ? json_word_ : !asked_.empty() ? asked_ : by_name ? workbook_word_ : usual_;
}

void OutputRequest::require(const std::string& option,
                            const std::vector<std::string>& formats) const {
  if (std::find(formats.begin(), formats.end(), format()) == formats.end()) {
    throw UsageError{fmt::format("{} has no meaning with --format {}; it is for {}", option,
                                 format(), fmt::join(formats, ", "))};
  }
}

void OutputRequest::check_writable() const {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool as_a_whole = !exists(status) || is_regular_file(status) || is_directory(status);
  if (!path.empty() && path != "-" && as_a_whole) {
    const OutputFile trial(path);  // Goes away without a trace.
  }
}

}  // namespace changeover::cli
