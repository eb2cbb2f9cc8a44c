#include "plan/search/first_pieces.hpp"

#include <algorithm>
#include <utility>

namespace changeover {

RunPlan with_first_pieces(const Job& job, RunPlan plan) {
  if (job.piece_of.empty() || plan.candidates.empty()) {
    return plan;
  }
  std::vector<Block> pieces(job.names.size());  // by part, the first piece first
  for (Element x = 0; x < job.parts(); ++x) {
    pieces[job.piece_of[x]].push_back(x);
  }
  std::vector<Block> setups;
  for (const Block& setup : plan.candidates.front().setups) {
    std::vector<std::size_t> count(job.names.size(), 0);
    Block& renamed = setups.emplace_back();
    for (const Element x : setup) {
      const Element part = job.piece_of[x];
      renamed.push_back(pieces[part][count[part]++]);
    }
    std::ranges::sort(renamed);
  }
  RunSheet sheet = run_sheet(job, setups);
  if (!sheet.faults.empty() || sheet.cost > plan.sheet.cost ||
      sheet.pairs_tested < plan.sheet.pairs_tested ||
      sheet.triples_tested < plan.sheet.triples_tested) {
    return plan;
  }
  plan.candidates.front().setups = std::move(setups);
  plan.candidates.front().take_figures(sheet);
  plan.sheet = std::move(sheet);
  return plan;
}

}  // namespace changeover
