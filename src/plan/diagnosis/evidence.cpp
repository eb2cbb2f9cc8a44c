#include "plan/diagnosis/evidence.hpp"

#include <algorithm>
#include <set>

#include "changeover/core/error.hpp"
#include "changeover/run/control.hpp"

namespace changeover {
namespace {

constexpr std::size_t bits_of_word = 64;

// Checks and sorts a tested set-up.
Block tested_setup(const Job& job, Block setup) {
  // It may come from a bench with more room.
  if (setup.empty()) {
    throw BadInput("a test that was done has no parts; name the parts of its set-up");
  }
  std::ranges::sort(setup);
  if (setup.back() >= job.parts() || std::ranges::adjacent_find(setup) != setup.end()) {
    throw BadInput("a test that was done has a repeated or unknown part; name each part once");
  }
  return setup;
}

bool has(const Block& setup, Element x) { return std::ranges::binary_search(setup, x); }

// Whether no two parts are enough to have one in each of some sets.
bool needs_three(const std::vector<Block>& sets) {
  if (sets.size() < 3) {
    return false;
  }
  for (const Element one : sets.front()) {
    const auto open = std::ranges::find_if(sets, [&](const Block& set) { return !has(set, one); });
    if (open == sets.end()) {
      return false;
    }
    for (const Element other : *open) {
      if (std::ranges::all_of(sets,
                              [&](const Block& set) { return has(set, one) || has(set, other); })) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

bool has_all_of(const Block& setup, const Suspect& suspect) {
  return has(setup, suspect.one) && (!suspect.other || has(setup, *suspect.other));
}

Evidence::Evidence(const Job& job, const std::vector<TestedSetup>& tests)
    : job_(&job), met_(job.parts(), false) {
  std::vector<Block> bad;
  for (const TestedSetup& test : tests) {
    stop_if_asked();
    Block setup = tested_setup(job, test.setup);
    if (test.failed) {
      bad.push_back(std::move(setup));
    } else {
      met_.add(job, setup);
      good_.push_back(std::move(setup));
    }
  }
  passed_ = good_.size();
  all_failed_ = bad.size();
  for (Block& setup : bad) {
    stop_if_asked();
    std::vector<Suspect> suspects = suspects_among(setup);
    if (suspects.empty()) {
      inexplicable_.push_back(std::move(setup));
    } else {
      failures_.push_back(std::move(setup));
      suspects_.push_back(std::move(suspects));
    }
  }
  words_ = (failures_.size() + bits_of_word - 1) / bits_of_word;
  with_.assign(job.names.size() * words_, 0);
  for (std::size_t i = 0; i < failures_.size(); ++i) {
    for (const Element x : failures_[i]) {
      with_[x * words_ + i / bits_of_word] |= std::uint64_t{1} << (i % bits_of_word);
    }
  }
}

std::vector<Suspect> Evidence::suspects_among(const Block& parts) const {
  std::vector<Suspect> suspects;
  const auto add = [&](const Suspect& suspect) {
    if (!is_cleared(suspect)) {
      suspects.push_back(suspect);
    }
  };
  for (const Element x : parts) {
    add({x, std::nullopt});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      add({std::min(parts[i], parts[j]), std::max(parts[i], parts[j])});
    }
  }
  return suspects;
}

FailedBits Evidence::all() const {
  FailedBits bits(words_, ~std::uint64_t{0});
  if (const std::size_t rest = failures_.size() % bits_of_word; rest != 0) {
    bits.back() = (std::uint64_t{1} << rest) - 1;
  }
  return bits;
}

FailedBits Evidence::hit_by(const Suspect& suspect) const {
  FailedBits bits(words_);
  const Element other = suspect.other.value_or(suspect.one);
  for (std::size_t w = 0; w < words_; ++w) {
    bits[w] = with_[suspect.one * words_ + w] & with_[other * words_ + w];
  }
  return bits;
}

std::vector<Suspect> Evidence::common(const FailedBits& tests) const {
  Block parts;
  for (Element x = 0; x < job_->parts(); ++x) {
    bool in_all = true;
    for (std::size_t w = 0; in_all && w < words_; ++w) {
      in_all = (tests[w] & ~with_[x * words_ + w]) == 0;
    }
    if (in_all) {
      parts.push_back(x);
    }
  }
  return suspects_among(parts);
}

std::vector<std::pair<Block, Block>> Evidence::contradictions(std::size_t most) const {
  std::vector<std::pair<Block, Block>> found;
  for (const Block& bad : inexplicable_) {
    if (found.size() == most) {
      break;
    }
    const auto all_of_it = std::ranges::find_if(
        good_, [&](const Block& good) { return std::ranges::includes(good, bad); });
    found.emplace_back(bad, all_of_it == good_.end() ? Block() : *all_of_it);
  }
  return found;
}

std::optional<Block> Evidence::companions(const std::vector<Suspect>& suspects, Element part) {
  Block others;
  bool has_part = false;
  for (const Suspect& each : suspects) {
    if (each.one != part && each.other != part) {
      return std::nullopt;
    }
    has_part = has_part || !each.other;
    if (each.other) {
      others.push_back(each.one == part ? *each.other : each.one);
    }
  }
  return has_part ? std::optional(others) : std::nullopt;
}

std::vector<Block> Evidence::companions_of(Element part) const {
  std::vector<Block> sets;
  for (const std::vector<Suspect>& suspects : suspects_) {
    if (suspects.front().one != part || suspects.front().other) {
      continue;  // parts come first
    }
    if (auto others = companions(suspects, part)) {
      sets.push_back(std::move(*others));
    }
  }
  return sets;
}

std::vector<Suspect> proven_faults(const Evidence& evidence) {
  std::set<Suspect> proven;
  std::set<Element> parts;
  for (const std::vector<Suspect>& suspects : evidence.suspects()) {
    if (suspects.size() == 1) {
      proven.insert(suspects.front());
    } else if (!suspects.front().other) {
      parts.insert(suspects.front().one);
    }
  }
  for (const Element part : parts) {
    if (needs_three(evidence.companions_of(part))) {
      proven.insert({part, std::nullopt});
    }
  }
  return {proven.begin(), proven.end()};
}

}  // namespace changeover
