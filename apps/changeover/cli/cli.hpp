// The command line: what a verb may ask for, without the parser's header, which takes seconds a file.
//
//     void add_bounds(Program& program) {
//       auto& verb = program.add("bounds", "lower bounds, each with its reason");
//       auto v = std::make_shared<std::uint64_t>();
//       verb.positional("V", *v, "number of elements");
//       verb.run([=] { … return exit_code::done; });
//     }
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace changeover::cli {

/// What the program's exit status means.
namespace exit_code {
inline constexpr int done = 0;       ///< done, or the design is valid
inline constexpr int refuted = 1;    ///< the claim was refuted
inline constexpr int usage = 2;      ///< wrong options or arguments
inline constexpr int bad_input = 3;  ///< a file is malformed
inline constexpr int missing_resource =
    4;                                    ///< no construction, no file, no memory, no room on disk
inline constexpr int bug = 5;             ///< a result failed its own verification
inline constexpr int found = 10;          ///< a search found what it was asked for
inline constexpr int proved_none = 20;    ///< it proved that there is none
inline constexpr int limit_reached = 30;  ///< it stopped before it knew
}  // namespace exit_code

/// Thrown by a verb for what the parser cannot see: options that contradict each other, say.
struct UsageError {
  std::string message;
};

/// One verb. References given to it must live until Program::run() returns.
class Verb {
 public:
  ~Verb();
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;

  void positional(const std::string& name, std::uint64_t& value, const std::string& help);
  void positional(const std::string& name, std::string& value, const std::string& help,
                  bool required = true);
  /// One that may be left out.
  void positional(const std::string& name, std::optional<std::uint64_t>& value,
                  const std::string& help);
  /// `flags` as in "-o,--output"; `what` names the value in the help.
  void option(const std::string& flags, std::optional<std::uint64_t>& value,
              const std::string& what, const std::string& help);
  void option(const std::string& flags, std::string& value, const std::string& what,
              const std::string& help);
  /// One of some words.
  void choice(const std::string& flags, std::string& value, const std::vector<std::string>& words,
              const std::string& help);
  void flag(const std::string& flags, bool& value, const std::string& help);
  /// Command lines shown at the end of --help.
  void examples(const std::vector<std::string>& lines);
  void run(std::function<int()> action);

 private:
  friend class Program;
  struct State;
  explicit Verb(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// An option or a positional argument of a verb, as completion, tests and other programs want to know it.
struct OptionDescription {
  std::string verb;
  std::vector<std::string> names;  ///< "-m", "--change"; of a positional its name in the help
  bool positional = false;
  bool required = false;
  std::string kind;  ///< number, text, words, flag, file, folder, duration, size, range
  std::vector<std::string> words;  ///< if kind is words
  std::string help;
};

/// All verbs and the parser.
class Program {
 public:
  Program();
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Verb& add(const std::string& name, const std::string& summary);

  /// Parses, runs the verb and maps faults to exit codes, one line on stderr each.
  int run(int argc, char** argv);

  /// Every option of every verb, in the order of the help.
  [[nodiscard]] std::vector<OptionDescription> describe() const;

  /// The name and the summary of every verb.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> verbs() const;

  /// A script that completes verbs, options and their words in bash.
  [[nodiscard]] std::string bash_completion() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::cli
