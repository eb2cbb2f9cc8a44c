// The options of every request that starts a search.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "changeover/io/request.hpp"
#include "io/request/option.hpp"

namespace changeover {

/// Adds them. @param how_long  help of the time
/// @param no_time_in_server  why the server does not take a time; empty: it does
template <typename Request>
[[nodiscard]] std::vector<RequestOption<Request>> with_search_options(
    std::vector<RequestOption<Request>> options, std::string_view how_long,
    std::string_view no_time_in_server = {}) {
  options.push_back(option("seconds", "DURATION", how_long, &Request::seconds,
                           {.flags = "--time",
                            .unit = "seconds",
                            .python = "time",
                            .not_in_server = no_time_in_server,
                            .of_every_search = true}));
  options.push_back(option(
      "threads", "N", "threads to use", &Request::threads,
      {.not_in_server = "the server gives each request its share", .of_every_search = true}));
  options.push_back(
      option("seed", "N", "seed of the random numbers", &Request::seed,
             {.by_default = "1",
              .not_in_server = "the same request has the same answer for every caller",
              .of_every_search = true}));
  return options;
}

/// @throws BadInput, BadOption for more threads than any search takes, or none.
template <typename Request, typename Words>
void check_threads(const Request& request, const Words& words) {
  constexpr std::uint64_t most_threads = 1024;
  if (request.threads && (*request.threads == 0 || *request.threads > most_threads)) {
    words.refuse("threads", fmt::format("{} {} is out of range; give 1 to {}", words.key("threads"),
                                        *request.threads, most_threads));
  }
}

}  // namespace changeover
