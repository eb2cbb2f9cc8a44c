// In which form an answer is wanted, and where.
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

  /// Must live as long as the verb. The first word is the default. --json is for "json", or for "jsonl" if that is a word.
  void add_to(Verb& verb, const std::vector<std::string>& formats);

  /// If no format is chosen, the end of FILE's name says it, in small letters or large: ".tex" means "tikz", for instance. A
  /// rule of the verb refuses an ending that is none of these; a name without one says nothing. ".xlsx" means "xlsx" by itself.
  void guess_by_name(std::vector<std::pair<std::string, std::string>> endings);

  /// These words are no text for a terminal: they are refused there.
  void set_binary(std::vector<std::string> words) { binary_ = std::move(words); }

  /// The chosen format, or what FILE's name says, or the default. A rule of the verb refuses --json and --format that contradict each other.
  [[nodiscard]] const std::string& format() const;
  [[nodiscard]] bool json() const { return format() == "json"; }

  /// @throws UsageError if the format is none of `formats`, in which alone `option` means something.
  void require(const std::string& option, const std::vector<std::string>& formats) const;

  /// Tries whether FILE can be written, so that long work is not done in vain, and what cannot be
  /// undone not without an answer. @throws MissingResource.
  void check_writable() const;

 private:
  std::string asked_;  // --format
  bool json_ = false;
  std::vector<std::pair<std::string, std::string>> endings_;
  bool knows_all_endings_ = false;
  std::vector<std::string> binary_;
  std::string usual_;
  std::string json_word_ = "json";
};

}  // namespace changeover::cli
