#include "catalog/store/spool.hpp"

#include "catalog/store/database.hpp"

namespace changeover {
namespace {

// Made first, for the statements need the table.
Database made() {
  Database database = Database::temporary();
  database.run(
      "CREATE TABLE entry(number INTEGER PRIMARY KEY, label TEXT NOT NULL UNIQUE, "
      "sha256 TEXT NOT NULL, line TEXT NOT NULL) STRICT; BEGIN");
  return database;
}

}  // namespace

struct Spool::State {
  Database database = made();
  Statement find = database.prepare("SELECT sha256 FROM entry WHERE label = ?");
  Statement put = database.prepare("INSERT INTO entry(label, sha256, line) VALUES(?, ?, ?)");
  Statement take =
      database.prepare("SELECT number, line FROM entry WHERE number > ? ORDER BY number LIMIT ?");
  std::uint64_t taken = 0;  // numbers are given from 1 on
  std::uint64_t count = 0;
};

Spool::Spool() : state_(std::make_unique<State>()) {}
Spool::~Spool() = default;

Spool::Put Spool::put(const CatalogEntry& entry) {
  const std::string label = entry.label();
  const std::string checksum = to_hex(entry.checksum);
  {
    const ResetLater later(state_->find);
    if (state_->find.with(std::string_view(label)).step()) {
      return state_->find.view(0) == checksum ? Put::there_already : Put::label_of_another;
    }
  }
  const std::string line = line_of(entry, {});
  state_->put.with(std::string_view(label), std::string_view(checksum), std::string_view(line))
      .step();
  ++state_->count;
  return Put::taken;
}

std::vector<CatalogEntry> Spool::take(std::size_t most) {
  std::vector<CatalogEntry> entries;
  const ResetLater later(state_->take);
  state_->take.with(state_->taken, std::uint64_t{most});
  while (state_->take.step()) {
    state_->taken = state_->take.integer(0);
    entries.push_back(
        entry_from_line(state_->take.view(1), state_->database.name(), state_->taken, {}));
  }
  return entries;
}

std::uint64_t Spool::waiting() const { return state_->count - state_->taken; }

}  // namespace changeover
