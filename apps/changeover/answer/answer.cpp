#include "answer/answer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "changeover/core/error.hpp"
#include "cli/status_line.hpp"
#include "cli/terminal.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::cli {

Answer text_answer(std::string text, const OutputRequest& output, int code) {
  return {.code = code, .output = output, .write = [text = std::move(text)](OutputFile& out) {
            out.write(text);
          }};
}

Answer no_design(const OutputRequest& output, int code, const std::string& words,
                 const std::string& json) {
  const bool document = output.json() && output.is_asked_for();
  Answer answer = text_answer((document ? json : words) + "\n", output, code);
  if (!document) {
    answer.output.path.clear();
  }
  return answer;
}

Answer no_design(const OutputRequest& output, int code, const std::string& words) {
  JsonWriter json;
  json.begin_object().key("found").value(false).key("explanation").value(words).end_object();
  return no_design(output, code, words, json.take());
}

namespace {

using Write = std::function<void(OutputFile&)>;

// A name in the current folder that nothing has yet, like that of the target.
std::string free_name(const std::string& target) {
  std::string name = std::filesystem::path(target).filename().string();
  if (name.empty() || name == "-" || name == "." || name == "..") {
    name = "changeover-answer";
  }
  std::error_code ignored;
  std::string free = name;
  for (int i = 1; std::filesystem::exists(std::filesystem::symlink_status(free, ignored)); ++i) {
    free = fmt::format("{}.{}", name, i);
  }
  return free;
}

// To its place or elsewhere.
void deliver_precious(const std::string& path, const Write& write) {
  std::string fault;
  try {
    write_file(path, write);
    return;
  } catch (const ReaderGone& failure) {
    leave_with_the_reader();  // No reader is left, unless the parent said not to end for that.
    fault = failure.what();
  } catch (const MissingResource& failure) {
    fault = failure.what();
  }
  const std::string elsewhere = free_name(path);
  bool printed = false;
  try {
    write_file(elsewhere, write);
  } catch (const MissingResource&) {
    try {
      write_file("-", write);
      printed = true;
    } catch (const MissingResource& last) {
      throw MissingResource(fault +
                            "; nor can the current folder be written, nor standard output (" +
                            last.what() + "): the answer is lost");
    }
  }
  throw MissingResource(fault + (printed
                                     ? "; the answer was written to standard output instead"
                                     : "; the answer was written to ./" + elsewhere + " instead"));
}

}  // namespace

void write_file(const std::string& path, const Write& write) {
  OutputFile out(path);
  if (out.is_standard_output()) {
    status_line().end();
  }
  write(out);
  out.commit();
}

int deliver(const Answer& answer) {
  try {
    if (answer.write && answer.output.precious) {
      deliver_precious(answer.output.path, answer.write);
    } else if (answer.write) {
      write_file(answer.output.path, answer.write);
    }
  } catch (const ReaderGone&) {
    throw;
  } catch (const MissingResource& fault) {
    if (answer.done_before.empty()) {
      throw;
    }
    throw MissingResource(fmt::format("{}; {}", fault.what(), answer.done_before));
  }
  if (answer.fault) {
    std::rethrow_exception(answer.fault);
  }
  return answer.code;
}

}  // namespace changeover::cli
