#include "io/file/unfinished.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

#include "changeover/io/output.hpp"

namespace changeover {
namespace {

constexpr int free_slot = 0;
constexpr int claimed = 1;
constexpr int active = 2;
struct Slot {
  std::atomic<int> state = free_slot;
  std::array<char, PATH_MAX> path = {};
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads it");

// Static memory, never freed.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler needs it
std::array<Slot, 16> unfinished_slots;
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): a signal handler needs it
std::atomic_flag ending = ATOMIC_FLAG_INIT;

}  // namespace

int note_unfinished(const std::string& path) {
  if (path.size() >= PATH_MAX) {
    return -1;
  }
  for (std::size_t i = 0; i < unfinished_slots.size(); ++i) {
    int expected = free_slot;
    if (unfinished_slots[i].state.compare_exchange_strong(expected, claimed)) {
      std::memcpy(unfinished_slots[i].path.data(), path.c_str(), path.size() + 1);
      unfinished_slots[i].state.store(active);
      return static_cast<int>(i);
    }
  }
  return -1;
}

void forget_unfinished(int slot) noexcept {
  if (slot >= 0) {
    unfinished_slots[static_cast<std::size_t>(slot)].state.store(free_slot);
  }
}

void remove_unfinished_outputs() noexcept {
  for (Slot& slot : unfinished_slots) {
    if (slot.state.load() == active) {
      ::unlink(slot.path.data());
    }
  }
}

void remove_unfinished_outputs_on_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction old = {};
    if (::sigaction(signal, nullptr, &old) != 0 || old.sa_handler != SIG_DFL) {
      continue;
    }
    struct sigaction action = {};
    action.sa_handler = [](int number) {
      if (ending.test_and_set()) {
        return;  // a second one, perhaps to another thread, while the files are removed
      }
      remove_unfinished_outputs();
      ::signal(number, SIG_DFL);
      ::raise(number);  // once this handler ends
    };
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace changeover
