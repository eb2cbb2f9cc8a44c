// The options of every request that starts a search.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "changeover/run/control.hpp"
#include "io/request/option.hpp"

namespace changeover {

/// "command line: 60; server: 10, at most 60 (followed: 60, at most 3600); Python: until it ends".
[[nodiscard]] inline std::string words_of(const SearchTimes& times) {
  const auto one = [](double seconds) {
    return seconds > 0 ? fmt::format("{}", seconds) : std::string("no search");
  };
  return fmt::format("command line: {}; server: {}, at most {}{}; Python: {}",
                     one(times.command_line), one(times.server), times.most_of_server,
                     times.followed > 0 ? fmt::format(" (followed: {}, at most {})", times.followed,
                                                      times.most_followed)
                                        : "",
                     times.command_line > 0 ? "until it ends" : "no search");
}

/// Adds them. @param how_long  help of the time
template <typename Request>
[[nodiscard]] std::vector<RequestOption<Request>> with_search_options(
    std::vector<RequestOption<Request>> options, std::string_view how_long,
    const SearchTimes& times) {
  options.push_back(option("seconds", "DURATION", how_long, &Request::seconds,
                           {.flags = "--time",
                            .unit = "seconds",
                            .by_default = words_of(times),
                            .python = "time",
                            .of_every_search = true}));
  options.push_back(option("threads", "N", "threads to use", &Request::threads,
                           {.by_default = "command line: all cores; Python: 1",
                            .not_in_server = "the server gives each request its share",
                            .of_every_search = true}));
  options.push_back(option("seed", "N", "seed of the random numbers", &Request::seed,
                           {.by_default = "1", .of_every_search = true}));
  return options;
}

/// @throws BadInput, BadOption for more threads than any search takes, or none.
template <typename Request, typename Words>
void check_threads(const Request& request, const Words& words) {
  if (request.threads && (*request.threads == 0 || *request.threads > most_threads)) {
    words.refuse("threads", fmt::format("{} {} is out of range; give 1 to {}", words.key("threads"),
                                        *request.threads, most_threads));
  }
}

}  // namespace changeover
