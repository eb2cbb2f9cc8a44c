// What a verb answers: a document, where it goes, and the exit code.
//
//     Answer run(const BoundsRequest& request) {
//       …
//       return text_answer(text, request.output);  // or one with a writer, for what is long
//     }
//
// A verb makes its answer and never writes it: deliver() does, for all of them. A file appears
// whole or not at all. If the answer is *precious* (a search made it) and its place cannot be
// written, then it goes to a new file in the current folder, or if that fails too, to standard
// output; one line on stderr says where it is, and the verb ends with exit code 4.
//
// Where no design is to be had, one rule holds for all verbs: the JSON document that --json asks
// for goes where the answer was to go, whatever it says; words go to standard output even where a
// FILE was named, for they never replace a file of designs (no_design()). The name of FILE alone,
// design.json, asks for a design and for no such document.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <string>

#include "changeover/io/output.hpp"
#include "cli/cli.hpp"
#include "request/output.hpp"

namespace changeover::cli {

struct Answer {
  int code = exit_code::done;
  OutputRequest output = {};
  /// Writes all of it and does not commit; it may be called again, for another file, and then
  /// starts from the beginning. If it is empty, another process of the team speaks.
  std::function<void(OutputFile&)> write = {};
  /// What was done for good before the answer is written: said if it cannot be written, in one line
  /// with why.
  std::string done_before = {};
  std::exception_ptr fault =
      {};  ///< said after the answer: it is complete, but something went wrong
  std::shared_ptr<void> held = {};  ///< what must live until it is delivered
};

[[nodiscard]] Answer text_answer(std::string text, const OutputRequest& output,
                                 int code = exit_code::done);

/// That there is no design, or none yet, by the rule above: `json` and `words` say the same,
/// without a last line feed.
[[nodiscard]] Answer no_design(const OutputRequest& output, int code, const std::string& words,
                               const std::string& json);
/// With a document that says found: false and the words as the explanation.
[[nodiscard]] Answer no_design(const OutputRequest& output, int code, const std::string& words);

/// Writes all of an answer and returns its exit code. @throws MissingResource if it is not where it
/// was asked for; the fault of the answer once it is there.
[[nodiscard]] int deliver(const Answer& answer);

/// A file that a verb writes besides its answer, whole or not at all. @throws MissingResource.
void write_file(const std::string& path, const std::function<void(OutputFile&)>& write);

}  // namespace changeover::cli
