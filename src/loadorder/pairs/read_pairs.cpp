#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "core/utf8.hpp"
#include "io/scan/input_lines.hpp"

namespace changeover {
namespace {

constexpr std::size_t longest_name = 255;
constexpr std::size_t longest_line = 65'536;

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';'; }

/// A plain decimal below `most_items`.
std::optional<Element> item_number(std::string_view word) {
  Element number = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  const bool plain = error == std::errc() && stop == end && (word[0] != '0' || word.size() == 1);
  return plain && number < most_items ? std::optional(number) : std::nullopt;
}

/// What `word` is as a number if it is written like one: digits, perhaps with a sign, leading zeros or a point, without
/// what makes no difference to the number. Nothing for all other words.
std::optional<std::string> as_number(std::string_view word) {
  const bool negative = word.starts_with('-');
  if (negative || word.starts_with('+')) {
    word.remove_prefix(1);
  }
  const std::size_t point = std::min(word.find('.'), word.size());
  const std::string_view whole = word.substr(0, point);
  std::string_view part = point < word.size() ? word.substr(point + 1) : std::string_view();
  const auto digits = [](std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (whole.empty() || !digits(whole) || !digits(part)) {
    return std::nullopt;
  }
  std::string number(whole.substr(std::min(whole.find_first_not_of('0'), whole.size() - 1)));
  part = part.substr(0, part.find_last_not_of('0') + 1);
  if (!part.empty()) {
    number += '.';
    number += part;
  }
  return negative && number != "0" ? '-' + number : number;
}

/// A character that nobody sees and that makes another name of a name, as in "U+200B"; nothing if there is none. `word`
/// is UTF-8.
std::optional<std::string> invisible_character(std::string_view word) {
  constexpr auto ranges = std::to_array<std::pair<char32_t, char32_t>>({{0xA0, 0xA0},
                                                                        {0xAD, 0xAD},
                                                                        {0x34F, 0x34F},
                                                                        {0x61C, 0x61C},
                                                                        {0x115F, 0x1160},
                                                                        {0x17B4, 0x17B5},
                                                                        {0x180B, 0x180F},
                                                                        {0x2000, 0x200F},
                                                                        {0x2028, 0x202F},
                                                                        {0x205F, 0x206F},
                                                                        {0x3000, 0x3000},
                                                                        {0x3164, 0x3164},
                                                                        {0xFE00, 0xFE0F},
                                                                        {0xFEFF, 0xFEFF},
                                                                        {0xFFA0, 0xFFA0},
                                                                        {0xE0000, 0xE0FFF}});
  while (!word.empty()) {
    const CodePoint point = first_code_point(word);
    word.remove_prefix(point.bytes);
    for (const auto& [first, last] : ranges) {
      if (point.value >= first && point.value <= last) {
        return fmt::format("U+{:04X}", std::uint32_t{point.value});
      }
    }
  }
  return std::nullopt;
}

/// Two items as most files write them: digits, one blank, tab or comma, digits. Nothing for every other line.
std::optional<std::pair<Element, Element>> plain_pair(std::string_view line) {
  constexpr std::size_t most_digits = 7;  // below most_items
  static_assert(most_items == 10'000'000);
  std::size_t at = 0;
  const auto number = [&](Element& value) {
    const std::size_t begin = at;
    value = 0;
    for (; at < line.size() && line[at] >= '0' && line[at] <= '9'; ++at) {
      value =
          10 * value + static_cast<Element>(line[at] - '0');  // of no use if there are more digits
    }
    const std::size_t digits = at - begin;
    return digits > 0 && digits <= most_digits && (digits == 1 || line[begin] != '0');
  };
  std::pair<Element, Element> pair;
  if (number(pair.first) && at < line.size() && separates(line[at]) &&
      (++at, number(pair.second)) && at == line.size()) {
    return pair;
  }
  return std::nullopt;
}

/// Pairs in pieces, so that more of them move none. A piece is so large that the system has it back at once; what is not
/// used of it takes no memory.
class Pieces {
 public:
  void add(Element x, Element y) {
    if (pieces_.empty() || pieces_.back().size() == piece) {
      pieces_.emplace_back().reserve(piece);
    }
    pieces_.back().emplace_back(x, y);
  }

  template <typename Visit>
  void each(Visit&& visit) {
    for (auto& of_piece : pieces_) {
      for (auto& [x, y] : of_piece) {
        visit(x, y);
      }
    }
  }

  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  void clear() { pieces_.clear(); }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 22;
  std::vector<std::vector<ItemPair>> pieces_;
};

class PairReader {
 public:
  PairReader(Input& input, const PairFileOptions& options)
      : lines_(input, longest_line), options_(options) {
    if (options_.items && (*options_.items == 0 || *options_.items > most_items)) {
      throw BadInput(fmt::format("{} items: give 1 to {}", *options_.items, most_items));
    }
  }

  std::shared_ptr<const PairGraph> read() {
    for (auto next = lines_.next(); next != InputLines::Next::end; next = lines_.next()) {
      if (next == InputLines::Next::too_long) {
        fail("a line of more than 65536 bytes; give two items a line");
      }
      if (!named_ && seen_any_ && first_line_.empty()) {
        if (const auto pair = plain_pair(lines_.line())) {
          add_numbers(pair->first, pair->second);
          continue;
        }
      }
      std::array<std::string_view, 2> words;
      if (split(lines_.line(), words)) {
        take(words);
      }
    }
    settle_first_line(false);
    if (pairs_.empty()) {
      throw BadInput(lines_.name() + ": no pair is listed; give two items a line");
    }
    const std::uint64_t items = options_.items && names_.empty() ? *options_.items
                                : names_.empty()                 ? std::uint64_t{largest_} + 1
                                                                 : names_.size();
    numbers_.clear();
    written_.clear();
    return std::make_shared<const PairGraph>(
        items,
        [&](const PairGraph::Visit& visit) {
          pairs_.each([&](Element x, Element y) { visit(x, y); });
        },
        std::move(names_));
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw BadInput(fmt::format("{}:{}: {}", lines_.name(), lines_.number(), what));
  }

  // False for a line without items.
  bool split(std::string_view line, std::array<std::string_view, 2>& words) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < line.size();) {
      if (separates(line[i])) {
        ++i;
        continue;
      }
      if (count == 0 && (line[i] == '#' || line[i] == '%')) {
        return false;
      }
      std::size_t end = i;
      while (end < line.size() && !separates(line[end])) {
        ++end;
      }
      if (count == 2) {
        fail("more than two items; give two a line, and names without blanks");
      }
      words[count++] = line.substr(i, end - i);
      i = end;
    }
    if (count == 1) {
      fail("one item stands alone; give two a line");
    }
    return count == 2;
  }

  void take(const std::array<std::string_view, 2>& words) {
    const auto x = item_number(words[0]);
    const auto y = item_number(words[1]);
    const bool numbers = x && y;
    if (!seen_any_ && !as_number(words[0]) && !as_number(words[1])) {  // perhaps names of columns
      seen_any_ = true;
      first_line_ = {std::string(words[0]), std::string(words[1])};
      for (const std::string& word : first_line_) {
        check_name(word);
      }
      return;
    }
    seen_any_ = true;
    settle_first_line(numbers);
    if (named_ || !numbers) {
      if (!named_ && !pairs_.empty()) {
        for (const std::string_view word : words) {
          if (const auto number = as_number(word); number && *number != word) {
            fail(fmt::format(
                "'{}' is not written like the whole numbers before it; write {}, or begin all "
                "items with a letter if they are names",
                word, *number));
          }
        }
      }
      become_named();
      const Element a = item_called(words[0]);
      const Element b = item_called(words[1]);
      pairs_.add(a, b);
      return;
    }
    add_numbers(*x, *y);
  }

  void add_numbers(Element x, Element y) {
    for (const Element z : {x, y}) {
      if (options_.items && z >= *options_.items) {
        fail(fmt::format("item {}, but --items {} numbers them from 0 to {}", z, *options_.items,
                         *options_.items - 1));
      }
      largest_ = std::max(largest_, z);
    }
    pairs_.add(x, y);
  }

  // Words over numbers are the names of columns.
  void settle_first_line(bool numbers_follow) {
    if (first_line_.empty()) {
      return;
    }
    const std::vector<std::string> words = std::move(first_line_);
    first_line_.clear();
    if (!numbers_follow) {
      become_named();
      const Element a = item_called(words[0]);
      const Element b = item_called(words[1]);
      pairs_.add(a, b);
    }
  }

  // What were numbers are names from now on.
  void become_named() {
    if (named_) {
      return;
    }
    named_ = true;
    pairs_.each([&](Element& x, Element& y) {
      x = item_called(std::to_string(x));
      y = item_called(std::to_string(y));
    });
  }

  void check_name(std::string_view word) {
    if (word.size() > longest_name) {
      fail("a name of more than 255 bytes; shorten it");
    }
    if (const auto defect = label_defect(word)) {
      fail(fmt::format("the name '{}': {}", word, *defect));
    }
    if (const auto character = invisible_character(word)) {
      fail(fmt::format("the name '{}' has a character that cannot be seen, {}; remove it", word,
                       *character));
    }
    if (word.find('|') != std::string_view::npos) {
      fail(fmt::format(
          "the name '{}' has a '|', which stands between the names of a pair; rename it", word));
    }
  }

  Element item_called(std::string_view word) {
    const auto [found, is_new] =
        numbers_.try_emplace(std::string(word), static_cast<Element>(names_.size()));
    if (is_new) {
      check_name(word);
      if (const auto number = as_number(word)) {
        const auto [other, first] = written_.try_emplace(*number, word);
        if (!first) {
          fail(fmt::format("'{}' and '{}' are one number and two names; write it in one way",
                           other->second, word));
        }
      }
      if (names_.size() == options_.items.value_or(most_items)) {
        fail(fmt::format("'{}' is one name more than {} items", word, names_.size()));
      }
      names_.emplace_back(word);
    }
    return found->second;
  }

  InputLines lines_;
  PairFileOptions options_;
  Pieces pairs_;
  bool seen_any_ = false;
  bool named_ = false;
  std::vector<std::string> first_line_;
  Element largest_ = 0;
  std::vector<std::string> names_;
  std::unordered_map<std::string, Element> numbers_;
  std::unordered_map<std::string, std::string> written_;  // names that are numbers, by the number
};

}  // namespace

std::shared_ptr<const PairGraph> read_pairs(Input& input, const PairFileOptions& options) {
  return PairReader(input, options).read();
}

std::shared_ptr<const PairGraph> read_pairs(const std::string& path,
                                            const PairFileOptions& options) {
  return read_pairs(*open_input(path), options);
}

}  // namespace changeover
