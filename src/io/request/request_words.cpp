#include "io/request/request_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

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
  if (door == Door::document) {
    return std::string(record.key);
  }
  const std::size_t comma = record.flags.find(",--");
  return comma == std::string::npos ? record.flags : record.flags.substr(comma + 1);
}

std::string spelled_with_value(const OptionRecord& record, Door door) {
  const std::string key = spelled(record, door);
  return door == Door::document || record.value.empty() ? key
                                                        : fmt::format("{} {}", key, record.value);
}

std::string help_of(const OptionRecord& record) {
  return std::string(record.help) +
         (record.by_default.empty() ? "" : fmt::format(" (default: {})", record.by_default));
}

std::string sentence_of(OptionRule::Says says, const std::vector<std::string>& keys,
                        const std::vector<std::string>& others) {
  const bool one = keys.size() == 1;
  switch (says) {
    case OptionRule::Says::exclude:
      return enumerated(keys) + " exclude each other";
    case OptionRule::Says::needs:
      return enumerated(keys) + (one ? " needs " : " need ") + enumerated(others);
    case OptionRule::Says::only_with:
      return enumerated(keys) + (one ? " is" : " are") + " for " + enumerated(others, " or ") +
             " only";
    case OptionRule::Says::never_with:
      return enumerated(keys) + (one ? " has" : " have") + " no meaning with " + enumerated(others);
  }
  return "";
}

std::string enumerated(const std::vector<std::string>& names, std::string_view last) {
  const std::string but_last = fmt::format("{}", fmt::join(names.begin(), names.end() - 1, ", "));
  return but_last + std::string(but_last.empty() ? "" : last) + names.back();
}

}  // namespace changeover
