#include "serve/http/message.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/core/sha256.hpp"
#include "io/scan/base64.hpp"
#include "io/write/json_writer.hpp"

namespace changeover::serve {
namespace {

constexpr std::size_t worth_compressing = 1024;

std::string etag_of(std::string_view body) {
  Sha256 hash;
  hash.add(body);
  constexpr std::size_t digits = 32;
  // Weak: the same for the text as it is and compressed.
  return "W/\"" + to_hex(hash.finish()).substr(0, digits) + '"';
}

}  // namespace

std::optional<std::string> Request::parameter(std::string_view name) const {
  std::optional<std::string> found;
  for (const auto& [key, value] : parameters) {
    if (key != name) {
      continue;
    }
    if (found) {
      throw Refusal{400, fmt::format("{} is given twice; give it once", name)};
    }
    found = value;
  }
  return found;
}

std::string_view Request::header(std::string_view name) const {
  const auto found = headers.find(std::string(name));
  return found == headers.end() ? std::string_view() : std::string_view(found->second);
}

bool takes_gzip(const Request& request) {
  const std::string_view accepted = request.header("accept-encoding");
  const std::size_t at = accepted.find("gzip");
  return at != std::string_view::npos && !accepted.substr(at + 4).starts_with(";q=0,") &&
         accepted.substr(at + 4) != ";q=0";
}

Response text_response(std::string body, std::string type) {
  Response response;
  response.type = std::move(type);
  response.etag = etag_of(body);
  if (body.size() >= worth_compressing) {
    auto packed = std::make_shared<const std::string>(gzip(body));
    if (packed->size() < body.size()) {
      response.gzipped = std::move(packed);
    }
  }
  response.body = std::make_shared<const std::string>(std::move(body));
  return response;
}

Response json_response(std::string body) {
  return text_response(std::move(body), "application/json; charset=utf-8");
}

Response refused(const Refusal& refusal) {
  JsonWriter json;
  json.begin_object().key("error").begin_object().key("message").value(refusal.message);
  if (refusal.line) {
    json.key("line").value(*refusal.line);
  }
  if (refusal.column) {
    json.key("column").value(*refusal.column);
  }
  json.end_object().end_object();
  Response response;
  response.status = refusal.status;
  response.body = std::make_shared<const std::string>(json.take() + "\n");
  response.headers = {{"Cache-Control", "no-store"}};
  return response;
}

std::string refused_as_text(const Refusal& refusal) {
  static const std::map<int, std::string_view> words{
      {400, "Bad Request"},     {408, "Request Timeout"},
      {411, "Length Required"}, {413, "Content Too Large"},
      {414, "URI Too Long"},    {431, "Request Header Fields Too Large"}};
  const Response response = refused(refusal);
  const auto word = words.find(refusal.status);
  std::string text = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n",
                                 refusal.status, word == words.end() ? "Refused" : word->second,
                                 response.type, response.body->size());
  for (const auto& [name, value] : security_headers()) {
    text += fmt::format("{}: {}\r\n", name, value);
  }
  return text + "Connection: close\r\n\r\n" + *response.body;
}

std::string content_policy(std::string_view page) {
  constexpr std::string_view opening = "<style>";
  std::string written_in_it;
  if (const std::size_t at = page.find(opening); at != std::string_view::npos) {
    page.remove_prefix(at + opening.size());
    Sha256 hash;
    hash.add(page.substr(0, page.find("</style>")));
    const auto digest = hash.finish();
    written_in_it = fmt::format(
        " 'sha256-{}'", base64_of({reinterpret_cast<const char*>(digest.data()), digest.size()}));
  }
  return "default-src 'none'; script-src 'self'; style-src 'self'" + written_in_it +
         "; img-src 'self' data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'";
}

const std::vector<std::pair<std::string, std::string>>& security_headers() {
  static const std::vector<std::pair<std::string, std::string>> headers{
      {"Content-Security-Policy", content_policy() + "; frame-ancestors 'none'"},
      {"X-Content-Type-Options", "nosniff"},
      {"X-Frame-Options", "DENY"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Permissions-Policy", "camera=(), geolocation=(), microphone=()"}};
  return headers;
}

std::string gzip(std::string_view text, int level) {
  z_stream stream{};
  constexpr int with_gzip_header = 15 + 16;
  constexpr int memory_level = 8;
  if (deflateInit2(&stream, level, Z_DEFLATED, with_gzip_header, memory_level,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    throw MissingResource("not enough memory to compress an answer; close other programs");
  }
  std::string packed(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  // zlib takes pieces of less than 4 GiB; answers are far below that.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int ended = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (ended != Z_STREAM_END) {
    throw InternalError("an answer could not be compressed");
  }
  return packed;
}

std::optional<Refusal> address_defect(const std::string& target) {
  constexpr std::size_t longest_target = 8192;
  constexpr std::size_t most_parameters = 100;
  if (target.size() > longest_target) {
    return Refusal{414,
                   fmt::format("the address has more than {} bytes; ask for less", longest_target)};
  }
  if (std::ranges::count(target, '&') >= static_cast<std::ptrdiff_t>(most_parameters)) {
    return Refusal{
        414, fmt::format("the address has more than {} parameters; give fewer", most_parameters)};
  }
  const auto is_blank = [](unsigned char c) { return c <= ' ' || c == 0x7f; };
  if (std::ranges::any_of(target, is_blank)) {
    return Refusal{400, "there is a blank in the address; write %20"};
  }
  return std::nullopt;
}

}  // namespace changeover::serve
