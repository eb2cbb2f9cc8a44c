// The sweep of a single-change expansion.
//
// Between U ∪ {a} and U ∪ {b} a list Y = y₁, …, y_N has to meet itself, and all of U. One element
// enters and one leaves at each step, so what enters and what leaves says everything.
//
//   N ≤ k      y₁, …, y_N enter, from the second on in the place of u₁, …, u_{N−1}; then u₁, u₂, …
//              return in that order in the places of y₁, y₂, …. All of Y stands together in the
//              middle. For j < i, y_i leaves after u_j returned, and for j ≥ i it entered before
//              u_j left: so every y_i meets every u_j. 2N − 1 blocks, which is least if each y
//              enters once: all N lie together at some time, so N − 1 of U left and N − 1 return.
//   k < N < 2k  Hold: y₁, …, y_k enter; y_{k+1}, …, y_N follow in the place of one another; then
//              y_k, …, y_{N−1} enter again in the places of y_{k−1}, y_{k−2}, …. Those from y_k on
//              now stand together, and each met y₁, …, y_{k−1} before. U returns, y₁, …, y_q, q =
//              2k−1−N, leaving last, so these q meet all of U; the other N − q are streamed, U ∪
//              {y}. 4N − 2k blocks.
//              Slide: y₁, …, y_N and again y₁, …, y_{N−k} enter, the one that is in longest
//              leaving: each block holds k consecutive ones of the circle Y, so all pairs meet, N <
//              2k. U returns; y₁, …, y_{N−k} meet all of it as for N ≤ k; the other k are streamed.
//              2N + k − 1 blocks.
//   N ≥ 2k     Rounds: y₁, …, y_k enter; the others follow in the place of one another, k − 1 being
//              held. The r = N − k + 1 from y_k on do the same, as all the others have met
//              everything: the one that entered last and k − 2 more are held, in the places of
//              those held before. So on until at most k are left, which come together. A round
//              takes r − 1 steps. U returns, and all are streamed, but the first and the last one,
//              which have stood with all of U.
//
// Every list begins with U ∪ {y₁}. If a is left out elsewhere it is made y₁: the block before the
// sweep is then that block already, and a itself need not be streamed.
//
// For m = 2 the same with pairs of elements for elements, ⌊k/2⌋ for k, and, if k is odd, one
// element of U that stays all the time.
#include <algorithm>
#include <numeric>
#include <utility>

#include "construct/expansion/partial_expansion_parts.hpp"

namespace changeover {
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
      rounds(list);
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
    *std::ranges::find(block_, leaves) = enters;
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

  void rounds(const Block& list) {
    rise(list);
    Block in = part(list, 0, k_);  // the block, the one that entered last at its end
    const auto enter = [&](Element x, std::size_t place) {
      step(x, in[place]);
      in.erase(in.begin() + static_cast<std::ptrdiff_t>(place));
      in.push_back(x);
    };
    for (std::size_t i = k_; i < list.size(); ++i) {
      enter(list[i], k_ - 1);
    }
    for (Block left = part(list, k_ - 1, list.size()); left.size() > 1;) {
      // The last of `left` is in, at the end; the others of the block have met everything.
      const std::size_t held = std::min(left.size() - 1, k_ - 1);
      for (std::size_t i = 0; i < held; ++i) {
        enter(left[i], 0);
      }
      for (std::size_t i = held; i + 1 < left.size(); ++i) {
        enter(left[i], k_ - 1);
      }
      left = left.size() > k_ ? part(left, k_ - 2, left.size() - (k_ - 1)) : Block{};
    }
    fall(in);
    for (std::size_t i = 1; i < list.size(); ++i) {
      if (list[i] != in.back()) {
        stream(list[i]);
      }
    }
  }

  const Block& kept_;
  std::size_t k_;
  std::optional<Element> tail_;
  Block block_;
  std::vector<Element> out_;
};

}  // namespace

std::vector<Element> sweep(const Block& kept, std::optional<Element> left_out, const Block& added) {
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
  std::uint64_t length = 2 * count + k - 3 - less;
  for (std::uint64_t left = count; left > k;) {
    left -= k - 1;
    length += left - 1;
  }
  return length;
}

std::vector<Element> double_sweep(const Block& kept, const Block& added) {
  const std::size_t old_pairs = kept.size() / 2;
  Block old_numbers(old_pairs);
  std::iota(old_numbers.begin(), old_numbers.end(), Element{0});
  Block new_numbers(added.size() / 2);
  std::iota(new_numbers.begin(), new_numbers.end(), static_cast<Element>(old_pairs));
  const std::vector<Element> numbers = sweep(old_numbers, std::nullopt, new_numbers);
  std::vector<Element> result;
  result.reserve(numbers.size() / (old_pairs + 1) * (kept.size() + 2));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_old = numbers[i] < old_pairs;
    const auto first = 2 * (is_old ? numbers[i] : numbers[i] - old_pairs);
    const Block& from = is_old ? kept : added;
    result.push_back(from[first]);
    result.push_back(from[first + 1]);
    if ((i + 1) % (old_pairs + 1) == 0 && kept.size() % 2 != 0) {
      result.push_back(kept.back());
    }
  }
  return result;
}

}  // namespace changeover
