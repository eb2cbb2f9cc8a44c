// In which form an answer is wanted, and where.
//
// The end of FILE's name says the format, in small letters or large, in every verb: design.json,
// sheet.xlsx, circle.tex. --format and --json come before it, but must not contradict it: a file
// never holds something else than its name says. .txt may hold every format that is text. An ending
// that says nothing (.dat) needs --format; a name without an ending, and standard output, have the
// verb's default.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/cli.hpp"

namespace changeover::cli {

/// [--format WORD] [--json] [-o FILE].
struct OutputRequest {
  std::string path;
  bool precious = false;  ///< long work makes it: it is not lost because FILE cannot be written

  /// Must live as long as the verb. The first word is the default. --json is for "json", or for
  /// "jsonl" if that is a word.
  void add_to(Verb& verb, const std::vector<std::string>& formats);

  /// [-o FILE] alone, for what has one format: a name that ends must end so.
  void add_file_to(Verb& verb, const std::vector<std::string>& endings);

  /// The format, as said above. A rule of the verb has asked for it before the verb runs.
  /// @throws UsageError for an ending that the verb cannot write, and for a format that contradicts
  /// the ending or --json.
  [[nodiscard]] std::string format() const;
  /// Whether FILE's name says nothing else than this format; standard output has no name.
  [[nodiscard]] bool name_allows(const std::string& word) const;
  /// By --format or --json, not by FILE's name or as the default.
  [[nodiscard]] bool is_asked_for() const { return json_ || !asked_.empty(); }
  [[nodiscard]] bool json() const { return format() == "json"; }

  /// @throws UsageError if the format is none of `formats`, in which alone `option` means
  /// something.
  void require(const std::string& option, const std::vector<std::string>& formats) const;
  /// What require() says, if it does.
  [[nodiscard]] std::optional<std::string> refusal(const std::string& option,
                                                   const std::vector<std::string>& formats) const;

  /// Tries whether FILE can be written, so that long work is not done in vain, and what cannot be
  /// undone not without an answer. @throws MissingResource.
  void check_writable() const;

 private:
  std::string asked_;  // --format
  bool json_ = false;
  std::vector<std::string> formats_;  // the default first
  std::string json_word_ = "json";
};

// The files that a verb reads: an answer never goes over what it was made from, and "-" is read
// once.
//
//     check_inputs(request.output, {{"the parts", request.parts}, {"--never", request.never}});

/// An input: what the user calls it, as in "--never", and its path; "" if it was not given, "-" for
/// standard input.
using InputFile = std::pair<std::string, std::string>;

/// @throws UsageError if the output is a regular file that is one of the inputs, by whatever path
/// or link, or if more than one of them is standard input.
void check_inputs(const OutputRequest& output, const std::vector<InputFile>& inputs);

/// @throws UsageError if the output is a file in which something is kept from one run to the next,
/// or one beside it that belongs to it: a lock, SQLite's journals.
void check_kept(const std::string& output, const InputFile& kept);

/// @throws UsageError if a file that is read and replaced is "-". `why` says what is done with it.
void require_file(const std::string& option, const std::string& path, const std::string& why);

}  // namespace changeover::cli
