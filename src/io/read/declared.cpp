#include "io/read/declared.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "core/printable.hpp"
#include "core/words.hpp"
#include "io/scan/text_scanner.hpp"

namespace changeover {
namespace {

template <typename T>
std::optional<std::string> declare_number(std::optional<T>& found, std::string_view key,
                                          std::string_view text, std::uint64_t least,
                                          std::uint64_t most) {
  if (found) {
    return fmt::format("{} is given twice; give it once", key);
  }
  const auto value = plain_number(text);
  if (!value || *value < least || *value > most) {
    return fmt::format("{}={}: bad value; give a whole number from {} to {}", key, shown(text),
                       least, most);
  }
  found = static_cast<T>(*value);
  return std::nullopt;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    words.push_back(word);
  }
  return words;
}

// The lines that are not blank or comments, up to `limit` of them.
std::vector<std::string_view> first_lines(std::string_view text, std::size_t limit) {
  std::vector<std::string_view> lines;
  while (!text.empty() && lines.size() < limit) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start != std::string_view::npos && line[start] != '#') {
      lines.push_back(line.substr(start));
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return lines;
}

// After a header comes a design, even if it looks like a table.
bool has_header(std::string_view beginning) {
  return without_byte_order_mark(beginning).starts_with("# changeover design");
}

// B1, B12 or B0,3.
bool is_block_name(std::string_view word) {
  return word.size() >= 2 && word[0] == 'B' && word[1] >= '0' && word[1] <= '9' &&
         word.find_first_not_of("0123456789,", 1) == std::string_view::npos;
}

}  // namespace

std::string_view next_word(std::string_view& words) {
  constexpr std::string_view blanks = " \t\r\n";
  words.remove_prefix(std::min(words.find_first_not_of(blanks), words.size()));
  const std::string_view word = words.substr(0, words.find_first_of(blanks));
  words.remove_prefix(word.size());
  return word;
}

std::optional<std::string> declare(ReadOptions& found, std::string_view key,
                                   std::string_view text) {
  if (key == "v") {
    return declare_number(found.v, key, text, 1, max_elements_in_memory);
  }
  if (key == "k") {
    return declare_number(found.k, key, text, 1, max_elements_in_memory);
  }
  if (key == "change") {
    return declare_number(found.change, key, text, 1, max_elements_in_memory);
  }
  if (key == "strength") {
    return declare_number(found.strength, key, text, 2, max_strength);
  }
  if (key == "kind") {
    if (found.kind) {
      return "kind is given twice; give it once";
    }
    found.kind = kind_from_string(text);
    if (!found.kind) {
      return fmt::format("kind={}: bad value; give linear or circular", shown(text));
    }
  }
  return std::nullopt;
}

std::optional<std::string> add_label(TokenTable& labels, std::string_view label) {
  if (auto defect = word_defect(label)) {
    return defect;
  }
  if (labels.find(label) != TokenTable::none) {
    return fmt::format("label {} is listed twice; remove or correct one", shown(label));
  }
  if (labels.size() == max_elements_in_memory) {
    return label_count_defect(labels.size() + 1, {});
  }
  labels.add(label);
  return std::nullopt;
}

Declared merged(const std::string& name, const ReadOptions& caller, const ReadOptions& file) {
  const auto require = [&](std::string_view key, const auto& value, std::uint64_t least,
                           std::uint64_t most) {
    if (value && (*value < least || *value > most)) {
      throw BadOption(fmt::format("{}: {} = {} is out of range; give a whole number from {} to {}",
                                  name, key, *value, least, most));
    }
  };
  require("v", caller.v, 1, max_elements_in_memory);
  require("k", caller.k, 1, max_elements_in_memory);
  require("change", caller.change, 1, max_elements_in_memory);
  require("strength", caller.strength, 2, max_strength);
  const auto refuse_other = [&](std::string_view key, const auto& asked, const auto& said) {
    if (caller.no_other && asked && said && *asked != *said) {
      throw BadInput(fmt::format("{}: the file says {} = {}, not {}; give one for {} = {}", name,
                                 key, *said, *asked, key, *asked));
    }
  };
  refuse_other("v", caller.v, file.v);
  refuse_other("k", caller.k, file.k);
  refuse_other("change", caller.change, file.change);
  refuse_other("strength", caller.strength, file.strength);
  Declared both{caller, caller};
  const auto take = [](auto& into, const auto& from) {
    if (!into) {
      into = from;
    }
  };
  take(both.v, file.v);
  take(both.k, file.k);
  take(both.change, file.change);
  take(both.kind, file.kind);
  take(both.strength, file.strength);
  return both;
}

Parameters completed(const std::string& name, Place place, const Declared& declared,
                     std::uint64_t v, std::uint64_t k, std::uint64_t first_change) {
  Parameters p{.v = v, .k = k};
  p.change =
      declared.change.value_or(first_change != 0 ? first_change : std::min<std::uint64_t>(2, k));
  p.kind = declared.kind.value_or(Kind::linear);
  p.strength = declared.strength.value_or(2);
  try {
    check(p);
  } catch (const ImpossibleParameters& fault) {
    const ReadOptions& caller = declared.by_caller;
    const bool callers = p.k > p.v        ? caller.v.has_value()
                         : p.change > p.k ? caller.change.has_value()
                                          : caller.strength.has_value();
    if (callers) {
      throw BadOption(fmt::format("{}: {}", name, fault.what()));
    }
    fail(name, place, fault.what());
  }
  return p;
}

std::optional<std::string> label_count_defect(std::size_t labels, const ReadOptions& declared) {
  if (labels > max_elements_in_memory) {
    return fmt::format("more than {} labels; use fewer elements", max_elements_in_memory);
  }
  if (labels == 0) {
    return "no labels; list one for each element, or leave the list out";
  }
  if (declared.v && *declared.v != labels) {
    return fmt::format("{} for v = {} elements; give one each", count_of(labels, "label"),
                       *declared.v);
  }
  return std::nullopt;
}

std::optional<std::string> table_defect(std::string_view beginning) {
  // The names of the blocks come first, or below the lines above the table.
  constexpr std::size_t most_lines = 12;
  const std::vector<std::string_view> lines = first_lines(beginning, most_lines);
  if (lines.empty() || has_header(beginning)) {
    return std::nullopt;
  }
  const std::vector<std::string_view> words = words_of(lines[0]);
  const bool command = words[0][0] == '\\' && words[0].find('{') != std::string_view::npos;
  if (command || std::ranges::find(words, "&") != words.end()) {
    return "this looks like LaTeX, a table for people; write it with --format text or --json";
  }
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const std::vector<std::string_view> names = words_of(lines[i]);
    if ((names[0] == "B1" || names[0] == "B0" || names[0] == "B0,0") &&
        std::ranges::all_of(names, is_block_name)) {
      const std::vector<std::string_view> below = words_of(lines[i + 1]);
      if (std::ranges::none_of(below, is_block_name)) {
        return "this looks like a table for people; write it with --format text or --json";
      }
    }
  }
  return std::nullopt;
}

namespace {

// "(A" and "B}" are parts of a set; "A(1)" and "f[0]" are names.
bool is_part_of_a_set(std::string_view word) {
  constexpr std::string_view opening = "([{";
  constexpr std::string_view closing = ")]}";
  std::vector<char> open;
  for (const char c : word) {
    if (opening.find(c) != std::string_view::npos) {
      open.push_back(closing[opening.find(c)]);
    } else if (closing.find(c) != std::string_view::npos) {
      if (open.empty() || open.back() != c) {
        return true;
      }
      open.pop_back();
    }
  }
  return !open.empty() || opening.find(word.front()) != std::string_view::npos;
}

}  // namespace

std::optional<std::string> loose_word_defect(std::string_view word, bool is_first) {
  constexpr std::array<std::string_view, 4> comments = {"%", "//", "--", "/*"};
  constexpr std::array<std::string_view, 8> signs = {"=", ":=",   ":",     "...",
                                                     "…", "gap>", "sage:", ">>>"};
  if (word.empty()) {
    return std::nullopt;
  }
  if (is_part_of_a_set(word)) {
    return fmt::format(
        "{} has a bracket; write every block as {{A,B,C}}, or list all names in a line '# labels: "
        "…'",
        shown(word));
  }
  if (std::ranges::find(comments, word) != comments.end()) {
    return fmt::format("{} is not an element; begin a comment with #", shown(word));
  }
  if (std::ranges::find(signs, word) != signs.end()) {
    return fmt::format("{} is not an element; write every block as {{A,B,C}}", shown(word));
  }
  const bool numbered =
      (word.back() == '.' || word.back() == ')') && plain_number(word.substr(0, word.size() - 1));
  if (is_first && word.size() > 1 && (word.back() == ':' || numbered)) {
    return fmt::format("{} looks like the name of the block; leave it out", shown(word));
  }
  return std::nullopt;
}

bool only_numbers(std::string_view beginning) {
  while (!beginning.empty()) {
    const std::string_view line = beginning.substr(0, beginning.find('\n'));
    for (const std::string_view word : words_of(line.substr(0, line.find('#')))) {
      if (!plain_number(word)) {
        return false;
      }
    }
    beginning.remove_prefix(std::min(line.size() + 1, beginning.size()));
  }
  return true;
}

std::string size_defect(std::uint64_t number, std::uint64_t size, std::uint64_t k, bool declared) {
  if (declared) {
    return fmt::format("block {} has {}, not k = {}; correct it, or k", number,
                       count_of(size, "element"), k);
  }
  return fmt::format("block {} has {}, the blocks before have {}; correct one of them", number,
                     count_of(size, "element"), k);
}

std::string surplus_defect(std::uint64_t number, std::uint64_t k, bool declared) {
  if (declared) {
    return fmt::format("block {} has more than k = {} elements; correct it, or k", number, k);
  }
  if (number == 1) {
    return fmt::format("more than {} in a block; end each block with a line end",
                       count_of(k, "element"));
  }
  return fmt::format("block {} has more than the {} of the blocks before; correct one of them",
                     number, count_of(k, "element"));
}

std::string repeat_defect(std::uint64_t number, std::string_view word) {
  return fmt::format("element {} is twice in block {}; remove or correct one", shown(word), number);
}

std::string above_v_defect(std::string_view word, std::uint64_t v) {
  return fmt::format("element {} is not below v = {}; count from 0, or leave v out", shown(word),
                     v);
}

std::string unknown_label_defect(std::string_view word) {
  return fmt::format("element {} is not in the list of labels; correct one of them", shown(word));
}

std::string too_many_defect(std::string_view word, std::optional<std::uint64_t> v) {
  if (v) {
    return fmt::format("element {} is one too many for v = {}; correct it, or v", shown(word), *v);
  }
  return fmt::format("element {} is one too many: at most {} can be read; use fewer", shown(word),
                     max_elements_in_memory);
}

namespace {

bool is_quoted(std::string_view word) { return word.starts_with('"'); }

std::string_view unquoted(std::string_view word) { return is_quoted(word) ? word.substr(1) : word; }

}  // namespace

std::optional<std::string> Collector::add(std::string_view word) {
  Element element = table_.find(word);
  if (element == TokenTable::none) {
    if (auto defect = word_defect(unquoted(word))) {
      return defect;
    }
    // Twice the limit: "3" and 3 may turn out to be the same.
    if (table_.size() == 2 * max_elements_in_memory) {
      return too_many_defect(unquoted(word), std::nullopt);
    }
    element = table_.add(word);
  }
  if (block_size() == (k_ != 0 ? k_ : max_elements_in_memory)) {
    return surplus_defect(blocks_ + 1, block_size(), false);
  }
  elements_.push_back(element);
  return std::nullopt;
}

std::optional<std::string> Collector::end_block() {
  const std::size_t size = block_size();
  if (size == 0) {
    return fmt::format("block {} is empty; remove it", blocks_ + 1);
  }
  if (k_ == 0) {
    k_ = size;
  } else if (size != k_) {
    return size_defect(blocks_ + 1, size, k_, false);
  }
  ++blocks_;
  block_start_ = elements_.size();
  return std::nullopt;
}

// Decides whether the words are numbers or names, and replaces them by elements.
void Collector::settle(const Context& context) {
  const std::vector<std::string>& words = table_.words();
  const auto fail_at_word = [&](std::size_t which, const std::string& what) {
    const auto first = std::ranges::find(elements_, static_cast<Element>(which));
    fail(context.name, context.place_of_word(static_cast<std::uint64_t>(first - elements_.begin())),
         what);
  };
  std::vector<Element> element_of(words.size());
  const bool numbers = std::ranges::all_of(
      words, [](const std::string& word) { return plain_number(unquoted(word)).has_value(); });
  if (context.labels || (context.declared.v && numbers && !context.named)) {
    TokenTable known;
    if (context.labels) {
      if (const auto defect = label_count_defect(context.labels->size(), context.declared)) {
        fail(context.name, context.labels_place, *defect);
      }
      for (const std::string& label : *context.labels) {
        known.add(label);
      }
      labels_ = *context.labels;
    }
    v_ = context.labels ? context.labels->size() : *context.declared.v;
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (context.labels && is_quoted(words[i])) {
        element_of[i] = known.find(unquoted(words[i]));
        if (element_of[i] == TokenTable::none) {
          fail_at_word(i, unknown_label_defect(unquoted(words[i])));
        }
        continue;
      }
      const auto number = plain_number(unquoted(words[i]));
      if (!number) {
        fail_at_word(i, unknown_label_defect(words[i]));
      }
      if (*number >= v_) {
        fail_at_word(i, above_v_defect(unquoted(words[i]), v_));
      }
      element_of[i] = static_cast<Element>(*number);
    }
  } else {
    TokenTable names;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string_view word = unquoted(words[i]);
      element_of[i] = names.find(word);
      if (element_of[i] != TokenTable::none) {
        continue;
      }
      if (names.size() == context.declared.v.value_or(max_elements_in_memory)) {
        fail_at_word(i, too_many_defect(word, context.declared.v));
      }
      element_of[i] = names.add(word);
    }
    if (context.declared.v) {
      v_ = *context.declared.v;
      labels_ = names.words();
      fill_labels(labels_, v_);
    } else {
      ElementSet set = element_set(names.words());
      v_ = set.element_of.size();
      labels_ = std::move(set.labels);
      for (Element& element : element_of) {
        element = set.element_of[element];
      }
    }
  }
  for (Element& element : elements_) {
    element = element_of[element];
  }
}

void Collector::refuse_repeats(const Context& context) const {
  std::vector<std::uint64_t> seen(static_cast<std::size_t>(v_), 0);
  for (std::size_t at = 0; at < elements_.size(); ++at) {
    const Element x = elements_[at];
    const std::uint64_t block = at / k_ + 1;
    if (seen[x] == block) {
      fail(context.name, context.place_of_word(at),
           repeat_defect(block, labels_.empty() ? fmt::to_string(x) : labels_[x]));
    }
    seen[x] = block;
  }
}

Design Collector::finish(const Context& context) {
  if (blocks_ == 0) {
    fail(context.name, context.place, "no blocks; give at least one");
  }
  if (context.declared.k && *context.declared.k != k_) {
    fail(context.name, context.place_of_word(0), size_defect(1, k_, *context.declared.k, true));
  }
  settle(context);
  refuse_repeats(context);
  const std::span<const Element> all(elements_);
  const std::uint64_t first_change =
      blocks_ < 2 ? 0 : difference(all.first(k_), all.subspan(k_, k_)).size();
  Design design(completed(context.name, context.place, context.declared, v_, k_, first_change));
  design.set_labels(labels_);
  design.reserve(blocks_);
  for (std::uint64_t i = 0; i < blocks_; ++i) {
    design.append(all.subspan(i * k_, k_));
  }
  return design;
}

}  // namespace changeover
