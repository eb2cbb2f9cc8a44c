// Lists of pairs at random, written in every way: read as they were written; damaged, pairs or one
// line.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "changeover/loadorder/wanted_pairs.hpp"
#include "damage.hpp"
#include "io/scan/row_reader.hpp"

namespace changeover::test::read_pairs_property_test {
namespace {

using Pairs = std::set<std::pair<std::string, std::string>>;  // by name; the smaller name first

std::pair<std::string, std::string> in_order(std::string x, std::string y) {
  return std::minmax(std::move(x), std::move(y));
}

struct List {
  std::vector<std::string> items;  // as they first occur
  Pairs pairs;
  std::string text;
};

// A file in one of the ways in which people write them. Numbers, or names of which one at least is
// no number.
List some_list() {
  const bool named = some_number(1) == 1;
  std::vector<std::string> words;
  for (std::uint64_t i = 0; i < 8; ++i) {
    const std::string number = std::to_string(some_number(i < 4 ? 9 : 99));
    words.push_back(named && i % 3 != 1
                        ? *rc::gen::element<std::string>("x", "Pump-", "é", "漢", "-e", "a.",
                                                         "cam 0/", "a, b\"", "#", "%") +
                              std::to_string(i)
                        : number);
  }
  List list;
  const auto blank = [] {
    return *rc::gen::element<std::string>(" ", "\t", ",", ";", " , ", "  ");
  };
  const auto occurs = [&](const std::string& item) {
    if (std::ranges::find(list.items, item) == list.items.end()) {
      list.items.push_back(item);
    }
  };
  // Two names first: whatever comes then is read by the same rules.
  for (std::uint64_t count = 1 + some_number(10); count > 0; --count) {
    const bool first = list.pairs.empty() && named;
    const std::string x = first ? words[0] : *rc::gen::elementOf(words);
    const std::string y = first ? words[2] : *rc::gen::elementOf(words);
    list.text += *rc::gen::element<std::string>("", "", " ", "# 1 2\n", "\n", "% x\n") +
                 quoted_among_blanks(x) + blank() + quoted_among_blanks(y) +
                 *rc::gen::element<std::string>("\n", "\n", "\r\n", " \n");
    occurs(x);
    occurs(y);
    list.pairs.insert(in_order(x, y));
    if (first) {  // Words over numbers alone would be the names of columns.
      list.text += quoted_among_blanks(y) + " " + quoted_among_blanks(x) + "\n";
    }
  }
  return list;
}

std::string name_of(const PairGraph& graph, Element x) {
  return graph.names().empty() ? std::to_string(x) : graph.names()[x];
}

Pairs pairs_of(const PairGraph& graph) {
  Pairs pairs;
  for (Element x = 0; x < graph.items(); ++x) {
    for (const Element y : graph.partners(x)) {
      RC_ASSERT(y < graph.items());
      RC_ASSERT(graph.is_needed(x));
      RC_ASSERT(graph.place(x, y).has_value());
      pairs.insert(in_order(name_of(graph, x), name_of(graph, y)));
    }
    if (graph.is_needed(x) && graph.partners(x).empty()) {
      pairs.insert({name_of(graph, x), name_of(graph, x)});
    }
  }
  return pairs;
}

// Without those that say no more: an item alone that has partners, too.
Pairs without_needless(Pairs pairs) {
  std::set<std::string> met;
  for (const auto& [x, y] : pairs) {
    if (x != y) {
      met.insert({x, y});
    }
  }
  std::erase_if(pairs, [&](const auto& pair) {
    return pair.first == pair.second && met.contains(pair.first);
  });
  return pairs;
}

// A file of these pairs. A list with names begins with one of them, so that nothing is taken for a
// number before, and has it twice, so that it is no header.
std::string written(const Pairs& pairs) {
  std::string beginning;
  std::string rest;
  for (const auto& [x, y] : pairs) {
    const bool number = (x + y).find_first_not_of("0123456789") == std::string::npos &&
                        x.size() < 8 && y.size() < 8 && (x == "0" || x[0] != '0') &&
                        (y == "0" || y[0] != '0');
    (number ? rest : beginning) += quoted_among_blanks(x) + "\t" + quoted_among_blanks(y) + "\n";
  }
  return beginning + beginning + rest;
}

std::shared_ptr<const PairGraph> read(const std::string& text) {
  return read_pairs(*input_from_text(text, "f"),
                    {.items = 100});  // No more, or reading takes long.
}

RC_GTEST_PROP(PairListProperty, IsReadAsItWasWritten, ()) {
  const List list = some_list();
  RC_LOG() << list.text;
  const auto graph = read(list.text);
  RC_ASSERT(pairs_of(*graph) == without_needless(list.pairs));
  if (!graph->names().empty()) {
    RC_ASSERT(graph->names() == list.items);
  }
}

RC_GTEST_PROP(PairListProperty, DamagedItIsRefusedOrAList, (const std::vector<Damage>& damages)) {
  const std::string good = some_list().text;
  for (const Damage& damage : damages) {
    std::shared_ptr<const PairGraph> graph;
    if (!accepted("f:", [&] { graph = read(damage.of(good)); })) {
      continue;
    }
    RC_ASSERT(graph->items() <= 100);
    RC_ASSERT((graph->names().empty() || graph->names().size() == graph->items()));
    std::set<std::string> different(graph->names().begin(), graph->names().end());
    RC_ASSERT(different.size() == graph->names().size());
    const Pairs pairs = pairs_of(*graph);
    const auto again = read(written(pairs));
    RC_ASSERT(again->names().empty() == graph->names().empty());
    RC_ASSERT(pairs_of(*again) == pairs);
  }
}

}  // namespace
}  // namespace changeover::test::read_pairs_property_test
