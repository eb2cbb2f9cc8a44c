#include "request/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"

namespace changeover::cli {
namespace {

using Words = std::vector<std::string>;

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// ".svg, .tex or .png".
std::string alternatives(const Words& words) {
  const Words all_but_last(words.begin(), words.end() - (words.empty() ? 0 : 1));
  return words.size() < 2 ? fmt::format("{}", fmt::join(words, ""))
                          : fmt::format("{} or {}", fmt::join(all_but_last, ", "), words.back());
}

// The only place that knows what the end of a file's name says.
struct Ending {
  std::string name;
  Words says;          // the formats that it stands for: a verb writes the first that it has
  Words holds = says;  // and those that may be asked for by name
};

const std::vector<Ending>& known_endings() {
  static const std::vector<Ending> all{
      {".txt", {"summary", "text", "table"}, {"summary", "text", "table", "colmap"}},
      {".json", {"json"}, {"json", "jsonl", "catalog", "marius"}},
      {".jsonl", {"jsonl", "catalog"}, {"jsonl", "catalog", "marius"}},
      {".ndjson", {"jsonl", "catalog"}, {"jsonl", "catalog", "marius"}},
      {".csv", {"csv"}},
      {".md", {"markdown"}},
      {".markdown", {"markdown"}},
      {".html", {"html"}},
      {".htm", {"html"}},
      {".xlsx", {"xlsx"}},
      {".svg", {"svg"}},
      {".tex", {"latex", "tikz"}},
      {".tikz", {"tikz"}},
      {".pdf", {"pdf"}},
      {".png", {"png"}},
      {".g", {"gap"}},
      {".gap", {"gap"}},
      {".sage", {"sage"}},
      {".xml", {"designtheory"}},
      {".bib", {"bibtex"}}};
  return all;
}

bool is_text(const std::string& format) {
  return format != "xlsx" && format != "pdf" && format != "png";
}

const Ending* known_ending(const std::string& name) {
  const auto& all = known_endings();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Ending& each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

// In small letters. What a name has of digits only ("sheet.2026"), or of more letters than any
// ending has (mktemp's "tmp.Qc5EWmNB1x"), is no ending.
std::string ending_of(const std::string& path) {
  constexpr std::size_t longest = 9;
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending.size() > longest || ending.find_first_not_of(".0123456789") == std::string::npos
             ? ""
             : ending;
}

// The format of these that a file of this ending has; nothing if none of them is written so.
std::optional<std::string> format_for(const Ending& ending, const Words& formats) {
  const auto found = std::find_if(ending.says.begin(), ending.says.end(),
                                  [&](const std::string& word) { return has(formats, word); });
  return found == ending.says.end() ? std::nullopt : std::optional(*found);
}

// ".svg, .tex or .png": one for each of the formats that has any.
std::string endings_for(const Words& formats) {
  Words endings;
  Words said;
  for (const Ending& ending : known_endings()) {
    const auto format = format_for(ending, formats);
    if (format && !has(said, *format)) {
      said.push_back(*format);
      endings.push_back(ending.name);
    }
  }
  return alternatives(endings);
}

}  // namespace

void OutputRequest::add_to(Verb& verb, const std::vector<std::string>& formats) {
  formats_ = formats;
  verb.choice(
      "-f,--format", asked_, formats,
      fmt::format("how the answer is written (default: as FILE ends, or {})", formats.front()));
  for (const std::string& word : formats) {
    if (word == "json" || word == "jsonl") {
      json_word_ = word;
      verb.flag("--json", json_,
                "the same as --format " + word + (word == "json" ? "" : ": one object per line"));
    }
  }
  verb.require([this] {
    const bool to_terminal = (path.empty() || path == "-") && isatty(STDOUT_FILENO) == 1;
    const std::string word = format();
    if (to_terminal && !is_text(word)) {
      throw UsageError{
          fmt::format("{} is not text, and standard output is a terminal; give -o FILE", word)};
    }
  });
  verb.option("-o,--output", path, "FILE", "write to FILE instead of standard output");
}

void OutputRequest::add_file_to(Verb& verb, const std::vector<std::string>& endings) {
  verb.option("-o,--output", path, "FILE", "write to FILE instead of standard output");
  verb.require([this, endings] {
    const std::string ending = ending_of(path);
    if (!ending.empty() && !has(endings, ending)) {
      throw UsageError{fmt::format("{}: unknown file extension '{}'; use {}", path, ending,
                                   alternatives(endings))};
    }
  });
}

std::string OutputRequest::format() const {
  if (json_ && !asked_.empty() && asked_ != json_word_) {
    throw UsageError{"--json and --format " + asked_ + " exclude each other"};
  }
  const std::string ending = ending_of(path);
  const std::string& asked = json_ ? json_word_ : asked_;
  if (!asked.empty()) {
    if (!name_allows(asked)) {
      const std::string fitting = endings_for({asked});
      throw UsageError{fmt::format("{}: {} contradicts the file extension '{}'; use {}", path,
                                   json_ ? "--json" : "--format " + asked, ending,
                                   fitting.empty() ? ".txt" : fitting)};
    }
    return asked;
  }
  if (ending.empty() || formats_.empty()) {
    return formats_.empty() ? "" : formats_.front();
  }
  const Ending* const known = known_ending(ending);
  const auto found = known == nullptr ? std::nullopt : format_for(*known, formats_);
  if (!found) {
    throw UsageError{fmt::format("{}: unknown file extension '{}'; use {}, or add --format", path,
                                 ending, endings_for(formats_))};
  }
  return *found;
}

bool OutputRequest::name_allows(const std::string& word) const {
  const Ending* const known = known_ending(ending_of(path));
  return known == nullptr || has(known->holds, word) || (known->name == ".txt" && is_text(word));
}

void OutputRequest::require(const std::string& option,
                            const std::vector<std::string>& formats) const {
  const std::string word = format();
  if (!has(formats, word)) {
    const bool by_name = !is_asked_for() && !ending_of(path).empty();
    throw UsageError{fmt::format("{} has no meaning with {}; it is for {}", option,
                                 by_name ? "a file named " + ending_of(path) : "--format " + word,
                                 fmt::join(formats, ", "))};
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
    throw MissingResource(path + ": cannot be written; allow writing there, or write elsewhere");
  }
}

}  // namespace changeover::cli
