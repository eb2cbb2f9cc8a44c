#include "isomorphism/incidence_graph.hpp"

#include <bliss/graph.hh>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "changeover/core/error.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "isomorphism/least_form.hpp"

namespace changeover {
namespace {

struct ColouredGraph {
  std::vector<unsigned> colours;
  std::vector<std::pair<unsigned, unsigned>> edges;

  unsigned add(unsigned colour) {
    colours.push_back(colour);
    return static_cast<unsigned>(colours.size() - 1);
  }
};

constexpr unsigned element_colour = 0;
constexpr unsigned tail_colour = 1;
constexpr unsigned head_colour = 2;
constexpr unsigned first_block_colour = 3;

void add_blocks(const Design& design, BlockOrder order, ColouredGraph& graph) {
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    const unsigned vertex =
        graph.add(order == BlockOrder::sequence ? first_block_colour + static_cast<unsigned>(i)
                                                : first_block_colour);
    for (const Element x : design.block(i)) {
      graph.edges.emplace_back(x, vertex);
    }
  }
}

void add_collection(const Design& design, ColouredGraph& graph) {
  std::map<Block, unsigned> times;
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    Block block(design.block(i).begin(), design.block(i).end());
    std::ranges::sort(block);
    ++times[block];
  }
  for (const auto& [block, count] : times) {
    const unsigned vertex = graph.add(first_block_colour + count);
    for (const Element x : block) {
      graph.edges.emplace_back(x, vertex);
    }
  }
}

void add_arcs(const Design& design, BlockOrder order, ColouredGraph& graph) {
  const auto v = static_cast<unsigned>(design.v());
  const auto b = static_cast<unsigned>(design.block_count());
  const bool open = order == BlockOrder::reversible_sequence;
  for (unsigned i = 0; i + (open ? 1 : 0) < b; ++i) {
    const unsigned from = v + i;
    const unsigned to = v + (i + 1) % b;
    const unsigned tail = graph.add(tail_colour);
    const unsigned head = order == BlockOrder::circle ? graph.add(head_colour) : tail;
    graph.edges.emplace_back(from, tail);
    if (head != tail) {
      graph.edges.emplace_back(tail, head);
    }
    graph.edges.emplace_back(to, head);
  }
}

ColouredGraph coloured_graph(const Design& design, BlockOrder order) {
  ColouredGraph graph;
  graph.colours.assign(design.v(), element_colour);
  if (order == BlockOrder::collection) {
    add_collection(design, graph);
  } else {
    add_blocks(design, order, graph);
    if (order != BlockOrder::sequence) {
      add_arcs(design, order, graph);
    }
  }
  return graph;
}

// bliss tells the exact order of a group only by printing it.
std::string group_order(const bliss::Stats& stats) {
  char* text = nullptr;
  std::size_t length = 0;
  std::FILE* stream = open_memstream(&text, &length);
  if (stream == nullptr) {
    throw MissingResource("not enough memory for the order of a group; close other programs");
  }
  stats.print(stream);
  std::fclose(stream);
  const std::unique_ptr<char, decltype(&std::free)> owner(text, &std::free);
  std::string all(text, length);
  const std::size_t colon = all.rfind(':');
  const std::size_t begin = all.find_first_of("0123456789", colon);
  const std::size_t end = all.find_first_not_of("0123456789", begin);
  if (colon == std::string::npos || begin == std::string::npos) {
    throw InternalError("bliss did not print the order of a group");
  }
  return all.substr(begin, end - begin);
}

// The canonical label of each vertex. Since bliss 0.77 a function object is told the generators,
// before it was a function and what it is given.
template <typename Graph>
const unsigned* canonical_label(Graph& search, bliss::Stats& stats,
                                std::vector<std::vector<unsigned>>& generators) {
  auto keep = [&](unsigned n, const unsigned* map) { generators.emplace_back(map, map + n); };
  if constexpr (requires { search.canonical_form(stats, keep); }) {
    return search.canonical_form(stats, keep);
  } else {
    const auto hook = [](void* keeper, unsigned n, const unsigned* map) {
      (*static_cast<decltype(keep)*>(keeper))(n, map);
    };
    return search.canonical_form(stats, hook, &keep);
  }
}

}  // namespace

GraphForm graph_form(const Design& design, BlockOrder order) {
  constexpr std::uint64_t most = std::numeric_limits<std::int32_t>::max();
  if (design.v() + 3 * std::uint64_t{design.block_count()} >= most) {
    throw MissingResource(
        "the incidence graph would have more than 2^31 vertices; give a smaller design");
  }
  const ColouredGraph graph = coloured_graph(design, order);
  bliss::Graph search;
  search.set_component_recursion(false);  // With it, bliss 0.73 leaks memory.
  for (const unsigned colour : graph.colours) {
    search.add_vertex(colour);
  }
  for (const auto& [one, other] : graph.edges) {
    search.add_edge(one, other);
  }
  GraphForm form;
  bliss::Stats stats;
  const unsigned* label = canonical_label(search, stats, form.generators);
  form.label.assign(label, label + graph.colours.size());
  form.group_order = group_order(stats);
  for (std::size_t i = 0; i < graph.colours.size(); ++i) {
    form.colours.emplace_back(form.label[i], graph.colours[i]);
  }
  for (const auto& [one, other] : graph.edges) {
    form.edges.push_back(std::minmax({form.label[one], form.label[other]}));
  }
  std::ranges::sort(form.colours);
  std::ranges::sort(form.edges);
  return form;
}

BlockSystem block_system(const Design& design) {
  GraphForm form = graph_form(design, BlockOrder::collection);
  const std::size_t v = design.v();
  BlockSystem system;
  // Elements have the least colour, so their canonical places are 0, …, v−1.
  system.elements.assign(form.label.begin(), form.label.begin() + static_cast<std::ptrdiff_t>(v));
  for (std::size_t i = 0; i < design.block_count(); ++i) {
    Block& block = system.blocks.emplace_back();
    for (const Element x : design.block(i)) {
      block.push_back(system.elements[x]);
    }
    std::ranges::sort(block);
  }
  std::ranges::sort(system.blocks);
  system.group_order = std::move(form.group_order);
  for (const auto& generator : form.generators) {
    system.generators.emplace_back(generator.begin(),
                                   generator.begin() + static_cast<std::ptrdiff_t>(v));
  }
  return system;
}

namespace {

std::string group_order(const AutomorphismGroup& group) {
  Decimal order;
  // At most 2b position maps and v < 2³² elements: every factor fits.
  order.multiply(static_cast<std::uint32_t>(group.rotations));
  order.multiply(group.reflections ? 2 : 1);
  for (const auto& twins : group.twins) {
    for (std::size_t n = 2; n <= twins.size(); ++n) {
      order.multiply(static_cast<std::uint32_t>(n));
    }
  }
  return order.text();
}

}  // namespace

AutomorphismGroup automorphisms(const Design& design, const Sameness& same) {
  const std::size_t b = design.block_count();
  LeastForm least = least_form(design, same);
  AutomorphismGroup group;
  group.rotations = b == 0 ? 1 : b / least.step;
  group.reflections = least.mirror.has_value();
  group.twins = std::move(least.twins);
  group.order = group_order(group);

  for (const auto& twins : group.twins) {
    for (std::size_t i = 1; i < twins.size(); ++i) {
      Isomorphism exchange = identity(design.v());
      std::swap(exchange.elements[twins[i - 1]], exchange.elements[twins[i]]);
      group.generators.push_back(std::move(exchange));
    }
  }
  // Two readings with the same form: to the form by one of them, back by the other.
  StandardNames names(design);
  const auto add = [&](const Reading& reading) {
    names.read(reading);
    group.generators.push_back(compose(least.map, inverse(names.map(), b), b));
  };
  if (group.rotations > 1) {
    add({.start = least.reading.block(least.step, b), .backwards = least.reading.backwards});
  }
  if (least.mirror) {
    add(*least.mirror);
  }
  for (const Isomorphism& each : group.generators) {
    if (!carries(each, design, design)) {
      throw InternalError("a generator of a group is not a symmetry of its design");
    }
  }
  return group;
}

std::uint64_t standard_forms_in_class(const Design& design, const AutomorphismGroup& group,
                                      const Sameness& same) {
  const bool turns = design.parameters().kind == Kind::circular && same.rotation;
  const std::uint64_t b = std::max<std::uint64_t>(design.block_count(), 1);
  return (turns ? b : 1) * (same.reversal ? 2 : 1) / group.position_maps();
}

}  // namespace changeover
