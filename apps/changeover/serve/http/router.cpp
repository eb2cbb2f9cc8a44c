#include "serve/http/router.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/parsed.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"

namespace changeover::serve {

void Router::add(Route route) {
  auto key = std::pair(route.path, route.method);
  if (!routes_.emplace(std::move(key), std::move(route)).second) {
    throw InternalError("an address of the server is there twice");
  }
}

void Router::add_elsewhere(Route route, std::function<bool(const std::string&)> has) {
  elsewhere_ = std::move(route);
  has_ = std::move(has);
}

bool Router::is_elsewhere(const std::string& path) const {
  return has_ && allowed_here(path).empty() && has_(path);
}

std::size_t declared_length(const Request& request) {
  const std::string_view text = request.header("content-length");
  const auto length = parsed<std::size_t>(text);
  if (!text.empty() && !length) {
    throw Refusal{400, "the header Content-Length is not a number of bytes"};
  }
  return length.value_or(0);
}

static constexpr const char* no_form = "send the file itself as the body, not a form";

void refuse_form(const Route& route, const Request& request) {
  const std::string type = lower_case(std::string(request.header("content-type")));
  const std::string_view body = request.body;
  const std::size_t end = body.find_first_of("= \t\r\n");
  if (route.body == Body::any && type.starts_with("application/x-www-form-urlencoded") &&
      end != std::string::npos && body[end] == '=') {
    throw Refusal{415, no_form};
  }
}

static void check_body(const Route& route, const Request& request) {
  const std::size_t length = declared_length(request);
  if (request.headers.contains("transfer-encoding") ||
      (route.body != Body::none && request.header("content-length").empty())) {
    throw Refusal{411, "say in the header Content-Length how many bytes are sent"};
  }
  if (length > route.most_bytes) {
    throw Refusal{413, route.body == Body::none
                           ? fmt::format("{} takes no body", route.path)
                           : fmt::format("{} takes at most {} bytes, not {}", route.path,
                                         route.most_bytes, length)};
  }
  const std::string coding = lower_case(std::string(request.header("content-encoding")));
  if (route.body != Body::none && !coding.empty() && coding != "identity") {
    throw Refusal{415, "send the body as it is, without Content-Encoding"};
  }
  std::string type(request.header("content-type"));
  type = lower_case(type.substr(0, type.find(';')));
  type.erase(type.find_last_not_of(" \t") + 1);
  if (route.body == Body::json && type != "application/json") {
    throw Refusal{415, "send JSON, with the header Content-Type: application/json"};
  }
  if (route.body == Body::any && type.starts_with("multipart/")) {
    throw Refusal{415, no_form};
  }
}

const Route& Router::route_of(const Request& request) const {
  const std::string method = request.method == "HEAD" ? "GET" : request.method;
  const auto found = routes_.find({request.path, method});
  const bool elsewhere =
      found == routes_.end() && method == elsewhere_.method && is_elsewhere(request.path);
  if (found == routes_.end() && !elsewhere) {
    if (const std::string methods = allowed(request.path); !methods.empty()) {
      throw Refusal{405,
                    fmt::format("/{} does not take this method; use {}", request.path, methods)};
    }
    throw Refusal{404, "there is nothing at this address; the pages begin at /"};
  }
  const Route& route = elsewhere ? elsewhere_ : found->second;
  for (const auto& [name, value] : request.parameters) {
    if (std::ranges::find(route.parameters, name) == route.parameters.end()) {
      throw Refusal{400, route.parameters.empty()
                             ? fmt::format("/{} takes no parameters; leave them out", route.path)
                             : fmt::format("/{} has no parameter '{}'; there are {}", route.path,
                                           printable(name), fmt::join(route.parameters, ", "))};
    }
  }
  check_body(route, request);
  return route;
}

std::string Router::allowed(const std::string& path) const {
  const std::string methods = allowed_here(path);
  return methods.empty() && is_elsewhere(path) ? elsewhere_.method + ", HEAD" : methods;
}

std::string Router::allowed_here(const std::string& path) const {
  std::string methods;
  for (auto at = routes_.lower_bound({path, ""}); at != routes_.end() && at->first.first == path;
       ++at) {
    methods += (methods.empty() ? "" : ", ") + at->first.second;
    methods += at->first.second == "GET" ? ", HEAD" : "";
  }
  return methods;
}

}  // namespace changeover::serve
