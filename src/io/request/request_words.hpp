// What messages call the keys of a request, where these stand, and the rules between them.
//
//     const RequestWords<LoadRequest> words(load_table(), request, Door::command_line);
//     check_rules(load_table(), request, words);
//     words.refuse("room", words.key("room") + " 1: give room for at least 2");
//                                              // job.json:1:9: room 1: … or --room 1: …
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/request.hpp"
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
    const std::string_view value = value_in(key);
    return spelled(option_of(table_, key).record, door_of(key)) +
           (value.empty() ? "" : " " + std::string(value));
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
    const auto& option = option_of(table_, key);
    return is_given(request_, option) ? request_.places.before(option.record.key)
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
                                      const std::vector<std::string>& others,
                                      const std::vector<std::string>& where = {});

/// "--a, --b and --c".
[[nodiscard]] std::string enumerated(const std::vector<std::string>& names,
                                     std::string_view last = " and ");

/// Whether a rule is broken. @param given  the rule with those of its keys that a request gives
[[nodiscard]] bool is_broken(const OptionRule& rule, const OptionRule& given);

/// What is said of it then. @param word  spells a key, and one with "=" behind it with its value
[[nodiscard]] std::string broken_line(const OptionRule& rule, const OptionRule& given,
                                      const std::function<std::string(std::string_view)>& word);

/// Refuses the first rule that the request breaks, in the words of `words`. @throws BadInput,
/// BadOption
template <typename Request, typename Words>
void check_rules(const RequestTable<Request>& table, const Request& request, const Words& words) {
  const auto word = [&](std::string_view key) {
    return key.ends_with('=') ? words.with_value(key.substr(0, key.size() - 1)) : words.key(key);
  };
  for (const OptionRule& rule : table.rules) {
    OptionRule given = rule;
    for (auto* const keys : {&given.keys, &given.others, &given.where}) {
      std::erase_if(*keys, [&](std::string_view key) { return !is_given(table, request, key); });
    }
    if (is_broken(rule, given)) {
      // If keys exclude each other, the place is that of the one in a document.
      const auto at = std::ranges::find_if(given.keys, [&](std::string_view key) {
        return rule.says != OptionRule::Says::exclude || words.door_of(key) == Door::document;
      });
      words.refuse(at != given.keys.end() ? *at
                   : rule.keys.empty()    ? rule.others.front()
                                          : given.keys.front(),
                   broken_line(rule, given, word));
    }
  }
}

}  // namespace changeover
