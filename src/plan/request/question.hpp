// A request with the words of its door.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "changeover/core/error.hpp"
#include "changeover/plan/job_request.hpp"
#include "io/request/request_document.hpp"
#include "plan/job/bench_list.hpp"

namespace changeover {

class Question {
 public:
  Question(const JobRequest& request, Door door) : request_(request), door_(door) {}

  [[nodiscard]] const JobRequest& operator*() const { return request_; }
  [[nodiscard]] const JobRequest* operator->() const { return &request_; }

  // "--at-once", "at_once".
  [[nodiscard]] std::string key(std::string_view key) const {
    const bool as_parts = door_ == Door::document && key == "items" && request_.items_are_parts;
    return spelled(option_of(job_table(), as_parts ? "parts" : key).record, door_);
  }
  // "--at-once K", "at_once".
  [[nodiscard]] std::string with_value(std::string_view key) const {
    const OptionRecord& record = option_of(job_table(), key).record;
    return door_ == Door::command_line ? fmt::format("{} {}", this->key(key), record.value)
                                       : this->key(key);
  }
  // A list that is not a file is read as part of a document, at every door, so that notes on it are
  // the same at all of them.
  [[nodiscard]] std::unique_ptr<Input> open(std::string_view key, const RequestList& list) const {
    return changeover::open(list, option_of(job_table(), key).record, std::string(key));
  }
  [[nodiscard]] bool has_file() const {
    return std::ranges::any_of(job_table().options, [&](const auto& option) {
      const auto* const field = std::get_if<RequestList JobRequest::*>(&option.field);
      return field != nullptr && !(request_.**field).file.empty();
    });
  }

  // Attributes a wrong value to its key.
  template <typename Read>
  auto value_of(std::string_view key, Read&& read) const {
    try {
      return read();
    } catch (const BadOption&) {
      throw;
    } catch (const BadInput& fault) {
      throw BadOption(fmt::format("{}: {}", this->key(key), fault.what()));
    } catch (const ImpossibleParameters& fault) {
      throw BadOption(fmt::format("{}: {}", this->key(key), fault.what()));
    }
  }
  [[nodiscard]] std::optional<Amount> amount(std::string_view key, const std::string& text) const {
    return text.empty() ? std::nullopt : std::optional(value_of(key, [&] {
      return parse_measure(text, key == "hours" ? "number of hours" : "cost");
    }));
  }
  [[nodiscard]] Door door() const { return door_; }

 private:
  const JobRequest& request_;
  Door door_;
};

}  // namespace changeover
