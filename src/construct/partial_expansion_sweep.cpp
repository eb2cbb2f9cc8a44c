// The sweep of a single-change expansion.
//
// Between U ∪ {a} and U ∪ {b} a list Y = y₁, …, y_N has to meet itself, and all of U. One element enters
// and one leaves at each step, so what enters and what leaves says everything.
//
//   N ≤ k      y₁, …, y_N enter, from the second on in the place of u₁, …, u_{N−1}; then u₁, u₂, … return
//              in that order in the places of y₁, y₂, …. All of Y stands together in the middle. For
//              j < i, y_i leaves after u_j returned, and for j ≥ i it entered before u_j left: so every
//              y_i meets every u_j. 2N − 1 blocks, which is least if each y enters once: all N lie
//              together at some time, so N − 1 of U left and N − 1 return.
//   k < N < 2k  Hold: y₁, …, y_k enter; y_{k+1}, …, y_N follow in the place of one another; then y_k, …,
//              y_{N−1} enter again in the places of y_{k−1}, y_{k−2}, …. Those from y_k on now stand
//              together, and each met y₁, …, y_{k−1} before. U returns, y₁, …, y_q, q = 2k−1−N, leaving
//              last, so these q meet all of U; the other N − q are streamed, U ∪ {y}. 4N − 2k blocks.
//              Slide: y₁, …, y_N and again y₁, …, y_{N−k} enter, the one that is in longest leaving: each
//              block holds k consecutive ones of the circle Y, so all pairs meet, N < 2k. U returns;
//              y₁, …, y_{N−k} meet all of it as for N ≤ k; the other k are streamed. 2N + k − 1 blocks.
//   N ≥ 2k     Y is cut into groups of ⌊k/2⌋; every two of them make one list of the first sort.
//
// Every list begins with U ∪ {y₁} and ends with U ∪ {y} for some y, so lists can follow one another, a
// repeated block being left out. If a is left out elsewhere it is made y₁: the block before the sweep is
// then its first block already, and a itself need not be streamed.
#include <algorithm>
#include <numeric>

#include "construct/partial_expansion_parts.hpp"

namespace changeover::detail {
namespace {

bool hold_is_shorter(std::uint64_t count, std::uint64_t k) { return 2 * count < 3 * k; }

class Sweep {
 public:
  /// @param tail the element beside U in the block before, if that is of Y.
  Sweep(const Block& kept, std::optional<Element> tail)
      : kept_(kept), k_(kept.size() + 1), tail_(tail) {}

  void run(const Block& list) {
    if (list.size() <= k_) {
      gather(list);
    } else if (list.size() >= 2 * k_) {
      const std::size_t group = std::max<std::size_t>(k_ / 2, 1);
      for (std::size_t i = group; i < list.size(); i += group) {
        for (std::size_t j = 0; j < i; j += group) {
          Block two(part(list, j, group));
          const Block second = part(list, i, group);
          two.insert(two.end(), second.begin(), second.end());
          gather(two);
        }
      }
    } else if (hold_is_shorter(list.size(), k_)) {
      hold(list);
    } else {
      slide(list);
    }
  }

  std::vector<Element> take() { return std::move(out_); }

 private:
  static Block part(const Block& list, std::size_t from, std::size_t count) {
    const std::size_t end = std::min(list.size(), from + count);
    return {list.begin() + static_cast<std::ptrdiff_t>(from),
            list.begin() + static_cast<std::ptrdiff_t>(end)};
  }

  void emit() { out_.insert(out_.end(), block_.begin(), block_.end()); }

  // U ∪ {y}, unless that block was the last one.
  void stream(Element y) {
    block_ = kept_;
    block_.push_back(y);
    if (tail_ != y) {
      emit();
    }
    tail_ = y;
  }

  void step(Element enters, Element leaves) {
    *std::find(block_.begin(), block_.end(), leaves) = enters;
    emit();
  }

  // From U ∪ {y₁} to the block of y₁, …, y_k or of all of a shorter list and the end of U.
  void rise(const Block& list) {
    stream(list.front());
    for (std::size_t i = 1; i < std::min(list.size(), k_); ++i) {
      step(list[i], kept_[i - 1]);
    }
  }

  // U returns; `leaving` are the elements of Y in the order in which they go, the last one staying.
  void fall(const Block& leaving) {
    for (std::size_t i = 0; i + 1 < leaving.size(); ++i) {
      step(kept_[i], leaving[i]);
    }
    tail_ = leaving.back();
  }

  void gather(const Block& list) {
    rise(list);
    fall(list);
  }

  void hold(const Block& list) {
    const std::size_t count = list.size();
    const std::size_t last_kept = 2 * k_ - 1 - count;  // q
    rise(list);
    for (std::size_t i = k_; i < count; ++i) {
      step(list[i], list[i - 1]);
    }
    for (std::size_t i = 0; i < count - k_; ++i) {
      step(list[k_ - 1 + i], list[k_ - 2 - i]);
    }
    Block leaving = part(list, k_ - 1, count);
    const Block held = part(list, 0, last_kept);
    leaving.insert(leaving.end(), held.begin(), held.end());
    fall(leaving);
    for (std::size_t i = last_kept; i < count; ++i) {
      stream(list[i]);
    }
  }

  void slide(const Block& list) {
    const std::size_t count = list.size();
    rise(list);
    const auto at = [&](std::size_t i) { return list[i % count]; };
    const std::size_t entries = 2 * count - k_;
    for (std::size_t i = k_; i < entries; ++i) {
      step(at(i), at(i - k_));
    }
    Block leaving;
    for (std::size_t i = entries - k_; i < entries; ++i) {
      leaving.push_back(at(i));
    }
    fall(leaving);
    for (std::size_t i = count - k_; i < count; ++i) {
      stream(list[i]);
    }
  }

  const Block& kept_;
  std::size_t k_;
  std::optional<Element> tail_;
  Block block_;
  std::vector<Element> out_;
};

}  // namespace

std::vector<Element> sweep(const Block& kept, std::optional<Element> left_out,
                           const Block& added) {
  Block list;
  if (left_out) {
    list.push_back(*left_out);
  }
  list.insert(list.end(), added.begin(), added.end());
  Sweep blocks(kept, left_out);
  blocks.run(list);
  return blocks.take();
}

std::uint64_t sweep_length(std::uint64_t kept, std::uint64_t added, bool left_out) {
  const std::uint64_t k = kept + 1;
  const std::uint64_t less = left_out ? 1 : 0;
  const std::uint64_t count = added + less;
  if (count <= k) {
    return 2 * count - 1 - less;
  }
  if (count < 2 * k) {
    return (hold_is_shorter(count, k) ? 4 * count - 2 * k : 2 * count + k - 1) - less;
  }
  // The lists of two groups of ⌊k/2⌋, the last one of which may be smaller; the second list of two that
  // follow one another begins with another element than that with which the first one ends.
  const std::uint64_t group = std::max<std::uint64_t>(k / 2, 1);
  const std::uint64_t groups = (count + group - 1) / group;
  const std::uint64_t last = count - (groups - 1) * group;
  const std::uint64_t full = (groups - 1) * (groups - 2) / 2;
  return full * (4 * group - 1) + (groups - 1) * (2 * (group + last) - 1) - less;
}

}  // namespace changeover::detail
