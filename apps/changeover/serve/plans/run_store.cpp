#include "serve/plans/run_store.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/run/control.hpp"
#include "core/words.hpp"
#include "io/file/file_lock.hpp"
#include "io/write/json_writer.hpp"
#include "serve/http/guard.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_runs = 200;
constexpr std::size_t most_run_bytes = std::size_t{4} << 20;
constexpr std::size_t id_letters = 24;

std::string now() {
  const auto time = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  const auto midnight = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day day{midnight};
  const std::chrono::hh_mm_ss clock{time - midnight};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", int{day.year()}, unsigned{day.month()},
                     unsigned{day.day()}, clock.hours().count(), clock.minutes().count(),
                     clock.seconds().count());
}

// Names of files, and of nothing else.
bool is_id(const std::string& id) {
  return id.size() == id_letters && std::ranges::all_of(id, [](char letter) {
           return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
         });
}

Refusal no_run() { return {404, "this run is no longer stored here; plan again"}; }

[[noreturn]] void fail_to_read(const std::string& path, const std::string& why) {
  throw MissingResource(fmt::format("{}: cannot be read as a run: {}; move it away", path, why));
}

// @throws Refusal 404 if there is none.
struct stat status_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno == ENOENT) {
      throw no_run();
    }
    throw MissingResource(fmt::format("{}: cannot be read: {}; allow reading it, or move it away",
                                      path, std::strerror(errno)));
  }
  return status;
}

// The same of what may be a run. @throws MissingResource if it is none by its kind or size.
struct stat status_of_run(const std::string& path) {
  const struct stat status = status_of(path);
  if (!S_ISREG(status.st_mode)) {
    fail_to_read(path, "it is not a file");
  }
  if (static_cast<std::uintmax_t>(status.st_size) > most_run_bytes) {
    fail_to_read(path,
                 fmt::format("it has more than the {} bytes that a run may have", most_run_bytes));
  }
  return status;
}

// The lock of a run that there is.
FileLock lock_of(const std::string& path) {
  try {
    return FileLock(path);
  } catch (const BadInput&) {
    throw MissingResource(
        fmt::format("{}.lock is not a lock of changeover, but has its name; move it away", path));
  }
}

void require_sheet(const KeptRun& run, std::uint64_t sheet_revision) {
  if (run.sheet_revision != sheet_revision) {
    throw Refusal{409, "this run was replanned meanwhile; use the new sheet, which is shown now"};
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

std::vector<std::string> RunStore::ids() const {
  std::vector<std::string> found;
  std::error_code error;
  fs::directory_iterator at(folder_, error);
  while (!error && at != fs::directory_iterator()) {
    const std::string id = at->path().stem().string();
    std::error_code unknown;
    if (at->path().extension() == ".json" && is_id(id) && at->is_regular_file(unknown)) {
      found.push_back(id);
    }
    at.increment(error);
  }
  if (error && error != std::errc::no_such_file_or_directory) {
    throw MissingResource(
        fmt::format("{}: cannot read this folder: {}; allow reading it, or move it away", folder_,
                    error.message()));
  }
  return found;
}

KeptRun RunStore::read(const std::string& id) const {
  const std::string path = path_of(id);
  static_cast<void>(status_of_run(path));
  const auto input = open_input(path);
  const std::string text = read_to_end(*input, most_run_bytes, "move it away");
  try {
    return run_in(text, id);
  } catch (const BadInput& fault) {
    fail_to_read(path, fault.what());
  }
}

void RunStore::write(const KeptRun& run) const {
  const std::string text = run_json(run);
  if (text.size() > most_run_bytes) {
    throw Refusal{413, fmt::format("the run would have {} bytes, more than the {} that a run may "
                                   "have; write shorter notes",
                                   text.size(), most_run_bytes)};
  }
  if (run.revision > most_revisions) {
    throw Refusal{422, "the run was changed as often as may be; keep it as a new one"};
  }
  OutputFile file(path_of(run.id));
  file.write(text);
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
    const std::size_t runs = ids().size();
    if (runs >= most_runs) {
      throw Refusal{422, fmt::format("{} runs are kept, as many as may be; remove one", runs)};
    }
    run.id = make_token().substr(0, id_letters);
  }
  const FileLock file_lock = lock_of(path_of(run.id));
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
  static_cast<void>(status_of(path));
  const FileLock file_lock = lock_of(path);
  KeptRun run = read(id);
  require_sheet(run, sheet_revision);
  require_test(result.test, run.tests);
  std::erase_if(run.results, [&](const RunResult& each) { return each.test == result.test; });
  run.changed = now();
  ++run.revision;
  if (!result.result.empty() || !result.notes.empty()) {
    if (run.results.size() >= run.tests) {
      throw Refusal{422, fmt::format("the sheet has {}, and each has a result; nothing is left to "
                                     "plan",
                                     count_of(run.tests, "test"))};
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
  static_cast<void>(status_of(path));
  const FileLock file_lock = lock_of(path);
  fs::remove(path);
  publish({.id = id}, true);
}

// Files appear whole, so nothing that reads them waits.
std::string RunStore::json(const std::string& id) const { return run_json(read(id)); }

std::optional<RunStore::Listed> RunStore::listed(const std::string& id) const {
  struct stat status {};
  try {
    status = status_of_run(path_of(id));
  } catch (const Refusal&) {  // It has just been removed.
    return std::nullopt;
  } catch (const MissingResource&) {  // A question for it says what is wrong.
    return std::nullopt;
  }
  Listed found{.stamp = {status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size,
                         static_cast<std::int64_t>(status.st_ino)}};
  {
    const std::scoped_lock lock(listed_mutex_);
    const auto before = listed_.find(id);
    if (before != listed_.end() && before->second.stamp == found.stamp) {
      return before->second;
    }
  }
  stop_if_asked();
  try {
    KeptRun run = read(id);
    found.done = run.done();
    run.sheet.clear();
    run.results.clear();
    found.run = std::move(run);
  } catch (const Refusal&) {
    return std::nullopt;
  } catch (const MissingResource&) {
    // So it is until the file changes.
  }
  const std::scoped_lock lock(listed_mutex_);
  listed_[id] = found;
  return found;
}

std::string RunStore::list_json() const {
  const std::vector<std::string> there = ids();
  std::map<std::string, Listed> runs;
  for (const std::string& id : there) {
    if (auto found = listed(id)) {
      runs[id] = *std::move(found);
    }
  }
  {
    const std::scoped_lock lock(listed_mutex_);
    std::erase_if(listed_, [&](const auto& each) { return !runs.contains(each.first); });
  }
  std::vector<const Listed*> sorted;
  for (const auto& [id, each] : runs) {
    if (each.run) {
      sorted.push_back(&each);
    }
  }
  std::ranges::stable_sort(sorted, std::ranges::greater(),
                           [](const Listed* each) { return each->run->changed; });
  JsonWriter json;
  json.objects(sorted, [&](const Listed* each) {
    write_head(json, *each->run);
    json.key("done").value(each->done);
  });
  return json.take() + "\n";
}

void RunStore::publish(const KeptRun& run, bool removed) {
  JsonWriter json;
  json.begin_object().key("id").value(run.id).key("revision").value(run.revision);
  json.key("sheet_revision").value(run.sheet_revision).key("removed").value(removed);
  events_.publish("run", run.id, json.end_object().take());
}

}  // namespace changeover::serve
