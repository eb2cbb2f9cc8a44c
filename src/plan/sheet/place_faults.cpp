// The independent check of the places of parts.
#include <fmt/format.h>

#include <map>
#include <set>

#include "plan/sheet/places.hpp"

namespace changeover {
namespace {

// The place of each part, by number.
using PlaceOfPart = std::map<Element, std::uint64_t>;

class PlaceCheck {
 public:
  PlaceCheck(const Job& job, const PlacedSheets& placed) : job_(&job), placed_(&placed) {
    std::set<std::uint64_t> seen;
    for (const MountedPlace& place : placed.places) {
      if (place.number == 0 || !seen.insert(place.number).second) {
        faults_.push_back(fmt::format("place {} is there twice", place.number));
      }
    }
  }

  // Checks that the parts of a set-up are mounted, each once and in a place of its slot.
  PlaceOfPart mounted(const std::string& where, const MountedParts& parts, const Block& setup) {
    PlaceOfPart places;
    if (parts.size() != placed_->places.size()) {
      faults_.push_back(where + " has another number of places");
      return places;
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (!parts[i]) {
        continue;
      }
      const MountedPlace& place = placed_->places[i];
      const std::string& name = job_->names.at(*parts[i]);
      if (!places.emplace(*parts[i], place.number).second) {
        faults_.push_back(fmt::format("{} has {} in two places", where, name));
      }
      if ((job_->slot_of.empty() ? no_slot : job_->slot_of[*parts[i]]) != place.slot) {
        faults_.push_back(
            fmt::format("{} has {} in a place of another slot, {}", where, name, place.number));
      }
    }
    std::set<Element> wanted(setup.begin(), setup.end());
    for (const auto& [part, place] : places) {
      if (wanted.erase(part) == 0) {
        faults_.push_back(
            fmt::format("{} has {} mounted, which is not of it", where, job_->names[part]));
      }
    }
    for (const Element part : wanted) {
      faults_.push_back(fmt::format("{} has {} in no place", where, job_->names[part]));
    }
    return places;
  }

  void stays(const std::string& where, const PlaceOfPart& before, const PlaceOfPart& now) {
    for (const auto& [part, place] : now) {
      const auto was = before.find(part);
      if (was != before.end() && was->second != place) {
        faults_.push_back(fmt::format("{} has {} in place {}, but it stayed in place {}", where,
                                      job_->names[part], place, was->second));
      }
    }
  }

  [[nodiscard]] std::vector<std::string> faults() const { return faults_; }

 private:
  const Job* job_;
  const PlacedSheets* placed_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> place_faults(const std::vector<ShownSheet>& sheets,
                                      const PlacedSheets& placed) {
  PlaceCheck check(*sheets.front().job, placed);
  for (std::size_t bench = 0; bench < sheets.size(); ++bench) {
    const Job& job = *sheets[bench].job;
    const std::vector<RunStep>& steps = sheets[bench].sheet->steps;
    const PlacedSheet& sheet = placed.sheets.at(bench);
    PlaceOfPart known;
    for (const MountedPlace& place : job.places) {
      if (place.part) {
        known.emplace(*place.part, place.number);
      }
    }
    PlaceOfPart before = check.mounted("what is mounted before", sheet.before, job.start);
    check.stays("what is mounted before", known, before);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string where = fmt::format("step {}", i + 1 + job.steps_before());
      PlaceOfPart now = check.mounted(where, sheet.steps.at(i), steps[i].setup);
      check.stays(where, before, now);
      before = std::move(now);
    }
  }
  return check.faults();
}

}  // namespace changeover
