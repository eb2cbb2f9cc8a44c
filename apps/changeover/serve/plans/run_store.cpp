#include "serve/plans/run_store.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "io/file/file_lock.hpp"
#include "io/write/json_writer.hpp"
#include "serve/http/guard.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view run_format = "changeover-run/1";
constexpr std::size_t most_runs = 200;
constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 20;
constexpr std::size_t id_letters = 24;

std::string now() {
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

// Names of files, and of nothing else.
bool is_id(const std::string& id) {
  return id.size() == id_letters && std::ranges::all_of(id, [](char letter) {
           return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
         });
}

Refusal no_run() { return {404, "this run is not kept here any more"}; }

void write_head(JsonWriter& json, const KeptRun& run) {
  json.key("id").value(run.id).key("title").value(run.title);
  json.key("revision").value(run.revision).key("sheet_revision").value(run.sheet_revision);
  json.key("changed").value(run.changed).key("tests").value(run.tests);
}

std::string json_of(const KeptRun& run) {
  JsonWriter json;
  json.begin_object().key("format").value(run_format);
  write_head(json, run);
  json.key("sheet").raw(run.sheet).key("results").begin_array();
  for (const RunResult& each : run.results) {
    json.begin_object().key("test").value(each.test).key("result").value(each.result);
    json.key("notes").value(each.notes).key("by").value(each.by).key("at").value(each.at);
    json.end_object();
  }
  return json.end_array().end_object().take() + "\n";
}

KeptRun run_in(const std::string& text) {
  const nlohmann::json object = nlohmann::json::parse(text);
  if (object.at("format") != run_format) {
    throw BadInput("another format");
  }
  KeptRun run{.id = object.at("id"),
              .title = object.at("title"),
              .revision = object.at("revision"),
              .sheet_revision = object.at("sheet_revision"),
              .changed = object.at("changed"),
              .tests = object.at("tests"),
              .sheet = object.at("sheet").dump()};
  for (const nlohmann::json& each : object.at("results")) {
    run.results.push_back({.test = each.at("test"),
                           .result = each.at("result"),
                           .notes = each.at("notes"),
                           .by = each.at("by"),
                           .at = each.at("at")});
  }
  return run;
}

void require_sheet(const KeptRun& run, std::uint64_t sheet_revision) {
  if (run.sheet_revision != sheet_revision) {
    throw Refusal{409, "this run was planned anew meanwhile; what is shown now is the new sheet"};
  }
}

}  // namespace

RunStore::RunStore(std::string folder, EventHub& events)
    : folder_(std::move(folder)), events_(events) {}

std::string RunStore::path_of(const std::string& id) const {
  if (!is_id(id) || folder_.empty()) {
    throw no_run();
  }
  return folder_ + "/" + id + ".json";
}

KeptRun RunStore::read(const std::string& id) const {
  const std::string path = path_of(id);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) {
    throw no_run();
  }
  if (size > most_bytes) {
    throw MissingResource(path + ": it is too large for a run; move it away");
  }
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  try {
    return run_in(text);
  } catch (const std::exception&) {
    throw MissingResource(path + ": it is damaged, or no run; move it away");
  }
}

void RunStore::write(const KeptRun& run) const {
  OutputFile file(path_of(run.id));
  file.write(json_of(run));
  file.commit();
}

KeptRun RunStore::keep(KeptRun run) {
  const std::scoped_lock lock(mutex_);
  if (folder_.empty()) {
    throw MissingResource("there is no folder for runs; give --catalog FILE");
  }
  fs::create_directories(folder_);
  const bool is_new = run.id.empty();
  if (is_new) {
    const auto runs = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    if (runs >= static_cast<std::ptrdiff_t>(most_runs)) {
      throw Refusal{422, fmt::format("{} runs are kept, as many as may be; remove one", runs)};
    }
    run.id = make_token().substr(0, id_letters);
  }
  const FileLock file_lock(path_of(run.id));
  run.revision = 1;
  if (!is_new) {
    const KeptRun before = read(run.id);
    require_sheet(before, run.sheet_revision);
    run.revision = before.revision + 1;
  }
  run.sheet_revision = run.revision;
  run.changed = now();
  write(run);
  publish(run, false);
  return run;
}

KeptRun RunStore::add_result(const std::string& id, RunResult result,
                             std::uint64_t sheet_revision) {
  const std::scoped_lock lock(mutex_);
  const std::string path = path_of(id);
  if (!fs::exists(path)) {
    throw no_run();
  }
  const FileLock file_lock(path);
  KeptRun run = read(id);
  require_sheet(run, sheet_revision);
  std::erase_if(run.results, [&](const RunResult& each) { return each.test == result.test; });
  run.changed = now();
  ++run.revision;
  if (!result.result.empty() || !result.notes.empty()) {
    if (run.results.size() >= run.tests) {
      throw Refusal{422, fmt::format("the sheet has {} tests, and each has a result", run.tests)};
    }
    result.at = run.changed;
    run.results.push_back(std::move(result));
  }
  write(run);
  publish(run, false);
  return run;
}

void RunStore::remove(const std::string& id) {
  const std::scoped_lock lock(mutex_);
  const std::string path = path_of(id);
  if (!fs::exists(path)) {
    throw no_run();
  }
  const FileLock file_lock(path);
  fs::remove(path);
  publish({.id = id}, true);
}

std::string RunStore::json(const std::string& id) const {
  const std::scoped_lock lock(mutex_);
  return json_of(read(id));
}

std::string RunStore::list_json() const {
  const std::scoped_lock lock(mutex_);
  std::vector<KeptRun> runs;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    const std::string id = entry.path().stem().string();
    if (entry.path().extension() != ".json" || !is_id(id)) {
      continue;
    }
    try {
      runs.push_back(read(id));
    } catch (const Refusal&) {  // It has just been removed.
    } catch (const MissingResource&) {
      // A question for it says what is wrong.
    }
  }
  std::ranges::sort(runs, std::ranges::greater(), &KeptRun::changed);
  JsonWriter json;
  json.begin_array();
  for (const KeptRun& run : runs) {
    json.begin_object();
    write_head(json, run);
    json.key("done").value(std::ranges::count_if(
        run.results, [](const RunResult& each) { return !each.result.empty(); }));
    json.end_object();
  }
  return json.end_array().take() + "\n";
}

void RunStore::publish(const KeptRun& run, bool removed) {
  JsonWriter json;
  json.begin_object().key("id").value(run.id).key("revision").value(run.revision);
  json.key("sheet_revision").value(run.sheet_revision).key("removed").value(removed);
  events_.publish("run", run.id, json.end_object().take());
}

}  // namespace changeover::serve
