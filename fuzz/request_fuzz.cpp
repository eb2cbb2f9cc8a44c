// Requests to the explorer's server, from any bytes: up to three, one after another, each a line
// "METHOD TARGET", lines of headers, an empty line and a body. They go through the guard, the
// router and the code that answers, with the token where a header asks "TOKEN". Every answer has a
// status that is documented, and is what its type says.
#include <algorithm>
#include <cctype>
#include <new>
#include <optional>
#include <set>
#include <sstream>

#include "changeover/io/formats.hpp"
#include "serve/api/routes.hpp"
#include "serve/jobs/search_jobs.hpp"
#include "serve/plans/plan_jobs.hpp"
#include "serve/plans/run_store.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::request_fuzz {
namespace {

using namespace changeover::serve;

// The server behind its sockets.
struct Place {
  Scratch scratch;
  Catalog catalog{{.shipped = {}, .user = scratch.file("mine.db")}};
  Pages pages{""};
  Explorer explorer{catalog};
  std::shared_ptr<const Router> router;
  Guard guard{{"localhost"}, "0f1e2d3c"};

  Place() {
    explorer.limits = {.body_bytes = 100'000,
                       .json_bytes = 100'000,
                       .seconds = std::chrono::milliseconds(400),
                       .memory_bytes = std::uint64_t{64} << 20U,
                       .searches = 1,
                       .plans = 1};
    explorer.files.push_back(
        {"mine.txt", read_text(input_from_text("# labels: a b c d\na b c\nb c d\nc d a\n"))});
    explorer.jobs = std::make_shared<SearchJobs>(
        catalog, explorer.events,
        SearchJobs::Settings{.at_once = 1, .memory_bytes = explorer.limits.memory_bytes});
    explorer.plans = std::make_shared<PlanJobs>(
        explorer.events,
        PlanJobs::Settings{.at_once = 1, .memory_bytes = explorer.limits.memory_bytes});
    explorer.runs = std::make_shared<RunStore>(scratch.file("runs"), explorer.events);
    router = routes(explorer, pages);
  }
};

std::string decoded(const std::string& text, bool plus_is_a_blank) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto is_digit = [&](std::size_t at) {
      return at < text.size() && std::isxdigit(static_cast<unsigned char>(text[at])) != 0;
    };
    if (text[i] == '%' && is_digit(i + 1) && is_digit(i + 2)) {
      plain += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      plain += plus_is_a_blank && text[i] == '+' ? ' ' : text[i];
    }
  }
  return plain;
}

void read_target(const std::string& target, Request& request) {
  const std::size_t question = target.find('?');
  request.path = decoded(target.substr(0, question), false);
  if (request.path.starts_with('/')) {
    request.path.erase(0, 1);
  }
  if (question == std::string::npos) {
    return;
  }
  std::istringstream query(target.substr(question + 1));
  for (std::string each; std::getline(query, each, '&');) {
    const std::size_t equals = each.find('=');
    request.parameters.emplace_back(
        decoded(each.substr(0, equals), true),
        equals == std::string::npos ? "" : decoded(each.substr(equals + 1), true));
  }
}

Request request_of(const std::string& bytes, const std::string& token) {
  Request request;
  std::istringstream lines(bytes);
  std::string line;
  std::getline(lines, line);
  const std::size_t blank = line.find(' ');
  request.method = line.substr(0, blank);
  read_target(blank == std::string::npos ? "" : line.substr(blank + 1), request);
  request.headers["host"] = "localhost";
  while (std::getline(lines, line) && !line.empty()) {
    const std::size_t colon = line.find(':');
    std::string name = line.substr(0, colon);
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::size_t value = line.find_first_not_of(' ', std::min(colon, line.size() - 1) + 1);
    request.headers[name] = value == std::string::npos ? "" : line.substr(value);
    if (request.headers[name] == "TOKEN") {
      request.headers[name] = token;
    }
  }
  request.body.assign(std::istreambuf_iterator<char>(lines), {});
  if (!request.body.empty() || request.method == "POST") {
    request.headers["content-length"] = std::to_string(request.body.size());
  }
  return request;
}

// As server.cpp, but exceptions other than refusals are passed on to the caller.
Response answer(Place& place, const Request& request) {
  try {
    place.guard.check(request, Action::asks);
    const Route& route = place.router->route_of(request);
    place.guard.check(request, route.action);
    (void)route.lane(request);
    return route.answer(request);
  } catch (const Refusal& refusal) {
    must(is_one_plain_line(refusal.message), "a refusal is one plain line: " + refusal.message);
    return refused(refusal);
  } catch (const std::bad_alloc&) {
    return refused({503, "the server has no memory left for this"});
  }
}

void judge(const Request& request, const Response& response) {
  static const std::set<int> documented{200, 400, 401, 403, 404, 405, 409,
                                        411, 413, 415, 422, 429, 503};
  must(documented.contains(response.status),
       "a status is documented, not " + std::to_string(response.status));
  for (const auto& [name, value] : response.headers) {
    must(is_one_plain_line(name) && is_one_plain_line(value), "a header is one line");
  }
  must(is_one_plain_line(response.type), "a type is one line");
  if (!response.body) {
    must(response.events != nullptr, "an answer has a body");
    return;
  }
  const bool page = response.status == 200 && !request.path.starts_with("api/");
  if (response.type.starts_with("application/json")) {
    must(is_plain_json(*response.body), "an answer is JSON: " + response.body->substr(0, 500));
  } else if (!page) {
    must(is_plain(*response.body), "an answer is plain text: " + response.body->substr(0, 500));
  }
}

const Target target("request", [](const std::string& bytes) {
  static std::optional<Place> place;
  if (!place) {
    place.emplace();
  }
  bool changed = false;
  for (const std::string& part : parts_of(bytes, 3)) {
    if (part.empty()) {
      continue;
    }
    const Request request = request_of(part, place->guard.token());
    judge(request, answer(*place, request));
    if (request.method == "POST" && request.headers.contains("x-changeover-token")) {
      changed = true;
      must(place->explorer.jobs->stop_all(std::chrono::seconds(20)), "a search stops");
    }
  }
  if (changed) {
    place.reset();
  }
});

}  // namespace
}  // namespace changeover::fuzz::request_fuzz
