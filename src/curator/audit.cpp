#include "changeover/curator/curator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/core/sha256.hpp"
#include "changeover/run/control.hpp"
#include "construct/trusted_entry.hpp"
#include "core/words.hpp"
#include "run/threads.hpp"

namespace changeover {

AuditScope audit_scope(const Catalog& catalog, const CatalogFilter& filter) {
  AuditScope scope;
  for (const Catalog::Fault& fault : catalog.faults()) {
    scope.faults.push_back({fault.label, fault.what});
  }
  Sha256 hash;
  catalog.each(filter, [&](const CatalogEntry& entry) {
    scope.labels.push_back(entry.label());
    hash.add(line_of(entry, {}));
    return true;
  });
  scope.checksum = to_hex(hash.finish());
  return scope;
}

std::string fault_of_entry(const CatalogEntry& entry) {
  if (std::string defect = entry_defect(entry); !defect.empty()) {
    return defect;
  }
  const Bound bound = lower_bound(entry.parameters);
  if (bound.blocks > entry.b) {
    return fmt::format("it is valid with {}, fewer than the bound {}: {}",
                       count_of(entry.b, "block"), bound.blocks, bound.reason);
  }
  if (entry.lower_bound > bound.blocks) {
    return fmt::format("it claims the lower bound {}, but only {} is known: {}", entry.lower_bound,
                       bound.blocks, bound.reason);
  }
  return "";
}

Audit audit_entries(const Catalog& catalog, const AuditScope& scope, RunControl& control,
                    const std::set<std::string>& done,
                    const std::function<void(const std::string&)>& good) {
  Audit audit;
  audit.entries = scope.labels.size();
  audit.faults = scope.faults;
  std::vector<std::string> labels;
  std::ranges::copy_if(scope.labels, std::back_inserter(labels),
                       [&](const std::string& label) { return !done.contains(label); });
  std::mutex mutex;
  std::atomic<std::uint64_t> checked = 0;
  in_parallel(control, labels.size(), [&](std::size_t i) {
    if (control.stop_wanted()) {
      return;
    }
    const auto entry = catalog.find(labels[i]);
    const std::string fault = entry ? fault_of_entry(*entry) : "it was removed meanwhile";
    const std::uint64_t count = ++checked;
    {
      const std::lock_guard lock(mutex);
      if (!fault.empty()) {
        audit.faults.push_back({labels[i], fault});
      } else if (good) {
        good(labels[i]);
      }
    }
    if (control.progress_due()) {
      control.tell({.phase = "verifying " + count_of(labels.size(), "entry", "entries"),
                    .steps = count,
                    .unit = "entries"});
    }
  });
  audit.checked = checked;
  std::ranges::sort(audit.faults, {}, &Audit::Fault::label);
  return audit;
}

}  // namespace changeover
