#include "loadorder/shares/owners/pouring.hpp"

#include <algorithm>
#include <cmath>

#include "changeover/run/control.hpp"

namespace changeover {
namespace {

// Distributes one amount among its workers: they are filled to one level, and those above it get
// nothing.
double pour_one(Pouring& all, std::uint64_t at, std::vector<double>& others,
                std::vector<double>& sorted) {
  const std::uint64_t first = all.begin[at];
  const std::uint64_t end = all.begin[at + 1];
  others.clear();
  for (std::uint64_t p = first; p < end; ++p) {
    others.push_back(all.load[all.worker[p]] - all.portion[p]);
  }
  sorted = others;
  std::ranges::sort(sorted);
  double sum = all.amount[at];
  double height = 0;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    sum += sorted[k];
    height = sum / static_cast<double>(k + 1);
    if (k + 1 == sorted.size() || height <= sorted[k + 1]) {
      break;
    }
  }
  double moved = 0;
  for (std::uint64_t p = first; p < end; ++p) {
    const double to = std::max(0.0, height - others[p - first]);
    moved += std::abs(to - all.portion[p]);
    all.load[all.worker[p]] += to - all.portion[p];
    all.portion[p] = to;
  }
  return moved;
}

}  // namespace

void Pouring::pour(std::uint64_t workers, double part) {
  portion.assign(worker.size(), 0);
  load.assign(static_cast<std::size_t>(workers), 0);
  std::vector<std::uint64_t> shared;
  double total = 0;
  for (std::uint64_t at = 0; at < amount.size(); ++at) {
    const std::uint64_t count = begin[at + 1] - begin[at];
    for (std::uint64_t p = begin[at]; p < begin[at + 1]; ++p) {
      portion[p] = amount[at] / static_cast<double>(count);
      load[worker[p]] += portion[p];
    }
    if (count > 1 && amount[at] > 0) {
      shared.push_back(at);
    }
    total += amount[at];
  }
  constexpr std::uint64_t most_changes = 30'000'000;
  std::uint64_t changes = 0;
  std::vector<double> others;
  std::vector<double> sorted;
  while (!shared.empty() && changes < most_changes) {
    double moved = 0;
    for (const std::uint64_t at : shared) {
      moved += pour_one(*this, at, others, sorted);
      changes += begin[at + 1] - begin[at];
    }
    stop_if_asked();
    if (moved <= part * total / static_cast<double>(load.size())) {
      break;
    }
    // In the reverse order, an amount that was passed along a row of workers goes back the same
    // way.
    std::ranges::reverse(shared);
  }
}

}  // namespace changeover
