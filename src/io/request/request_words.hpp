// What messages call the keys of a request, where these stand, and the rules between them.
//
//     const RequestWords<LoadRequest> words(load_table(), request, Door::command_line);
//     check_rules(load_table(), request, words);
//     words.refuse("room", words.key("room") + " 1: give room for at least 2");
//                                              // job.json:1:9: room 1: … or --room 1: …
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/request.hpp"
#include "core/each.hpp"
#include "io/request/request_document.hpp"

namespace changeover {

/// Keys that a document gives are called as there. Others have the names of the door, and those
/// that are missing from a document have its names.
template <typename Request>
class RequestWords {
 public:
  RequestWords(const RequestTable<Request>& table, const Request& request, Door door)
      : table_(table), request_(request), door_(door) {}

  /// "--at-once", "at_once".
  [[nodiscard]] std::string key(std::string_view key) const {
    return spelled(option_of(table_, key).record, door_of(key));
  }
  /// "--at-once K", "at_once".
  [[nodiscard]] std::string with_value(std::string_view key) const {
    return spelled_with_value(option_of(table_, key).record, door_of(key));
  }
  /// A list of the request as an input. @throws as open_list()
  [[nodiscard]] std::unique_ptr<Input> open(std::string_view key, const RequestList& list) const {
    return changeover::open(list, option_of(table_, key).record, this->key(key));
  }
  [[nodiscard]] Door door_of(std::string_view key) const {
    return place_of(key).empty() ? door_ : Door::document;
  }

  /// @throws BadInput with the place of the key, or BadOption if it stands in no document.
  [[noreturn]] void refuse(std::string_view key, const std::string& line) const {
    const std::string place = place_of(key);
    if (place.empty()) {
      throw BadOption(line);
    }
    throw BadInput(place + line);
  }

 private:
  [[nodiscard]] std::string place_of(std::string_view key) const {
    return is_given(request_, option_of(table_, key)) ? request_.places.before(key)
                                                      : request_.places.before_all();
  }

  const RequestTable<Request>& table_;
  const Request& request_;
  Door door_;
};

/// A fault of a list that a document has, "pairs[3]: …", with its place.
[[nodiscard]] std::string placed(const RequestPlaces& places, std::string_view line);

/// Calls `read`. Faults of lists that a document has get their places.
template <typename Read>
auto with_places(const RequestPlaces& places, Read&& read) {
  try {
    return read();
  } catch (const BadOption&) {
    throw;
  } catch (const BadInput& fault) {
    throw BadInput(placed(places, fault.what()));
  }
}

/// A rule as a sentence: "--header and --no-header exclude each other".
[[nodiscard]] std::string sentence_of(OptionRule::Says says, const std::vector<std::string>& keys,
                                      const std::vector<std::string>& others);

/// "--a, --b and --c".
[[nodiscard]] std::string enumerated(const std::vector<std::string>& names,
                                     std::string_view last = " and ");

/// Refuses the first rule that the request breaks, in the words of `words`. @throws BadInput,
/// BadOption
template <typename Request, typename Words>
void check_rules(const RequestTable<Request>& table, const Request& request, const Words& words) {
  const auto given = [&](std::string_view key) { return is_given(request, option_of(table, key)); };
  const auto named = [&](const std::vector<std::string_view>& keys) {
    return each_of<std::string>(keys, [&](const std::string_view key) { return words.key(key); });
  };
  const auto those_given = [&](const std::vector<std::string_view>& keys) {
    std::vector<std::string_view> present;
    std::ranges::copy_if(keys, std::back_inserter(present), given);
    return present;
  };
  for (const OptionRule& rule : table.rules) {
    const std::vector<std::string_view> keys = those_given(rule.keys);
    const std::vector<std::string_view> others = those_given(rule.others);
    if (rule.says == OptionRule::Says::exclude && keys.size() > 1) {
      // At the one that stands in a document.
      const auto at = std::ranges::find_if(
          keys, [&](std::string_view key) { return words.door_of(key) == Door::document; });
      words.refuse(at == keys.end() ? keys.front() : *at,
                   enumerated(named(rule.keys)) + " exclude each other");
    }
    for (const std::string_view key : keys) {
      if (rule.says == OptionRule::Says::needs && others.size() < rule.others.size()) {
        const auto missing = std::ranges::find_if_not(rule.others, given);
        words.refuse(key, fmt::format("{} needs {}; give it, too", words.with_value(key),
                                      words.with_value(*missing)));
      }
      if (rule.says == OptionRule::Says::only_with && others.empty()) {
        words.refuse(key,
                     fmt::format("{} is for {}; {}", words.with_value(key),
                                 enumerated(named(rule.others), " or "),
                                 rule.others.size() == 1 ? "give both" : "give one of them, too"));
      }
      if (rule.says == OptionRule::Says::never_with && !others.empty()) {
        words.refuse(key, fmt::format("{} has no meaning with {}; leave it out",
                                      words.with_value(key), enumerated(named(others))));
      }
    }
  }
}

}  // namespace changeover
