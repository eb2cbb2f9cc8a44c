// Finds the smallest sets of suspects that explain all failed tests.
#include <algorithm>
#include <set>

#include "changeover/run/control.hpp"
#include "plan/diagnosis/evidence.hpp"

namespace changeover {
namespace {

constexpr std::uint64_t most_looked_at = 30'000;  // sets for which the last suspect is searched

bool is_empty(const FailedBits& bits) {
  return std::ranges::all_of(bits, [](std::uint64_t word) { return word == 0; });
}

FailedBits without(FailedBits bits, const FailedBits& others) {
  for (std::size_t w = 0; w < bits.size(); ++w) {
    bits[w] &= ~others[w];
  }
  return bits;
}

// Branches on the suspects of the unexplained test that has the fewest.
class Explainer {
 public:
  // Sets of `size` suspects besides the proven ones.
  Explainer(const Evidence& evidence, const std::vector<Suspect>& proven, std::uint64_t size)
      : evidence_(&evidence), proven_(&proven), size_(size) {}

  Explanations run(const FailedBits& open) {
    Explanation chosen;
    look(open, chosen);
    return {.size = proven_->size() + size_, .sets = {sets_.begin(), sets_.end()}, .all = all_};
  }

 private:
  void look(const FailedBits& open, Explanation& chosen) {
    if (!all_) {
      return;
    }
    if (chosen.size() + 1 == size_) {
      stop_if_asked();
      if (++looked_at_ > most_looked_at) {
        all_ = false;
        return;
      }
      for (const Suspect& last : evidence_->common(open)) {
        add(chosen, last);
      }
      return;
    }
    for (const Suspect& suspect : evidence_->suspects()[easiest(open)]) {
      FailedBits rest = without(open, evidence_->hit_by(suspect));
      if (is_empty(rest)) {
        continue;  // a smaller set is enough
      }
      chosen.push_back(suspect);
      look(rest, chosen);
      chosen.pop_back();
    }
  }

  void add(Explanation chosen, const Suspect& last) {
    if (size_ > 1 && sets_.size() == max_explanations) {
      all_ = false;
      return;
    }
    chosen.push_back(last);
    chosen.insert(chosen.end(), proven_->begin(), proven_->end());
    std::ranges::sort(chosen);
    sets_.insert(std::move(chosen));
  }

  [[nodiscard]] std::size_t easiest(const FailedBits& open) const {
    constexpr std::size_t bits_in_word = 64;
    const auto& suspects = evidence_->suspects();
    std::size_t best = suspects.size();
    for (std::size_t i = 0; i < suspects.size(); ++i) {
      const bool is_open = (open[i / bits_in_word] >> (i % bits_in_word) & 1U) != 0;
      if (is_open && (best == suspects.size() || suspects[i].size() < suspects[best].size())) {
        best = i;
      }
    }
    return best;
  }

  const Evidence* evidence_;
  const std::vector<Suspect>* proven_;
  std::uint64_t size_;
  std::set<Explanation> sets_;
  std::uint64_t looked_at_ = 0;
  bool all_ = true;
};

}  // namespace

Explanations explanations_of(const Evidence& evidence, const std::vector<Suspect>& proven) {
  if (evidence.failures().empty()) {
    return {};
  }
  FailedBits open = evidence.all();
  for (const Suspect& fault : proven) {
    open = without(std::move(open), evidence.hit_by(fault));
  }
  if (is_empty(open)) {
    return {.size = proven.size(), .sets = {proven}, .all = true};
  }
  std::uint64_t size = 1;
  for (; size <= max_faults; ++size) {
    Explanations found = Explainer(evidence, proven, size).run(open);
    if (!found.sets.empty()) {
      return found;
    }
    if (!found.all) {
      break;  // unknown whether this size is enough; smaller ones are not
    }
  }
  return {.size = proven.size() + size, .sets = {}, .all = size > max_faults};
}

}  // namespace changeover
