#include "io/request/request_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

#include "core/each.hpp"
#include "io/scan/place.hpp"

namespace changeover {

std::string RequestPlaces::before(std::string_view what) const {
  const std::size_t bracket = std::min(what.find('['), what.size());
  const auto found = offsets.find(what.substr(0, bracket));
  if (found == offsets.end()) {
    return "";
  }
  std::size_t row = 0;
  const std::string_view number = what.substr(std::min(bracket + 1, what.size()));
  const bool has_row =
      std::from_chars(number.data(), number.data() + number.size(), row).ec == std::errc();
  const std::size_t index = has_row && row + 1 < found->second.size() ? row + 1 : 0;
  const Place place = place_of(*text, found->second[index]);
  return fmt::format("{}:{}:{}: ", name, place.line, place.column);
}

std::string RequestPlaces::before_all() const { return before(""); }

std::string placed(const RequestPlaces& places, std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon == 0 || colon == std::string_view::npos
             ? std::string(line)
             : places.before(line.substr(0, colon)).append(line);
}

std::string spelled(const OptionRecord& record, Door door) {
  if (door != Door::command_line) {
    const bool other = door == Door::python && !record.python.empty();
    return std::string(other ? record.python : record.key);
  }
  const std::size_t comma = record.flags.find(",--");
  return comma == std::string::npos ? record.flags : record.flags.substr(comma + 1);
}

std::string spelled_with_value(const OptionRecord& record, Door door) {
  const std::string key = spelled(record, door);
  return door != Door::command_line || record.value.empty()
             ? key
             : fmt::format("{} {}", key, record.value);
}

std::string help_of(const OptionRecord& record) {
  return std::string(record.help) +
         (record.by_default.empty() ? "" : fmt::format(" (default: {})", record.by_default));
}

std::string sentence_of(OptionRule::Says says, const std::vector<std::string>& keys,
                        const std::vector<std::string>& others,
                        const std::vector<std::string>& where) {
  const bool one = keys.size() == 1;
  const auto sentence = [&]() -> std::string {
    switch (says) {
      case OptionRule::Says::exclude:
        return " exclude each other";
      case OptionRule::Says::needs:
        return (one ? " needs " : " need ") + enumerated(others, " or ");
      case OptionRule::Says::only_with:
        return (one ? " is for " : " are for ") + enumerated(others, " or ") + " only";
      case OptionRule::Says::never_with:
        return (one ? " has" : " have") + (" no meaning with " + enumerated(others));
    }
    return "";
  };
  return (keys.empty() ? enumerated(others, " or ") + " is required"
                       : enumerated(keys) + sentence()) +
         (where.empty() ? "" : " where " + enumerated(where, " or ") + " is given");
}

bool is_broken(const OptionRule& rule, const OptionRule& given) {
  if ((given.keys.empty() && !rule.keys.empty()) || (given.where.empty() && !rule.where.empty())) {
    return false;
  }
  switch (rule.says) {
    case OptionRule::Says::exclude:
      return given.keys.size() > 1;
    case OptionRule::Says::needs:
    case OptionRule::Says::only_with:
      return given.others.empty();
    case OptionRule::Says::never_with:
      return !given.others.empty();
  }
  return false;
}

// A line of a rule with its keys spelled.
static std::string filled(std::string_view line,
                          const std::function<std::string(std::string_view)>& spell) {
  std::string all;
  while (!line.empty()) {
    const std::size_t open = std::min(line.find('{'), line.size());
    const std::size_t close = std::min(line.find('}', open), line.size());
    all += line.substr(0, open);
    all += open < close ? spell(line.substr(open + 1, close - open - 1)) : "";
    line.remove_prefix(std::min(close + 1, line.size()));
  }
  return all;
}

std::string broken_line(const OptionRule& rule, const OptionRule& given,
                        const std::function<std::string(std::string_view)>& word) {
  const auto words = [&](const std::vector<std::string_view>& keys, std::string_view end = "") {
    return each_of<std::string>(
        keys, [&](std::string_view key) { return word(std::string(key).append(end)); });
  };
  const std::string key(given.keys.empty() ? "" : given.keys.front());
  if (!rule.line.empty()) {
    return filled(rule.line, [&](std::string_view name) {
      return name == "where" ? enumerated(words(given.where)) : word(name.empty() ? key : name);
    });
  }
  switch (rule.says) {
    case OptionRule::Says::exclude:
      return enumerated(words(rule.keys)) + " exclude each other; give one of them";
    case OptionRule::Says::needs:
      return fmt::format("{} needs {}; give it, too", word(key + "="),
                         enumerated(words(rule.others, "="), " or "));
    case OptionRule::Says::only_with:
      return fmt::format("{} is for {}; {}", word(key + "="),
                         enumerated(words(rule.others), " or "),
                         rule.others.size() == 1 ? "give both" : "give one of them, too");
    case OptionRule::Says::never_with:
      return fmt::format("{} has no meaning with {}; leave it out", word(key + "="),
                         enumerated(words(given.others)));
  }
  return "";
}

std::string enumerated(const std::vector<std::string>& names, std::string_view last) {
  const std::string but_last = fmt::format("{}", fmt::join(names.begin(), names.end() - 1, ", "));
  return but_last + std::string(but_last.empty() ? "" : last) + names.back();
}

}  // namespace changeover
