// Three parts that must meet.
#include <fmt/format.h>

#include <algorithm>

#include "changeover/core/error.hpp"
#include "changeover/plan/job.hpp"
#include "changeover/run/control.hpp"
#include "plan/job/fitting.hpp"
#include "plan/job/setup_list.hpp"

namespace changeover {
namespace {

bool may_meet(const Job& job, const Fitting& fitting, const Triple& triple) {
  Block setup = with_mounted(job, {triple[0], triple[1], triple[2]});
  for (std::size_t i = 0; i < setup.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (job.never.contains(setup[i], setup[j])) {
        return false;
      }
    }
  }
  return setup.size() <= job.room() &&
         (!fitting.has_slots() || fitting.simplest(std::move(setup)).setup.has_value());
}

}  // namespace

std::uint64_t need_triples(Job& job) {
  if (job.parts() > max_parts_of_triples) {
    throw BadInput(
        fmt::format("there are {} parts; where triples must meet, at most {} are supported",
                    job.parts(), max_parts_of_triples));
  }
  const Fitting fitting(job);
  std::vector<Triple> triples;
  PairSet pairs(job.parts());
  std::uint64_t apart = 0;
  for (Element z = 2; z < job.parts(); ++z) {
    for (Element y = 1; y < z; ++y) {
      stop_if_asked();
      for (Element x = 0; x < y; ++x) {
        if (!may_meet(job, fitting, {x, y, z})) {
          ++apart;
          continue;
        }
        triples.push_back({x, y, z});
        pairs.insert(x, y);
        pairs.insert(x, z);
        pairs.insert(y, z);
      }
    }
  }
  job.triples = std::move(triples);
  job.needed = std::move(pairs);
  return apart;
}

void drop_met_triples(Job& job, const Meetings& meetings) {
  if (job.triples.empty()) {
    return;
  }
  std::erase_if(job.triples, [&](const Triple& t) { return meetings.met(t); });
  job.needed = PairSet(job.parts());
  for (const Triple& t : job.triples) {
    job.needed.insert(t[0], t[1]);
    job.needed.insert(t[0], t[2]);
    job.needed.insert(t[1], t[2]);
  }
}

}  // namespace changeover
