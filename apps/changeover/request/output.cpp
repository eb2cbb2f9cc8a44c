#include "request/output.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "core/contains.hpp"
#include "core/words.hpp"

namespace changeover::cli {
namespace {

using Words = std::vector<std::string>;

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
  const auto found = std::ranges::find(all, name, &Ending::name);
  return found == all.end() ? nullptr : &*found;
}

// In small letters. What a name has of digits only ("sheet.2026"), or of more letters than any
// ending has (mktemp's "tmp.Qc5EWmNB1x"), is no ending.
std::string ending_of(const std::string& path) {
  constexpr std::size_t longest = 9;
  std::string ending = lower_case(std::filesystem::path(path).extension().string());
  return ending.size() > longest || ending.find_first_not_of(".0123456789") == std::string::npos
             ? ""
             : ending;
}

// The format of these that a file of this ending has; nothing if none of them is written so.
std::optional<std::string> format_for(const Ending& ending, const Words& formats) {
  const auto found = std::ranges::find_if(
      ending.says, [&](const std::string& word) { return contains(formats, word); });
  return found == ending.says.end() ? std::nullopt : std::optional(*found);
}

// ".svg, .tex or .png": one for each of the formats that has any.
std::string endings_for(const Words& formats) {
  Words endings;
  Words said;
  for (const Ending& ending : known_endings()) {
    const auto format = format_for(ending, formats);
    if (format && !contains(said, *format)) {
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
      fmt::format("output format (default: by the extension of FILE, or {})", formats.front()));
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
    if (!ending.empty() && !contains(endings, ending)) {
      throw UsageError{fmt::format("{}: unknown file extension '{}'; use {}", path, ending,
                                   alternatives(endings))};
    }
  });
}

std::string OutputRequest::format() const {
  if (json_ && !asked_.empty() && asked_ != json_word_) {
    throw UsageError{"--json and --format " + asked_ + " exclude each other; give one of them"};
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
  return known == nullptr || contains(known->holds, word) ||
         (known->name == ".txt" && is_text(word));
}

std::optional<std::string> OutputRequest::refusal(const std::string& option,
                                                  const std::vector<std::string>& formats) const {
  const std::string word = format();
  if (contains(formats, word)) {
    return std::nullopt;
  }
  const bool by_name = !is_asked_for() && !ending_of(path).empty();
  return fmt::format("{} has no meaning with {}; it is for {}", option,
                     by_name ? "a file named " + ending_of(path) : "--format " + word,
                     fmt::join(formats, ", "));
}

void OutputRequest::require(const std::string& option,
                            const std::vector<std::string>& formats) const {
  if (const auto defect = refusal(option, formats)) {
    throw UsageError{*defect};
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

namespace {

// Standard input is asked for what it is: not every system has /dev/stdin.
bool is_standard_input(const std::string& path) {
  struct stat named {};
  struct stat input {};
  return ::stat(path.c_str(), &named) == 0 && ::fstat(STDIN_FILENO, &input) == 0 &&
         named.st_dev == input.st_dev && named.st_ino == input.st_ino;
}

bool is_read_from(const std::string& output, const std::string& input) {
  std::error_code ignored;
  return input == "-" ? is_standard_input(output)
                      : !input.empty() && std::filesystem::equivalent(output, input, ignored);
}

// The file that a path names when it is written: links are followed, also to where nothing is yet.
std::filesystem::path written_file(std::filesystem::path path) {
  constexpr int most_links = 40;
  std::error_code ignored;
  for (int links = 0; links < most_links && std::filesystem::is_symlink(path, ignored); ++links) {
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  }
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::filesystem::path real = std::filesystem::weakly_canonical(folder, ignored);
  return (real.empty() ? folder : real) / path.filename();
}

// Whether two paths lead to one file, or would if it were there.
bool same_file(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return std::filesystem::equivalent(one, other, ignored) ||
         written_file(one) == written_file(other);
}

}  // namespace

void check_kept(const std::string& output, const InputFile& kept) {
  const auto& [what, path] = kept;
  std::error_code ignored;
  const auto status = std::filesystem::status(output, ignored);
  if (output.empty() || output == "-" || path.empty() ||
      (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))) {
    return;
  }
  for (const std::string beside : {"", ".lock", "-wal", "-shm", "-journal"}) {
    if (same_file(output, path + beside)) {
      throw UsageError{
          fmt::format("--output {} would replace {}, {}; write elsewhere", output, what, path)};
    }
  }
}

void check_inputs(const OutputRequest& output, const std::vector<InputFile>& inputs) {
  std::string from_stdin;
  std::error_code ignored;
  // Terminals and the like are read and written at once.
  const bool replaces = !output.path.empty() && output.path != "-" &&
                        std::filesystem::is_regular_file(output.path, ignored);
  for (const auto& [what, path] : inputs) {
    if (path == "-" && !from_stdin.empty()) {
      throw UsageError{fmt::format(
          "{} and {} cannot both come from standard input; name a file for one", from_stdin, what)};
    }
    from_stdin = path == "-" ? what : from_stdin;
    if (replaces && is_read_from(output.path, path)) {
      throw UsageError{
          fmt::format("--output {} is the same file as {}; write elsewhere", output.path, what)};
    }
  }
}

void require_file(const std::string& option, const std::string& path, const std::string& why) {
  if (path == "-") {
    throw UsageError{fmt::format("{} -: {}; name a file", option, why)};
  }
}

}  // namespace changeover::cli
