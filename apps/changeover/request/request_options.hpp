// The options of a verb, made of the records of its request (changeover/io/request.hpp), and
// requests from files.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "changeover/io/input.hpp"
#include "changeover/io/request.hpp"
#include "changeover/plan/benches.hpp"
#include "cli/cli.hpp"
#include "core/parsed.hpp"
#include "io/request/request_document.hpp"
#include "io/request/request_words.hpp"
#include "request/output.hpp"
#include "request/run_request.hpp"

namespace changeover::cli {

/// What every verb with a request document has besides: [--request FILE] [--show-request].
struct RequestFileRequest {
  std::string path;
  bool show = false;

  void add_to(Verb& verb, std::string_view format) {
    verb.option(
        "--request", path, "FILE",
        "read the request from FILE, as JSON (" + std::string(format) + "); options override it");
    verb.flag("--show-request", show, "print the request as JSON and stop");
  }
};

/// The longest request document that is read from a file.
inline constexpr std::size_t most_request_bytes = std::size_t{1} << 28;

/// As RunRequest::add_to() takes it: "60s".
[[nodiscard]] inline std::string seconds_text(double seconds) {
  return fmt::format("{}s", seconds);
}

/// "3" is a number, "benches.csv" a file, as "./3" is.
[[nodiscard]] inline RequestList number_or_file(const std::string& text) {
  const auto number = parsed<std::uint64_t>(text);
  return number ? RequestList{.number = number} : RequestList{.file = text};
}

/// @throws UsageError for what is meant as a number and cannot be one, as "-1" and "1.5"
inline void check_number_or_file(const std::string& flags, const RequestList& list) {
  if (const auto number = parsed<double>(list.file); number && std::isfinite(*number)) {
    throw UsageError{fmt::format("{} {}: give a whole number from 1 to {}, or a file", flags,
                                 list.file, max_benches)};
  }
}

/// Adds an option for each record but those that `others` has already, and the rules. What
/// `request` points to must live as long as the program.
template <typename Request>
void add_request_options(Verb& verb, Request& request, const RequestTable<Request>& table) {
  for (const auto& option : table.options) {
    const OptionRecord& record = option.record;
    if (record.of_every_search || record.flags.empty()) {
      continue;
    }
    const std::string flags(record.flags);
    const std::string help = help_of(record);
    const std::string value(record.value);
    std::visit(
        [&](auto field) {
          auto& kept = request.*field;
          using Value = std::remove_cvref_t<decltype(kept)>;
          if constexpr (std::is_same_v<Value, bool>) {
            verb.flag(flags, kept, help);
          } else if constexpr (std::is_same_v<Value, std::optional<std::uint64_t>>) {
            if (record.value == "SIZE") {
              const auto text = std::make_shared<std::string>();
              verb.option(flags, *text, value, help);
              verb.require([&kept, text, flags] {
                if (!text->empty()) {
                  kept = parse_size(*text, flags);
                }
              });
              return;
            }
            verb.option(flags, kept, value, help);
          } else if constexpr (std::is_same_v<Value, RequestList>) {
            if (record.shape == RowShape::benches) {
              verb.option(
                  flags, [&kept](const std::string& text) { kept = number_or_file(text); }, value,
                  help);
              verb.require([&kept, flags] { check_number_or_file(flags, kept); });
              return;
            }
            flags.starts_with('-') ? verb.option(flags, kept.file, value, help)
                                   : verb.positional(flags, kept.file, help, false);
          } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            verb.option(
                flags, [&kept](const std::string& text) { kept = {text}; }, value, help);
          } else if constexpr (std::is_same_v<Value, std::string>) {
            record.words.empty()
                ? verb.option(flags, kept, value, help)
                : verb.choice(flags, kept, {record.words.begin(), record.words.end()}, help);
          }
        },
        option.field);
  }
  const auto spelled_all = [&](const std::vector<std::string_view>& keys) {
    std::vector<std::string> all;
    all.reserve(keys.size());
    for (const std::string_view key : keys) {
      all.push_back(spelled(option_of(table, key).record, Door::command_line));
      if (const std::string value(value_in(key)); !value.empty()) {
        all.back() += " " + value;
      }
    }
    return all;
  };
  for (const OptionRule& rule : table.rules) {
    verb.rule(sentence_of(rule.says, spelled_all(rule.keys), spelled_all(rule.others),
                          spelled_all(rule.where)));
  }
}

/// The files of a request, as check_inputs() wants them.
template <typename Request>
std::vector<InputFile> files_of(const Request& request, const RequestTable<Request>& table) {
  std::vector<InputFile> files;
  for (const auto& option : table.options) {
    if (auto* const field = std::get_if<RequestList Request::*>(&option.field)) {
      const bool is_argument = !option.record.flags.starts_with('-');
      files.emplace_back(
          is_argument ? "the parts list" : spelled(option.record, Door::command_line),
          list_file((request.**field).file));
    }
  }
  return files;
}

/// What the command line says, with the names that it gives in one text told apart, on top of what
/// the file says; limits of the search stand in both. No file that is read is the output.
/// @throws UsageError, BadInput, MissingResource
template <typename Request, typename Read>
Request whole_request(Request request, RunRequest& run, const RequestTable<Request>& table,
                      const RequestFileRequest& file, const OutputRequest& output, Read&& read) {
  request.threads = run.threads;
  request.seed = run.seed;
  if (!run.time.empty()) {
    request.seconds = parse_duration(run.time, "--time").count();
  }
  for (const auto& option : table.options) {
    if (auto* const field = std::get_if<std::vector<std::string> Request::*>(&option.field)) {
      auto& names = request.**field;
      try {
        names = names.empty() ? names : names_in(names.front());
      } catch (const BadInput& fault) {
        throw UsageError{spelled(option.record, Door::command_line) + ": " + fault.what()};
      }
    }
  }
  std::vector<InputFile> files{{"--request", file.path}};
  if (!file.path.empty()) {
    check_inputs(output, files);
    const auto input = open_input(file.path);
    complete(table, request,
             read(read_to_end(*input, most_request_bytes, "name its lists by files"), input->name(),
                  Door::document));
  }
  std::ranges::move(files_of(request, table), std::back_inserter(files));
  check_inputs(output, files);
  run.threads = request.threads;
  run.seed = request.seed;
  if (run.time.empty() && request.seconds) {
    run.time = fmt::format("{:f}s", *request.seconds);
  }
  return request;
}

}  // namespace changeover::cli
