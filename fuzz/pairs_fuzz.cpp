// Any bytes, read as a list of pairs; a load order for those of a small one is held to its referee.
#include <algorithm>
#include <chrono>
#include <functional>
#include <set>

#include "changeover/loadorder/load_order.hpp"
#include "changeover/loadorder/wanted_pairs.hpp"
#include "changeover/run/control.hpp"
#include "io/scan/row_reader.hpp"
#include "support/promises.hpp"

namespace changeover::fuzz::pairs_fuzz {
namespace {

constexpr std::uint64_t most_items_here = 16;

// Written as the reader writes whole numbers.
bool is_number(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos &&
         (word.size() == 1 || word.front() != '0');
}

std::string name_of(const PairGraph& graph, Element x) {
  return graph.names().empty() ? std::to_string(x) : graph.names()[x];
}

// Pairs as their items are called, which is what a file says.
std::set<std::pair<std::string, std::string>> pairs_by_name(const PairGraph& graph) {
  std::set<std::pair<std::string, std::string>> pairs;
  for (Element x = 0; x < graph.items(); ++x) {
    for (const Element y : graph.partners(x)) {
      pairs.emplace(name_of(graph, x), name_of(graph, y));
    }
    if (graph.is_needed(x)) {
      pairs.emplace(name_of(graph, x), name_of(graph, x));
    }
  }
  return pairs;
}

void order_of(const std::shared_ptr<const PairGraph>& graph) {
  const WantedPairs wanted = WantedPairs::listed(graph);
  // A search that ends by itself takes as long as thousands of other inputs.
  LoadOrderOptions options;
  options.search_pairs = [](const std::function<void()>& search) {
    RunControl control({.time = std::chrono::milliseconds(5)});
    const RunScope scope(control);
    search();
  };
  for (const std::uint64_t room : {2U, 3U, 7U}) {
    const LoadOrder order = plan_load_order(wanted, room, options);
    const auto steps = order.stream();
    const ScheduleVerdict verdict =
        check_schedule(*steps, {.items = graph->items(), .room = room, .wanted = wanted});
    must(verdict.valid() && verdict.loads == order.facts().loads,
         "a load order is one: " + verdict.fault + verdict.example);
    must(verdict.loads >= load_lower_bound(wanted, room).loads, "no order is below its bound");
  }
}

const Target target("pairs", [](const std::string& bytes) {
  std::shared_ptr<const PairGraph> graph;
  if (!accepts([&] { graph = read_pairs(*input_from_text(bytes)); })) {
    return;
  }
  if (graph->items() > 4000 || graph->pairs() > 4000) {
    return;
  }
  const auto pairs = pairs_by_name(*graph);
  // Names first: behind whole numbers a name like 01 would be refused.
  std::string text;
  std::string numbers;
  for (const auto& [x, y] : pairs) {
    (is_number(x) && is_number(y) ? numbers : text) +=
        quoted_among_blanks(x) + "\t" + quoted_among_blanks(y) + "\n";
  }
  text += text + numbers;  // twice, so that the first line is no header
  if (!text.empty()) {
    must(pairs_by_name(*read_pairs(*input_from_text(text))) == pairs, "pairs are read as written");
  }
  if (graph->items() <= most_items_here) {
    accepts([&] { order_of(graph); });
  }
});

}  // namespace
}  // namespace changeover::fuzz::pairs_fuzz
