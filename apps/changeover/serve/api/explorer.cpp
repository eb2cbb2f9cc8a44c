#include "serve/api/explorer.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "answer/known/known_table.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/input.hpp"
#include "changeover/run/control.hpp"
#include "cli/cli.hpp"
#include "serve/jobs/search_jobs.hpp"
#include "serve/plans/plan_jobs.hpp"
#include "serve/plans/run_store.hpp"

namespace changeover::serve {
namespace {

std::string without_dashes(const std::string& message) {
  return message.starts_with("--") ? message.substr(2) : message;
}

Refusal of_stop(const Explorer& explorer, WhyStopped why) {
  return {
      503,
      why == WhyStopped::time_limit
          ? fmt::format("this takes more than {:.0f} s; ask for less, or ask changeover on "
                        "the command line",
                        explorer.limits.seconds.count())
          : std::string("this was given up before it was done; ask again, or for less at once")};
}

}  // namespace

std::optional<Response> AnswerCache::find(const std::string& key) {
  const std::scoped_lock lock(mutex_);
  const auto found = by_key_.find(key);
  if (found == by_key_.end()) {
    return std::nullopt;
  }
  kept_.splice(kept_.begin(), kept_, found->second);
  return found->second->response;
}

void AnswerCache::keep(const std::string& key, const Response& response) {
  const std::size_t bytes =
      response.body->size() + (response.gzipped ? response.gzipped->size() : 0) + 2 * key.size();
  const std::scoped_lock lock(mutex_);
  if (bytes > most_bytes_ / 4 || by_key_.contains(key)) {
    return;
  }
  kept_.push_front({key, response, bytes});
  by_key_[key] = kept_.begin();
  bytes_ += bytes;
  while (bytes_ > most_bytes_) {
    bytes_ -= kept_.back().bytes;
    by_key_.erase(kept_.back().key);
    kept_.pop_back();
  }
}

Explorer::Explorer(Catalog& known) : catalog(known) {}

Explorer::~Explorer() = default;

std::string Explorer::generation() const {
  std::string text;
  for (const char* const suffix : {"", "-wal"}) {
    struct stat status {};
    if (::stat((catalog.user_path() + suffix).c_str(), &status) == 0) {
      text +=
          fmt::format("{}.{}.{};", status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size);
    }
  }
  return text;
}

Response answered(Explorer& explorer, const Request& request, Again again,
                  const std::function<Response()>& make) {
  std::string key;
  if (again == Again::while_unchanged) {
    auto parameters = request.parameters;
    std::ranges::sort(parameters);
    key = request.path;
    for (const auto& [name, value] : parameters) {
      key += fmt::format("\n{}={}", name, value);
    }
    key += "\n" + explorer.generation();
    if (auto found = explorer.cache.find(key)) {
      return *std::move(found);
    }
  }
  RunControl::Settings settings;
  settings.time = explorer.limits.seconds;
  settings.memory_bytes = explorer.limits.memory_bytes;
  settings.interrupted = &explorer.stopping;
  settings.found_elsewhere = request.left;
  RunControl control(std::move(settings));
  const RunScope scope(control);
  try {
    Response response = make();
    if (again == Again::while_unchanged && response.status == 200) {
      explorer.cache.keep(key, response);
    } else if (again == Again::made_anew) {
      response.etag.clear();
    }
    return response;
  } catch (const cli::UsageError& fault) {
    throw Refusal{400, without_dashes(fault.message)};
  } catch (const ImpossibleParameters& fault) {
    throw Refusal{400, fault.what()};
  } catch (const BadOption& fault) {
    throw Refusal{400, fault.what()};
  } catch (const BadInput& fault) {
    throw request.method == "POST" ? malformed(fault.what()) : Refusal{400, fault.what()};
  } catch (const MissingResource& fault) {
    throw Refusal{503, fault.what()};
  } catch (const std::filesystem::filesystem_error& fault) {
    throw Refusal{503, fmt::format("{}: {}; correct that on the server", fault.path1().string(),
                                   fault.code().message())};
  } catch (const Stopped& stopped) {
    throw of_stop(explorer, stopped.why());
  }
}

KnownTables::Place KnownTables::find(const std::string& key) {
  return std::ranges::find(entries_, key, &Entry::key);
}

std::shared_ptr<const cli::KnownTable> KnownTables::of(const cli::TableRange& range,
                                                       const std::string& generation, Haste haste) {
  constexpr std::size_t most_tables = 12;
  constexpr auto between_looks = std::chrono::milliseconds(50);
  const std::string key = fmt::format(
      "{} {} {} {} {} {} {}", range.k.from, range.k.to, range.v.from, range.v.to, range.change,
      range.kind ? to_string(*range.kind) : std::string_view(), generation);
  {
    std::unique_lock lock(mutex_);
    for (;;) {
      const Place place = find(key);
      if (place == entries_.end()) {
        entries_.push_front({key, nullptr, haste});
        break;
      }
      if (place->table) {
        entries_.splice(entries_.begin(), entries_, place);
        return entries_.front().table;
      }
      if (haste == Haste::wanted && place->haste == Haste::sometime) {
        place->haste = haste;  // It is mine now.
        break;
      }
      changed_.wait_for(lock, between_looks);
      stop_if_asked();
    }
  }
  std::shared_ptr<const cli::KnownTable> table;
  try {
    table = std::make_shared<const cli::KnownTable>(cli::known_table(range));
  } catch (...) {
    // A request that waits makes it again: the limits were those of this request.
    const std::lock_guard lock(mutex_);
    const Place place = find(key);
    if (place != entries_.end() && !place->table && place->haste == haste) {
      entries_.erase(place);
    }
    changed_.notify_all();
    throw;
  }
  const std::lock_guard lock(mutex_);
  const Place place = find(key);
  if (place == entries_.end()) {
    return table;  // Another made it, and it has gone since.
  }
  if (place->table) {
    return place->table;
  }
  place->table = table;
  auto last = entries_.end();
  while (entries_.size() > most_tables && last != entries_.begin()) {
    --last;
    if (last->table && last->table != table) {
      last = entries_.erase(last);
    }
  }
  changed_.notify_all();
  return table;
}

}  // namespace changeover::serve
