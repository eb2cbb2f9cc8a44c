#include "io/read/collector.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/design.hpp"

namespace changeover {
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
    const auto first = std::find(elements_.begin(), elements_.end(), static_cast<Element>(which));
    fail(context.name, context.place_of_word(static_cast<std::uint64_t>(first - elements_.begin())),
         what);
  };
  std::vector<Element> element_of(words.size());
  const bool numbers = std::all_of(words.begin(), words.end(), [](const std::string& word) {
    return plain_number(unquoted(word)).has_value();
  });
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

Design Collector::finish(const Context& context) {
  if (blocks_ == 0) {
    fail(context.name, context.place, "no blocks; give at least one");
  }
  if (context.declared.k && *context.declared.k != k_) {
    fail(context.name, context.place_of_word(0), size_defect(1, k_, *context.declared.k, true));
  }
  settle(context);
  const std::span<const Element> all(elements_);
  const std::uint64_t first_change =
      blocks_ < 2 ? 0 : difference(all.first(k_), all.subspan(k_, k_)).size();
  Design design(completed(context.name, context.place, context.declared, v_, k_, first_change));
  design.set_labels(labels_);
  design.reserve(blocks_);
  std::vector<std::uint64_t> seen(static_cast<std::size_t>(v_), 0);
  for (std::uint64_t i = 0; i < blocks_; ++i) {
    const std::span<const Element> block = all.subspan(i * k_, k_);
    for (std::size_t j = 0; j < k_; ++j) {
      if (seen[block[j]] == i + 1) {
        fail(context.name, context.place_of_word(i * k_ + j),
             repeat_defect(i + 1, design.label(block[j])));
      }
      seen[block[j]] = i + 1;
    }
    design.append(block);
  }
  return design;
}

}  // namespace changeover
