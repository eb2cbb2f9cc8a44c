// The command line: what a verb may ask for, without the parser's header, which takes seconds a
// file.
//
//     Answer run(const BoundsRequest& request) { … }
//
//     void add_bounds(Program& program) {
//       auto [verb, request] = program.add("bounds", "lower bounds, each with its reason", run);
//       verb.positional("V", request.v, "number of elements");
//       verb.flag("--first", request.first, "the largest only");
//       verb.exclude({"--first", "--json"});
//     }
//
// What is parsed is a request; what it cannot mean is refused before the verb sees it, in one line
// and with exit code 2. The verb makes an answer, and Program::run() delivers it
// (answer/answer.hpp).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/description.hpp"

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

struct Answer;

/// Thrown by a verb for what the parser cannot see: files that contradict each other, say.
struct UsageError {
  std::string message;
};

/// One verb. References given to it must live until Program::run() returns.
class Verb {
 public:
  ~Verb();
  Verb(const Verb&) = delete;
  Verb& operator=(const Verb&) = delete;

  void positional(const std::string& name, std::optional<std::uint64_t>& value,
                  const std::string& help, bool required = true);
  void positional(const std::string& name, std::string& value, const std::string& help,
                  bool required = true);
  /// One or more.
  void positional(const std::string& name, std::vector<std::string>& values,
                  const std::string& help, bool required = true);
  /// `flags` as in "-o,--output"; `what` names the value in the help.
  void option(const std::string& flags, std::optional<std::uint64_t>& value,
              const std::string& what, const std::string& help);
  void option(const std::string& flags, std::string& value, const std::string& what,
              const std::string& help);
  /// A text that `take` keeps; it throws nothing.
  void option(const std::string& flags, const std::function<void(const std::string&)>& take,
              const std::string& what, const std::string& help);
  /// One of some words.
  void choice(const std::string& flags, std::string& value, const std::vector<std::string>& words,
              const std::string& help);
  void flag(const std::string& flags, bool& value, const std::string& help);
  void flag(const std::string& flags, std::function<void()> set, const std::string& help);

  /// At most one of these is given.
  void exclude(const std::vector<std::string>& names);
  /// Each of `names` means something only with one of `others`.
  void only_with(const std::vector<std::string>& names, const std::vector<std::string>& others);
  /// None of `names` means anything with one of `others`.
  void never_with(const std::vector<std::string>& names, const std::vector<std::string>& others,
                  const std::string& why = {});
  /// None of `names` can be used with one of `others`; `why` goes on after them: "which makes …".
  void not_served_with(const std::vector<std::string>& names,
                       const std::vector<std::string>& others, const std::string& why);

  /// What a rule says that the verb itself holds its request to.
  void rule(const std::string& sentence);

  /// Another rule, which throws UsageError.
  void require(std::function<void()> rule);

  /// Command lines shown at the end of --help.
  void examples(const std::vector<std::string>& lines);

  /// The exit codes of its answers, smallest first, and what each means here; without this, 0 is
  /// the only one.
  void outcomes(const std::vector<ExitCodeDescription>& codes);

 private:
  friend class Program;
  struct State;
  explicit Verb(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All verbs and the parser.
class Program {
 public:
  Program();
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// A verb that answers requests of its own kind; the request lives as long as the program. A name
  /// with a hyphen is typed as two words: "catalog-show" is `changeover catalog show`, one verb of
  /// the group catalog.
  template <typename Request>
  std::pair<Verb&, Request&> add(const std::string& name, const std::string& summary,
                                 Answer (*act)(const Request&)) {
    const auto request = std::make_shared<Request>();
    return {add_verb(name, summary, [request, act] { return act(*request); }), *request};
  }

  /// What a group of verbs is for: `--help` lists the group, not its verbs. Before its first verb
  /// is added.
  void add_group(const std::string& name, const std::string& summary);

  /// Parses, runs the verb, delivers its answer and maps faults to exit codes, one line on stderr
  /// each.
  int run(int argc, char** argv);

  /// In the order of the help.
  [[nodiscard]] std::vector<VerbDescription> verbs() const;
  [[nodiscard]] std::vector<GroupDescription> groups() const;

  /// What the program does, in a sentence.
  [[nodiscard]] std::string purpose() const;

 private:
  Verb& add_verb(const std::string& name, const std::string& summary,
                 std::function<Answer()> action);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace changeover::cli
