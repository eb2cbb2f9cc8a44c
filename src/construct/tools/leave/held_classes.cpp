#include "construct/tools/leave/held_classes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "construct/entry.hpp"
#include "construct/tools/leave/held_lists.hpp"
#include "construct/tools/path.hpp"
#include "core/checked.hpp"

namespace changeover {
namespace {

// The cyclic list, and the held one without the ways over its seams.
class TwoLists {
 public:
  TwoLists(const Parameters& p, std::shared_ptr<const HeldClasses> classes)
      : k_(p.k),
        n_(p.k - p.change),
        classes_(std::move(classes)),
        held_(p.k, p.change, classes_->groups()),
        cyclic_(p.on(classes_->elements()).as(Kind::circular), 0, n_, classes_->base_blocks(),
                classes_->points()) {}

  /// The blocks of both, with the ways that circular designs take or linear ones.
  [[nodiscard]] std::uint64_t count(const Distances& distances, Kind kind) const {
    std::uint64_t b = checked_multiply(classes_->base_blocks(), classes_->elements());
    for (std::uint64_t i = 0; i < classes_->groups(); ++i) {
      b = checked_add(b, classes_->count(i));
    }
    b = checked_add(b, held_.size());
    Block here = last_cyclic();
    const auto go_to = [&](Block next) {
      const std::uint64_t distance = distance_between(here, next);
      b += distance == 0 ? 0 : *distances.steps(distance) - 1;
      here = std::move(next);
    };
    std::uint64_t group = 0;
    for (std::uint64_t i = 0; i <= held_.size(); ++i) {
      bool passed = false;
      while (group < classes_->groups() && held_.position(group) == i) {
        go_to(passing(group, 0));
        here = passing(group, classes_->count(group) - 1);
        passed = true;
        ++group;
      }
      if (i < held_.size() && (passed || i == 0 || held_.is_seam(i))) {
        go_to(short_block(i));
      } else if (i < held_.size()) {
        here = short_block(i);
      }
    }
    if (kind == Kind::circular) {
      go_to(first_cyclic());
    }
    return b;
  }

  bool next_cyclic(std::span<Element> block) { return cyclic_.next(block); }
  bool next_held(std::span<Element> block) {
    if (group_ < classes_->groups() && held_.position(group_) == made_) {
      write_passing(group_, set_, block);
      if (++set_ == classes_->count(group_)) {
        ++group_;
        set_ = 0;
      }
      return true;
    }
    if (made_ == held_.size()) {
      return false;
    }
    write_short(made_++, block);
    return true;
  }
  void rewind() {
    made_ = set_ = group_ = 0;
    cyclic_.rewind();
  }

  [[nodiscard]] Block first_cyclic() const { return cyclic_block(0, 0); }
  [[nodiscard]] Block last_cyclic() const {
    return cyclic_block(classes_->base_blocks() - 1, classes_->elements() - 1);
  }

 private:
  [[nodiscard]] Block passing(std::uint64_t group, std::uint64_t set) const {
    Block block(static_cast<std::size_t>(k_));
    write_passing(group, set, block);
    return block;
  }
  [[nodiscard]] Block short_block(std::uint64_t number) const {
    Block block(static_cast<std::size_t>(k_));
    write_short(number, block);
    return block;
  }
  [[nodiscard]] Block cyclic_block(std::uint64_t which, std::uint64_t shift) const {
    Block block(static_cast<std::size_t>(k_));
    std::iota(block.begin(), block.end(), 0);
    classes_->points()(which, std::span(block).subspan(static_cast<std::size_t>(n_)));
    for (Element& x : block) {
      x = static_cast<Element>((x + shift) % classes_->elements());
    }
    return block;
  }
  void write_passing(std::uint64_t group, std::uint64_t set, std::span<Element> block) const {
    const auto n = static_cast<std::size_t>(n_);
    std::iota(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(n),
              static_cast<Element>(classes_->elements() + group * n_));
    classes_->write(group, set, block.subspan(n));
  }
  // What stands for other elements becomes elements of Z_w; hardly ever are these in a set of the
  // block before or after it, and then a way leads there.
  void write_short(std::uint64_t number, std::span<Element> block) const {
    held_.write(number, block);
    const std::uint64_t w = classes_->elements();
    const std::uint64_t others = n_ * classes_->groups();
    for (Element& x : block) {
      x = static_cast<Element>(x < others ? x + w : w / 2 + (x - others));
    }
  }

  std::uint64_t k_, n_;
  std::shared_ptr<const HeldClasses> classes_;
  HeldList held_;
  IntervalDevelopedSource cyclic_;
  std::uint64_t made_ = 0;   // of the short list
  std::uint64_t group_ = 0;  // that passes next
  std::uint64_t set_ = 0;
};

// Both lists, and shortest ways to where a step would not change m elements.
class HeldClassesSource final : public BlockByBlock<HeldClassesSource> {
 public:
  HeldClassesSource(const Parameters& p, std::shared_ptr<const HeldClasses> classes)
      : parameters_(p),
        lists_(p, std::move(classes)),
        distances_(std::make_shared<const Distances>(p.k, p.change, p.v)),
        here_(lists_.last_cyclic()),
        next_(here_) {}

  [[nodiscard]] const Parameters& parameters() const override { return parameters_; }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return lists_.count(*distances_, parameters_.kind);
  }

  bool make(std::span<Element> block) {
    if (lists_.next_cyclic(block)) {
      return true;
    }
    if (!way_) {
      if (!ended_ && !lists_.next_held(next_)) {
        ended_ = true;
        next_ = lists_.first_cyclic();
      }
      if (ended_ && (parameters_.kind == Kind::linear || here_ == next_)) {
        return false;
      }
      if (distance_between(here_, next_) != parameters_.change) {
        way_.emplace(distances_, here_, next_);
      }
    }
    if (way_ && way_->next(block)) {
      return true;
    }
    way_.reset();
    here_ = next_;
    std::ranges::copy(next_, block.begin());
    return !ended_;
  }

  bool rewind() override {
    lists_.rewind();
    here_ = lists_.last_cyclic();
    way_.reset();
    ended_ = false;
    return true;
  }

 private:
  Parameters parameters_;
  TwoLists lists_;
  std::shared_ptr<const Distances> distances_;
  Block here_;
  Block next_;
  std::optional<Way> way_;
  bool ended_ = false;  // only the way back to the first block follows
};

}  // namespace

std::uint64_t held_classes_count(const Parameters& p, std::shared_ptr<const HeldClasses> classes) {
  return TwoLists(p, std::move(classes)).count(Distances(p.k, p.change, p.v), p.kind);
}

std::unique_ptr<BlockSource> held_classes_source(const Parameters& p,
                                                 std::shared_ptr<const HeldClasses> classes) {
  return std::make_unique<HeldClassesSource>(p, std::move(classes));
}

}  // namespace changeover
