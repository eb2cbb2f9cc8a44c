// The processes that compute one job together: this one alone, or those that mpirun started.
//
//     const auto processes = Processes::of_launcher();
//     options.share = {processes->index(), processes->size()};
//     options.on_progress = [&](const auto&) { stop = processes->told_to_stop(); };
//     …
//     std::vector<Part> parts = processes->gather(part);        // everybody's, in order of index
//
// All calls are made by one thread. A process that cannot go on says so (give_up) and then takes
// part in gather() like all others: so everybody ends in good order, and one of them says why.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// What a process has done, or why it has not. Copied between processes byte by byte.
struct Part {
  int code = 0;                     ///< exit code
  std::array<char, 400> message{};  ///< one line, if code is not 0
  std::array<char, 300> note{};     ///< one line about the journal, or empty
  std::array<char, 200> job{};    ///< what was computed; the same everywhere, or something is wrong
  std::array<char, 16> access{};  ///< FileItems::access()
  std::uint64_t index = 0;        ///< of the process
  std::uint64_t steps = 0;        ///< of this process
  std::uint64_t steps_done = 0;   ///< of these, earlier ones included
  std::uint64_t steps_resumed = 0;  ///< by an earlier run
  std::uint64_t steps_lost = 0;     ///< recorded, but their results were not found again
  std::uint64_t loads = 0;
  std::uint64_t bytes_read = 0;
  std::uint64_t buffer_bytes = 0;
  double seconds = 0;
  double waited_seconds = 0;  ///< for loads
};

/// Text cut to what fits, with a 0 at the end.
template <std::size_t size>
void put(std::array<char, size>& place, std::string_view text) {
  place.fill('\0');
  text.substr(0, size - 1).copy(place.data(), size - 1);
}

class Processes {
 public:
  /// Those that a launcher of MPI started, if one did. @throws std::runtime_error if it did and
  /// this program was built without MPI.
  [[nodiscard]] static std::unique_ptr<Processes> of_launcher();

  virtual ~Processes() = default;
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  [[nodiscard]] virtual std::uint64_t index() const { return 0; }
  [[nodiscard]] virtual std::uint64_t size() const { return 1; }

  /// Asks the others to stop. Call it once at most, before gather().
  virtual void give_up() {}

  /// Whether another one has asked for that.
  [[nodiscard]] virtual bool told_to_stop() { return false; }

  /// Whether all are ready; waits until each has said whether it is. Every process calls it once,
  /// before gather().
  [[nodiscard]] virtual bool all_ready(bool ready) { return ready; }

  /// Everybody's part; waits for all, without keeping a core busy.
  [[nodiscard]] virtual std::vector<Part> gather(const Part& part) { return {part}; }

 protected:
  Processes() = default;
};
