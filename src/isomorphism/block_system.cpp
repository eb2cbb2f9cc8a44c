#include "changeover/isomorphism/isomorphism.hpp"

#include <algorithm>
#include <utility>

#include "isomorphism/incidence_graph.hpp"

namespace changeover {

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
    std::sort(block.begin(), block.end());
  }
  std::sort(system.blocks.begin(), system.blocks.end());
  system.group_order = std::move(form.group_order);
  for (const auto& generator : form.generators) {
    system.generators.emplace_back(generator.begin(),
                                   generator.begin() + static_cast<std::ptrdiff_t>(v));
  }
  return system;
}

}  // namespace changeover
