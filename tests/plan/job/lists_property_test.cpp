// Lists that an experimenter writes, at random and in every way: read as they were written;
// damaged, lists or one line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "changeover/plan/job.hpp"
#include "damage.hpp"
#include "some_names.hpp"

namespace changeover::lists_property_test {
namespace {

using test::Damage;
using test::some_names;
using test::some_number;

using Fields = std::vector<std::string>;
using Rows = std::vector<Fields>;

// A field in quotes if it needs them, or by chance.
std::string field(const std::string& text) {
  const bool plain = !text.empty() && text.find_first_of(",;\t\"#") == std::string::npos &&
                     text.front() != ' ' && text.back() != ' ';
  if (text.empty() || (plain && some_number(2) > 0)) {
    return text;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string written(const Rows& rows) {
  const std::string separator = *rc::gen::element<std::string>(",", ";", "\t", " , ");
  std::string text;
  for (const Fields& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += (i == 0 ? "" : separator) + field(row[i]);
    }
    text += *rc::gen::element<std::string>("\n", "\r\n", "\n\n", "\n# a comment\n");
  }
  return text;
}

Amount some_amount() { return {some_number(3) * 1'000'000 + some_number(99) * 10'000}; }

// Every damage to a text: what is read of it, if it is not refused, is read again as it was from
// what `write` makes of it.
template <typename Read, typename Write>
void read_damaged(const std::string& good, const std::vector<Damage>& damages, Read&& read,
                  Write&& write) {
  for (const Damage& damage : damages) {
    const std::string bad = damage.of(good);
    std::optional<decltype(read(bad))> list;
    if (test::accepted("f:", [&] { list = read(bad); })) {
      const std::string again = write(*list);
      RC_LOG() << again << '\n';
      RC_ASSERT((read(again) == *list));
    }
  }
}

// ---- Parts --------------------------------------------------------------------------------------

struct Parts {
  Fields names;
  std::vector<std::optional<Amount>> costs;
  Fields slots;

  bool operator==(const Parts&) const = default;
};

Parts some_parts() {
  Parts parts{some_names(2 + some_number(6)), {}, {}};
  const bool slots = some_number(1) == 1;
  for (std::size_t i = 0; i < parts.names.size(); ++i) {
    parts.costs.push_back(some_number(3) == 0 ? std::nullopt : std::optional(some_amount()));
    if (slots) {
      parts.slots.push_back(some_number(2) == 0 ? "" : test::some_name());
    }
  }
  return parts;
}

std::string written(const Parts& parts) {
  Rows rows{{"part", "cost"}};
  if (!parts.slots.empty()) {
    rows.front().emplace_back("slot");
  }
  for (std::size_t i = 0; i < parts.names.size(); ++i) {
    rows.push_back({parts.names[i], parts.costs[i] ? to_string(*parts.costs[i]) : ""});
    if (!parts.slots.empty()) {
      rows.back().push_back(parts.slots[i]);
    }
  }
  return written(rows);
}

Parts read_parts_of(const std::string& text) {
  const PartList list = read_parts(*input_from_text(text, "f"));
  RC_ASSERT_FALSE(list.names.empty());
  RC_ASSERT(std::set<std::string>(list.names.begin(), list.names.end()).size() ==
            list.names.size());
  RC_ASSERT(list.change_costs.size() == list.names.size());
  RC_ASSERT((list.slots.empty() || list.slots.size() == list.names.size()));
  return {list.names, list.change_costs, list.slots};
}

RC_GTEST_PROP(ListsProperty, PartsAreReadAsTheyWereWritten, ()) {
  const Parts parts = some_parts();
  RC_ASSERT((read_parts_of(written(parts)) == parts));
}

RC_GTEST_PROP(ListsProperty, DamagedPartsAreRefusedOrParts, (const std::vector<Damage>& damages)) {
  read_damaged(written(some_parts()), damages, read_parts_of,
               [](const Parts& parts) { return written(parts); });
}

// ---- Pairs and what they are worth --------------------------------------------------------------

using Pairs = std::set<std::pair<Element, Element>>;

Pairs some_pairs(std::uint64_t v) {
  Pairs pairs;
  for (std::uint64_t count = 1 + some_number(8); count > 0; --count) {
    const auto x = static_cast<Element>(some_number(v - 1));
    const auto y = static_cast<Element>(some_number(v - 1));
    if (x != y) {
      pairs.insert(std::minmax(x, y));
    }
  }
  pairs.insert({0, 1});
  return pairs;
}

// By name or, where no name says something else, by number.
std::string word_for(Element x, const Fields& names) {
  const std::string number = std::to_string(x + 1);
  const bool is_name = std::ranges::find(names, number) != names.end();
  return is_name || some_number(3) > 0 ? names[x] : number;
}

Rows rows_of(const Pairs& pairs, const Fields& names) {
  Rows rows;
  for (const auto& [x, y] : pairs) {
    const bool turned = some_number(1) == 1;
    rows.push_back({word_for(turned ? y : x, names), word_for(turned ? x : y, names)});
  }
  return rows;
}

Pairs read_pairs_of(const std::string& text, const Fields& names) {
  Pairs pairs;
  const PairSet read = read_pairs(*input_from_text(text, "f"), names);
  read.for_each(10'000, [&](Element x, Element y) {
    RC_ASSERT(std::max(x, y) < names.size());
    RC_ASSERT(x != y);
    pairs.insert(std::minmax(x, y));
  });
  RC_ASSERT(read.size() == pairs.size());
  return pairs;
}

RC_GTEST_PROP(ListsProperty, PairsAreReadAsTheyWereWritten, ()) {
  const Fields names = some_names(2 + some_number(6));
  const Pairs pairs = some_pairs(names.size());
  RC_ASSERT(read_pairs_of(written(rows_of(pairs, names)), names) == pairs);
}

RC_GTEST_PROP(ListsProperty, DamagedPairsAreRefusedOrPairs, (const std::vector<Damage>& damages)) {
  const Fields names = some_names(2 + some_number(6));
  read_damaged(
      written(rows_of(some_pairs(names.size()), names)), damages,
      [&](const std::string& text) { return read_pairs_of(text, names); },
      [&](const Pairs& pairs) { return written(rows_of(pairs, names)); });
}

using Weights = std::map<std::pair<Element, Element>, Amount>;

Weights some_weights(std::uint64_t v) {
  Weights weights;
  for (const auto& pair : some_pairs(v)) {
    weights[pair] = some_amount();
  }
  return weights;
}

std::string written(const Weights& weights, const Fields& names) {
  Rows rows;
  for (const auto& [pair, weight] : weights) {
    rows.push_back({word_for(pair.first, names), word_for(pair.second, names), to_string(weight)});
  }
  return written(rows);
}

Weights read_weights(const std::string& text, const Fields& names) {
  const PairWeights read = read_priorities(*input_from_text(text, "f"), names);
  Weights weights;
  for (Element y = 0; y < names.size(); ++y) {
    for (Element x = 0; x < y; ++x) {
      if (read.weighs(x, y)) {
        weights[{x, y}] = read(x, y);
      }
    }
  }
  return weights;
}

RC_GTEST_PROP(ListsProperty, WeightsAreReadAsTheyWereWritten, ()) {
  const Fields names = some_names(2 + some_number(6));
  const Weights weights = some_weights(names.size());
  RC_ASSERT((read_weights(written(weights, names), names) == weights));
}

RC_GTEST_PROP(ListsProperty, DamagedWeightsAreRefusedOrWeights,
              (const std::vector<Damage>& damages)) {
  const Fields names = some_names(2 + some_number(6));
  read_damaged(
      written(some_weights(names.size()), names), damages,
      [&](const std::string& text) { return read_weights(text, names); },
      [&](const Weights& weights) { return written(weights, names); });
}

// ---- Costs by what is replaced ------------------------------------------------------------------

std::vector<Amount> some_costs(std::uint64_t v) {
  std::vector<Amount> costs(v * v);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    costs[i] = i % (v + 1) == 0 ? Amount{} : some_amount();
  }
  return costs;
}

// Rows and columns in their own order.
std::string written(const std::vector<Amount>& costs, const Fields& names) {
  const std::size_t v = names.size();
  const std::size_t turn = some_number(v - 1);
  Rows rows{{"out"}};
  for (std::size_t i = 0; i < v; ++i) {
    rows.front().push_back(names[(i + turn) % v]);
  }
  for (std::size_t out = v; out-- > 0;) {
    Fields& row = rows.emplace_back(Fields{names[out]});
    for (std::size_t i = 0; i < v; ++i) {
      const std::size_t in = (i + turn) % v;
      row.push_back(in == out ? "" : to_string(costs[out * v + in]));
    }
  }
  return written(rows);
}

RC_GTEST_PROP(ListsProperty, CostsAreReadAsTheyWereWritten, ()) {
  const Fields names = some_names(2 + some_number(3));
  const std::vector<Amount> costs = some_costs(names.size());
  RC_ASSERT((read_change_costs(*input_from_text(written(costs, names), "f"), names) == costs));
}

RC_GTEST_PROP(ListsProperty, DamagedCostsAreRefusedOrCosts, (const std::vector<Damage>& damages)) {
  const Fields names = some_names(2 + some_number(3));
  read_damaged(
      written(some_costs(names.size()), names), damages,
      [&](const std::string& text) {
        const auto costs = read_change_costs(*input_from_text(text, "f"), names);
        RC_ASSERT(costs.size() == names.size() * names.size());
        for (std::size_t x = 0; x < names.size(); ++x) {
          RC_ASSERT((costs[x * names.size() + x] == Amount{}));
        }
        return costs;
      },
      [&](const std::vector<Amount>& costs) { return written(costs, names); });
}

// ---- Slots --------------------------------------------------------------------------------------

using Slots = std::vector<std::tuple<std::string, std::uint64_t, std::uint64_t>>;

Slots as_tuples(const std::vector<Slot>& slots) {
  Slots tuples;
  for (const Slot& slot : slots) {
    RC_ASSERT_FALSE(slot.name.empty());
    RC_ASSERT(slot.least <= slot.most);
    tuples.emplace_back(slot.name, slot.least, slot.most);
  }
  return tuples;
}

Slots some_slots() {
  Slots slots;
  for (const std::string& name : some_names(1 + some_number(3))) {
    const std::uint64_t least = some_number(3);
    slots.emplace_back(name, least, some_number(2) == 0 ? Slot{}.most : least + some_number(2));
  }
  return slots;
}

std::string written(const Slots& slots) {
  Rows rows{{"slot", "least", "most"}};
  for (const auto& [name, least, most] : slots) {
    rows.push_back({name, std::to_string(least), most == Slot{}.most ? "" : std::to_string(most)});
  }
  return written(rows);
}

std::string on_one_line(const Slots& slots) {
  std::string text;
  for (const auto& [name, least, most] : slots) {
    text += (text.empty() ? "" : ", ") +
            field(name + "=" + std::to_string(least) +
                  (most == least ? "" : ".." + (most == Slot{}.most ? "" : std::to_string(most))));
  }
  return text;
}

RC_GTEST_PROP(ListsProperty, SlotsAreReadAsTheyWereWritten, ()) {
  const Slots slots = some_slots();
  RC_ASSERT((as_tuples(read_slots(*input_from_text(written(slots), "f"))) == slots));
  RC_ASSERT((as_tuples(parse_slots(on_one_line(slots))) == slots));
}

RC_GTEST_PROP(ListsProperty, DamagedSlotsAreRefusedOrSlots, (const std::vector<Damage>& damages)) {
  const Slots slots = some_slots();
  read_damaged(
      written(slots), damages,
      [](const std::string& text) { return as_tuples(read_slots(*input_from_text(text, "f"))); },
      [](const Slots& read) { return written(read); });
  const std::string line = on_one_line(slots);
  for (const Damage& damage : damages) {
    Slots read;
    if (test::accepted("", [&] { read = as_tuples(parse_slots(damage.of(line))); })) {
      RC_ASSERT((as_tuples(parse_slots(on_one_line(read))) == read));
    }
  }
}

}  // namespace
}  // namespace changeover::lists_property_test
