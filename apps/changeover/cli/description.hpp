// What the verbs are, as data: help, completion, manual pages, tests and other programs are made of
// it.
//
//     for (const VerbDescription& verb : program.verbs()) {
//       verb.typed();                    // "catalog show"
//       verb.options.front().names;      // "-m", "--change"
//     }
#pragma once

#include <string>
#include <vector>

namespace changeover::cli {

/// An option or a positional argument of a verb.
struct OptionDescription {
  std::vector<std::string> names;  ///< "-m", "--change"; of a positional its name in the help
  bool positional = false;
  bool required = false;
  bool repeats = false;  ///< a positional that takes all words that are left
  std::string kind;      ///< number, text, words, flag, file, folder, duration, size, range
  std::vector<std::string> words;  ///< if kind is words
  std::string value;               ///< what the help calls the value of an option: "FILE", "N"
  std::string help;
};

struct ExitCodeDescription {
  int code = 0;
  std::string meaning;
};

struct VerbDescription {
  std::string name;  ///< "catalog-show"
  std::string summary;
  std::vector<OptionDescription> options = {};
  std::vector<std::string> rules = {};  ///< what options cannot mean together, a sentence each
  std::vector<std::string> examples =
      {};  ///< lines at the end of the help: commands, some with words after them

  std::vector<ExitCodeDescription> outcomes =
      {};  ///< the exit codes of its answers, smallest first

  [[nodiscard]] std::string typed() const;  ///< "catalog show"
  [[nodiscard]] std::string group() const;  ///< "catalog"; empty if it is of none
};

/// A group of verbs: "catalog", and what it is for.
struct GroupDescription {
  std::string name;
  std::string summary;
};

/// Every exit code of the program, smallest first.
[[nodiscard]] const std::vector<ExitCodeDescription>& exit_codes();

/// Those with which any verb may refuse: 2 to 5.
[[nodiscard]] std::vector<ExitCodeDescription> refusals();

}  // namespace changeover::cli
