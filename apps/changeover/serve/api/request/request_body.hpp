// Bodies that are request documents (changeover/io/request.hpp): what the server does not take of
// them.
#pragma once

#include <fmt/format.h>

#include <string>

#include "changeover/core/error.hpp"
#include "changeover/io/request.hpp"
#include "io/request/request_document.hpp"
#include "serve/http/message.hpp"

namespace changeover::serve {

/// @throws Refusal 422 for a file, of which the server opens none, and for keys that are not for
/// this door, with the reason.
template <typename Request>
void require_of_server(const Request& request, const RequestTable<Request>& table) {
  for (const auto& option : table.options) {
    const OptionRecord& record = option.record;
    if (!is_given(request, option)) {
      continue;
    }
    if (!record.not_in_server.empty()) {
      throw Refusal{422, fmt::format("{}: not here; {}", record.key, record.not_in_server)};
    }
    const auto* const field = std::get_if<RequestList Request::*>(&option.field);
    if (field != nullptr && !(request.**field).file.empty()) {
      throw Refusal{422,
                    fmt::format("{}: the server opens no files; send its rows, or {{\"text\":…}}",
                                record.key)};
    }
  }
}

/// What is wrong with the body, whichever of its keys, is 422. Calls `read`.
template <typename Read>
auto from_body(Read&& read) {
  try {
    return read();
  } catch (const BadInput& fault) {
    throw Refusal{422, fault.what()};
  } catch (const ImpossibleParameters& fault) {
    throw Refusal{422, fault.what()};
  }
}

}  // namespace changeover::serve
