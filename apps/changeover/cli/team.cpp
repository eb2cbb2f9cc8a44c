#include "cli/team.hpp"

#include <cstdlib>

#include "cli/cli.hpp"

#ifdef CHANGEOVER_WITH_MPI
#include <mpi.h>

#include <limits>
#include <mutex>
#include <optional>

#include "changeover/core/error.hpp"
#include "cli/late_library.hpp"
#endif

namespace changeover::cli {
namespace {

class Alone final : public Team {
 public:
  std::uint64_t index() const override { return 0; }
  std::uint64_t size() const override { return 1; }
  void announce() override {}
  bool heard() override { return false; }
  std::vector<std::string> exchange(const std::string& message) override { return {message}; }
};

#ifdef CHANGEOVER_LATE_MPI

// These hide the functions of the same names in libmpi, so that only a process that mpirun started
// loads the library.
#define CHANGEOVER_LATE(name) const LateFunction<decltype(::name)> name(CHANGEOVER_LATE_MPI, #name)
CHANGEOVER_LATE(MPI_Abort);
CHANGEOVER_LATE(MPI_Allgather);
CHANGEOVER_LATE(MPI_Allgatherv);
CHANGEOVER_LATE(MPI_Barrier);
CHANGEOVER_LATE(MPI_Comm_rank);
CHANGEOVER_LATE(MPI_Comm_size);
CHANGEOVER_LATE(MPI_Finalize);
CHANGEOVER_LATE(MPI_Init_thread);
CHANGEOVER_LATE(MPI_Iprobe);
CHANGEOVER_LATE(MPI_Recv);
CHANGEOVER_LATE(MPI_Send);
#undef CHANGEOVER_LATE

// The constants of Open MPI are addresses.
struct LateConstant {
  const char* name;
  void* operator&() const { return late_address(CHANGEOVER_LATE_MPI, name); }
};
constexpr LateConstant ompi_mpi_char{"ompi_mpi_char"};
constexpr LateConstant ompi_mpi_comm_world{"ompi_mpi_comm_world"};
constexpr LateConstant ompi_mpi_int{"ompi_mpi_int"};
constexpr LateConstant ompi_mpi_uint64_t{"ompi_mpi_uint64_t"};

#endif

#ifdef CHANGEOVER_WITH_MPI

// Announcements carry the number of the exchange that they precede, so that a late one is not taken
// for news of the next search.
class MpiTeam final : public Team {
 public:
  MpiTeam() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    if (provided < MPI_THREAD_SERIALIZED) {
      throw MissingResource("this MPI cannot be used by a program with threads; use another one");
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &index_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
  }

  std::uint64_t index() const override { return static_cast<std::uint64_t>(index_); }
  std::uint64_t size() const override { return static_cast<std::uint64_t>(size_); }

  void announce() override {
    const std::scoped_lock lock(mutex_);
    for (int other = 0; other < size_; ++other) {
      if (other != index_) {
        MPI_Send(&exchanges_, 1, MPI_UINT64_T, other, announcement, MPI_COMM_WORLD);
      }
    }
  }

  bool heard() override {
    const std::scoped_lock lock(mutex_);
    listen();
    return heard_ && *heard_ == exchanges_;
  }

  std::vector<std::string> exchange(const std::string& message) override {
    const std::scoped_lock lock(mutex_);
    if (message.size() > static_cast<std::size_t>(std::numeric_limits<int>::max() / size_)) {
      throw MissingResource(
          "a result is too large to be sent to the other processes; run one process");
    }
    const int length = static_cast<int>(message.size());
    std::vector<int> lengths(size());
    MPI_Allgather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, MPI_COMM_WORLD);
    std::vector<int> offsets(size());
    int total = 0;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      offsets[i] = total;
      total += lengths[i];
    }
    std::string all(static_cast<std::size_t>(total), '\0');
    MPI_Allgatherv(message.data(), length, MPI_CHAR, all.data(), lengths.data(), offsets.data(),
                   MPI_CHAR, MPI_COMM_WORLD);
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      messages.push_back(
          all.substr(static_cast<std::size_t>(offsets[i]), static_cast<std::size_t>(lengths[i])));
    }
    listen();
    ++exchanges_;
    return messages;
  }

 protected:
  void abandon(int code) override { MPI_Abort(MPI_COMM_WORLD, code); }

  void part() override {
    const std::scoped_lock lock(mutex_);
    MPI_Barrier(MPI_COMM_WORLD);
    listen();
    MPI_Finalize();
  }

 private:
  static constexpr int announcement = 1;

  void listen() {
    for (;;) {
      int there = 0;
      MPI_Iprobe(MPI_ANY_SOURCE, announcement, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
      if (there == 0) {
        return;
      }
      std::uint64_t of = 0;
      MPI_Recv(&of, 1, MPI_UINT64_T, MPI_ANY_SOURCE, announcement, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      if (!heard_ || of > *heard_) {
        heard_ = of;
      }
    }
  }

  std::mutex mutex_;
  int index_ = 0;
  int size_ = 1;
  std::uint64_t exchanges_ = 0;
  std::optional<std::uint64_t> heard_;
};

// Variables by which the common launchers say that they started this process.
bool started_by_launcher() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "SLURM_MPI_TYPE"}) {
    if (std::getenv(name) != nullptr) {
      return true;
    }
  }
  return false;
}

#endif

std::unique_ptr<Team> join() {
#ifdef CHANGEOVER_WITH_MPI
  if (started_by_launcher()) {
    return std::make_unique<MpiTeam>();
  }
#endif
  return std::make_unique<Alone>();
}

}  // namespace

bool Team::joined = false;

Team& Team::world() {
  static const std::unique_ptr<Team> team = join();
  joined = true;
  return *team;
}

void Team::leave(int code) {
  if (!joined) {
    return;
  }
  const bool answered = code == exit_code::done || code == exit_code::refuted ||
                        code == exit_code::found || code == exit_code::proved_none ||
                        code == exit_code::limit_reached;
  Team& team = world();
  if (answered) {
    team.part();
  } else {
    team.abandon(code);
  }
}

}  // namespace changeover::cli
