#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "io/read/input_lines.hpp"

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
    if (!seen_any_ && !numbers && !x && !y) {  // perhaps the names of columns
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
