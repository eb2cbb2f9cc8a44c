// The processes that search together: one, or those that mpirun started, on one machine or several.
//
//     Team& team = Team::world();
//     if (found) { team.announce(); }               // the others stop: heard() tells them
//     auto all = team.exchange(my_result);          // everybody's results, in order of index
//
// Without MPI, at build time or at run time, the team is this process alone and every call is
// trivial.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace changeover::cli {

class Team {
 public:
  /// The team of this process; joined at the first call if the environment says that mpirun started
  /// it.
  [[nodiscard]] static Team& world();

  virtual ~Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  [[nodiscard]] virtual std::uint64_t index() const = 0;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// The one that speaks to the user.
  [[nodiscard]] bool first() const { return index() == 0; }

  /// Tells the others that what all look for was found. Thread-safe.
  virtual void announce() = 0;
  /// Whether another member announced that, since the last exchange(). Thread-safe.
  [[nodiscard]] virtual bool heard() = 0;

  /// Every member gives a message and gets all of them, in order of index. All members must call it
  /// equally often; it waits for them.
  [[nodiscard]] virtual std::vector<std::string> exchange(const std::string& message) = 0;

  /// Leaves in good order if `code` is an answer that all members have; otherwise this one cannot
  /// go on, and all are ended. Call it once, last. Does nothing if world() was never called.
  static void leave(int code);

 protected:
  Team() = default;
  virtual void part() {}
  virtual void abandon(int) {}

 private:
  static bool joined;
};

}  // namespace changeover::cli
