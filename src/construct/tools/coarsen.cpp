#include "construct/tools/coarsen.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <vector>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

constexpr std::size_t unset = std::numeric_limits<std::size_t>::max();

class Coarsening {
 public:
  Coarsening(const Design& design, std::uint64_t g)
      : design_(design),
        k_(static_cast<std::size_t>(design.k() + g - 1)),
        group_of_(static_cast<std::size_t>(design.v()), unset),
        comes_(static_cast<std::size_t>(design.v())),
        read_(static_cast<std::size_t>(design.v())) {
    std::vector<std::size_t> last(static_cast<std::size_t>(design.v()), unset);
    enters_.assign(design.block_count(), 0);
    for (std::size_t i = 0; i < design.block_count(); ++i) {
      for (const Element x : design.block(i)) {
        if (last[x] == unset || last[x] + 1 < i) {
          comes_[x].push_back(i);
          enters_[i] = x;  // of no use for the first block
        }
        last[x] = i;
      }
    }
  }

  // Puts the groups into `coarse`; false if one cannot be completed.
  bool run(std::size_t g, std::size_t first, Design& coarse) {
    const std::size_t b = design_.block_count();
    std::size_t size = first;
    Block block;
    for (std::size_t i = 0; i < b; size = g, ++group_) {
      stop_if_asked();
      if (group_ > 0 && before(enters_[i])) {
        return false;
      }
      block.clear();
      for (const Element x : design_.block(i)) {
        add(block, x);
      }
      std::size_t j = i + 1;
      while (j < b && j - i < size && !before(enters_[j]) && !inside(enters_[j])) {
        add(block, enters_[j++]);
      }
      // What enters next must be new to this group.
      while (j < b && inside(enters_[j]) && !holds(j - 1, enters_[j]) && j - i > 1) {
        --j;
        group_of_[block.back()] = unset;
        block.pop_back();
      }
      if (!fill(block, j)) {
        return false;
      }
      coarse.append(block);
      i = j;
    }
    return design_.parameters().kind == Kind::linear || closes(coarse, g);
  }

 private:
  // Whether the last group has g elements that the first lacks; the first as many that it lacks.
  [[nodiscard]] bool closes(const Design& coarse, std::size_t g) const {
    const auto in_first = [&](Element x) { return first_group_.contains(x); };
    return coarse.block_count() > 2 &&
           k_ - static_cast<std::size_t>(
                    std::ranges::count_if(coarse.block(coarse.block_count() - 1), in_first)) ==
               g;
  }
  // Whether nothing may be put into this group that the first one has.
  [[nodiscard]] bool meets_the_first(Element x, std::size_t j) const {
    return j >= enters_.size() && first_group_.contains(x);
  }

  [[nodiscard]] bool inside(Element x) const { return group_of_[x] == group_; }
  // Whether it was in the group before; it may be in this one as well.
  [[nodiscard]] bool before(Element x) const { return std::ranges::binary_search(previous_, x); }
  [[nodiscard]] bool holds(std::size_t i, Element x) const {
    const auto block = design_.block(i);
    return std::ranges::find(block, x) != block.end();
  }

  void add(Block& block, Element x) {
    if (!inside(x)) {
      group_of_[x] = group_;
      block.push_back(x);
    }
  }

  // Brings the block to k elements before block j begins the next group.
  bool fill(Block& block, std::size_t j) {
    const std::size_t lacking = k_ - block.size();
    if (lacking > 0) {
      std::vector<std::pair<std::size_t, Element>> free;
      for (Element x = 0; x < design_.v(); ++x) {
        if (!inside(x) && !before(x) && !meets_the_first(x, j) &&
            (j >= enters_.size() || x != enters_[j])) {
          free.emplace_back(next_coming(x, j), x);
        }
      }
      if (free.size() < lacking) {
        return false;
      }
      std::ranges::sort(free, [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
      });
      for (std::size_t n = 0; n < lacking; ++n) {
        add(block, free[n].second);
      }
    }
    if (group_ == 0 && design_.parameters().kind == Kind::circular) {
      first_group_.insert(block.begin(), block.end());
    }
    previous_ = block;
    std::ranges::sort(previous_);
    return true;
  }

  // When x enters next, from block j on; `unset` if it does not.
  std::size_t next_coming(Element x, std::size_t j) {
    std::size_t& read = read_[x];
    while (read < comes_[x].size() && comes_[x][read] < j) {
      ++read;
    }
    return read < comes_[x].size() ? comes_[x][read] : unset;
  }

  const Design& design_;
  std::size_t k_;
  std::size_t group_ = 0;
  std::vector<std::size_t> group_of_;            // by element: the last group that it was in
  std::vector<std::vector<std::size_t>> comes_;  // by element: the blocks in which it enters
  std::vector<std::size_t> read_;                // by element: of these
  std::vector<Element> enters_;                  // by block
  Block previous_;                               // the group before, sorted
  std::set<Element> first_group_;                // of a circular design
};

}  // namespace

std::optional<Design> coarsened(const Design& design, std::uint64_t g, std::uint64_t first) {
  Parameters p = design.parameters();
  if (p.change != 1 || g < 2 || first < 1 || first > g || p.k + g - 1 >= p.v) {
    return std::nullopt;
  }
  p.k += g - 1;
  p.change = g;
  Design coarse(p);
  if (!Coarsening(design, g).run(static_cast<std::size_t>(g), static_cast<std::size_t>(first),
                                 coarse)) {
    return std::nullopt;
  }
  return coarse;
}

}  // namespace changeover
