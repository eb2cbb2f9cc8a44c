#include "plan/job/prices.hpp"

#include <algorithm>

#include "changeover/core/error.hpp"
#include "core/checked.hpp"

namespace changeover {
Job at_prices(const Job& job, Price price) {
  Job plain = job;
  plain.replace_costs.clear();
  if (!job.replaces()) {
    return plain;
  }
  for (Element in = 0; in < job.parts(); ++in) {
    Wide sum = 0;
    std::uint64_t rows = 0;
    Amount& own = plain.change_costs[in];
    for (Element out = 0; out < job.parts(); ++out) {
      const bool stays = std::ranges::find(job.mounted, out) != job.mounted.end();
      if (out == in || stays || !job.may_replace(out, in)) {
        continue;
      }
      const Amount cost = job.replace_cost(out, in);
      sum += cost.millionths;
      ++rows;
      own = price == Price::least ? std::min(own, cost) : own;
    }
    if (price == Price::mean && rows > 0) {
      own = Amount{static_cast<std::uint64_t>((sum + rows / 2) / rows)};
    }
  }
  return plain;
}

void refuse_replacing(const Job& job, const std::string& what) {
  if (job.replaces()) {
    throw BadInput(what +
                   " does not support change costs by what is replaced; leave one of them out");
  }
}

void refuse_triples(const Job& job, const std::string& what) {
  if (!job.triples.empty()) {
    throw BadInput(what + " does not support triples; leave one of them out");
  }
}

}  // namespace changeover
