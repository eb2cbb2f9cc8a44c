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
#include "io/request/request_words.hpp"
#include "plan/job/bench_list.hpp"

namespace changeover {

class Question {
 public:
  Question(const JobRequest& request, Door door)
      : request_(request), words_(job_table(), request, door) {}

  [[nodiscard]] const JobRequest& operator*() const { return request_; }
  [[nodiscard]] const JobRequest* operator->() const { return &request_; }

  // "--at-once", "at_once".
  [[nodiscard]] std::string key(std::string_view key) const {
    return is_parts(key) ? "parts" : words_.key(key);
  }
  // "--at-once K", "at_once".
  [[nodiscard]] std::string with_value(std::string_view key) const {
    return is_parts(key) ? "parts" : words_.with_value(key);
  }
  [[nodiscard]] Door door_of(std::string_view key) const { return words_.door_of(key); }
  [[noreturn]] void refuse(std::string_view key, const std::string& line) const {
    words_.refuse(key, line);
  }
  // A list that is not a file is read as part of a document, at every door, so that notes on it are
  // the same at all of them.
  [[nodiscard]] std::unique_ptr<Input> open(std::string_view key, const RequestList& list) const {
    return changeover::open(list, option_of(job_table(), key).record, std::string(key));
  }
  [[nodiscard]] bool has_file() const {
    return std::ranges::any_of(job_table().options, [&](const auto& option) {
      const auto* const field = std::get_if<RequestList JobRequest::*>(&option.field);
      return field != nullptr &&
             !((request_.**field).file.empty() && (request_.**field).name.empty());
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
      refuse(key, fmt::format("{}: {}", this->key(key), fault.what()));
    } catch (const ImpossibleParameters& fault) {
      refuse(key, fmt::format("{}: {}", this->key(key), fault.what()));
    }
  }
  [[nodiscard]] std::optional<Amount> amount(std::string_view key, const std::string& text) const {
    return text.empty() ? std::nullopt : std::optional(value_of(key, [&] {
      return parse_measure(text, key == "hours" ? "number of hours" : "cost");
    }));
  }

 private:
  [[nodiscard]] bool is_parts(std::string_view key) const {
    return key == "items" && request_.items_are_parts && door_of(key) == Door::document;
  }

  const JobRequest& request_;
  RequestWords<JobRequest> words_;
};

/// Reads the lists of a request and checks all of it. @throws as checked_job()
[[nodiscard]] ReadJob read_job(const JobRequest& request, Door door);

}  // namespace changeover
