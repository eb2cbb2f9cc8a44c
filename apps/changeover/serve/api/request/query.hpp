// What a query asks for.
//
//     const Parameters p = cell_of(request);          // ?v=20&k=5&change=2&kind=linear
//     const Range k = range_of(request, "k", {3, 8});
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/core/parameters.hpp"
#include "changeover/io/request.hpp"
#include "io/request/request_document.hpp"
#include "io/scan/json_events.hpp"
#include "request/parameters.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// What a body is called in messages of its readers.
inline constexpr std::string_view name_of_body = "<text>";

/// 422 with the place in the body with which such a message begins, if it does.
[[nodiscard]] Refusal malformed(const std::string& message);

/// @throws Refusal 400 if it is no whole number.
[[nodiscard]] std::optional<std::uint64_t> number_of(const Request& request, std::string_view name);
/// @throws Refusal 400 also if it is missing.
[[nodiscard]] std::uint64_t needed_number(const Request& request, std::string_view name);

/// The value, which is one of `words`; the first of them if it is missing. @throws Refusal 400
[[nodiscard]] std::string word_of(const Request& request, std::string_view name,
                                  const std::vector<std::string>& words);

/// "circular" or "linear", if one is named. @throws Refusal 400
[[nodiscard]] std::optional<Kind> kind_of(const Request& request);
/// @throws Refusal 400 also if none is.
[[nodiscard]] Kind needed_kind(const Request& request);
/// 2 if it is missing. @throws Refusal 400
[[nodiscard]] std::uint32_t strength_of(const Request& request);

/// v, k, change (2 if it is missing), strength (2) and kind, which must be there. @throws Refusal
/// 400, ImpossibleParameters
[[nodiscard]] Parameters cell_of(const Request& request);
/// The same for each kind that may answer: the named one, or circular and linear.
[[nodiscard]] std::vector<Parameters> cells_of(const Request& request);

/// "A..B" or "A". @throws Refusal 400
[[nodiscard]] cli::Range range_of(const Request& request, std::string_view name,
                                  const cli::Range& usual);

// Bodies of JSON: an object whose members are asked for by name, and by type.
//
//     const JsonBody body(request.body);
//     const std::uint64_t items = body.needed_number("items");
//     body.finish();                                   // refuses members that were not read

class JsonBody {
 public:
  /// @throws Refusal 422 with line and column if it is no JSON, nests deeper than 256 levels, has a
  /// key twice or is no object.
  explicit JsonBody(const std::string& text);
  /// @throws Refusal 422 if it is no object.
  explicit JsonBody(JsonNode object);

  /// nullptr if it is missing or null.
  [[nodiscard]] const JsonNode* find(const std::string& name);

  /// A whole number that is not negative. @throws Refusal 422 if it is something else.
  [[nodiscard]] std::optional<std::uint64_t> number(const std::string& name);
  [[nodiscard]] std::uint64_t needed_number(const std::string& name);
  [[nodiscard]] std::optional<double> seconds(const std::string& name);
  [[nodiscard]] std::optional<bool> boolean(const std::string& name);
  [[nodiscard]] std::optional<std::string> text(const std::string& name);

  /// @throws Refusal 422 if there are members that were not read.
  void finish() const;

 private:
  // nullptr if it is missing or null. @throws Refusal 422 if it is of another type.
  const JsonNode* find_of_type(const std::string& name, JsonEvent::Type type,
                               std::string_view what);

  JsonNode object_;
  std::set<std::string> asked_;
};

/// JSON without blanks; numbers are as they were written.
[[nodiscard]] std::string json_text(const JsonNode& node);

// Bodies that are request documents (changeover/io/request.hpp): what the server does not take of
// them.

/// @throws Refusal 422 for a file, of which the server opens none, and for keys that are not for
/// this door, with the reason.
template <typename Request>
void require_of_server(const Request& request, const RequestTable<Request>& table) {
  for (const auto& option : table.options) {
    const OptionRecord& record = option.record;
    if (!is_given(request, option)) {
      continue;
    }
    const std::string place = request.places.before(record.key);
    if (!record.not_in_server.empty()) {
      throw malformed(fmt::format("{}{}: not here; {}", place, record.key, record.not_in_server));
    }
    const auto* const field = std::get_if<RequestList Request::*>(&option.field);
    if (field != nullptr && !(request.**field).file.empty()) {
      throw malformed(fmt::format(
          "{}{}: the server opens no files; send its rows, or {{\"text\":…}}", place, record.key));
    }
  }
}

/// The time of a search that a request asks for, or what holds where it does not. @throws Refusal
/// 422 for more than `most`.
template <typename Request>
[[nodiscard]] double search_seconds(const Request& request, double usual, double most) {
  const double seconds = request.seconds.value_or(usual);
  if (seconds < 0 || seconds > most) {
    throw malformed(fmt::format("{}seconds: write 0 to {}; the command line takes more",
                                request.places.before("seconds"), most));
  }
  return seconds;
}

/// What is wrong with the body, whichever of its keys, is 422. Calls `read`.
template <typename Read>
auto from_body(Read&& read) {
  try {
    return read();
  } catch (const BadInput& fault) {
    throw malformed(fault.what());
  } catch (const ImpossibleParameters& fault) {
    throw Refusal{422, fault.what()};
  }
}

}  // namespace changeover::serve
