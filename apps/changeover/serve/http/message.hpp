// A request and a response of HTTP, as the rest of the server knows them; what speaks HTTP is
// behind server.hpp.
//
//     Response answer(const Request& request) {
//       const auto v = request.parameter("v");          // nothing if it was not given
//       …
//       return json_response(R"({"v":20})");
//     }
//
// What cannot be answered is thrown: Refusal{404, "the catalog has no design 20.5.2.linear.1"}.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace changeover::serve {

/// Why a request is not answered: a status of HTTP, and one clear line; where in the body, if that
/// is known.
struct Refusal {
  int status = 400;
  std::string message;
  std::optional<std::uint64_t> line = {};
  std::optional<std::uint64_t> column = {};
};

struct Request {
  std::string method;
  std::string path;                                             ///< without the first '/', decoded
  std::vector<std::pair<std::string, std::string>> parameters;  ///< of the query, decoded
  std::map<std::string, std::string> headers;                   ///< names in lower case
  std::vector<std::string> repeated;  ///< headers that were given more than once
  std::string body;
  std::function<bool()> left = {};  ///< whether the client has gone; may be missing

  /// The value of a parameter. @throws Refusal if it is there twice.
  [[nodiscard]] std::optional<std::string> parameter(std::string_view name) const;
  /// The value of a header; empty if there is none.
  [[nodiscard]] std::string_view header(std::string_view name) const;
};

/// Whether who asks takes an answer that is compressed.
[[nodiscard]] bool takes_gzip(const Request& request);

class EventFeed;

struct Response {
  int status = 200;
  std::string type = "application/json; charset=utf-8";
  std::shared_ptr<const std::string> body = {};
  std::shared_ptr<const std::string> gzipped = {};  ///< the same for who takes it; may be missing
  std::string etag = {};                            ///< with its quotes; empty: none
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::shared_ptr<EventFeed> events = {};  ///< a stream of events instead of a body
};

/// A body of that type with its hash as ETag, compressed if that pays.
[[nodiscard]] Response text_response(std::string body, std::string type);
[[nodiscard]] Response json_response(std::string body);

/// {"error":{"message":…,"line":…,"column":…}}
[[nodiscard]] Response refused(const Refusal& refusal);

/// The same with its head, as it goes through the socket before the connection is closed. For
/// statuses 400, 408, 413, 414 and 431.
[[nodiscard]] std::string refused_as_text(const Refusal& refusal);

/// What a page may load, as browsers are told: files of its own server, and the style between
/// <style> and </style> of that page, by its hash.
[[nodiscard]] std::string content_policy(std::string_view page = {});

/// What is sent with every answer, unless the answer has a header of that name.
[[nodiscard]] const std::vector<std::pair<std::string, std::string>>& security_headers();

/// gzip of a text, always the same for the same text. A larger level (up to 9) takes longer to make
/// it smaller.
/// @throws MissingResource if there is no memory for it.
[[nodiscard]] std::string gzip(std::string_view text, int level = 5);

/// Why an address with its parameters, as it came, is refused; nothing if it is not.
[[nodiscard]] std::optional<Refusal> address_defect(const std::string& target);

}  // namespace changeover::serve
