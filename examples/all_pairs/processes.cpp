#include "processes.hpp"

#include <cstdlib>
#include <stdexcept>

#ifdef CHANGEOVER_WITH_MPI
#include <mpi.h>

#include <chrono>
#include <thread>
#include <type_traits>
#endif

namespace {

class Alone final : public Processes {};

#ifdef CHANGEOVER_WITH_MPI

static_assert(std::is_trivially_copyable_v<Part>);

class MpiProcesses final : public Processes {
 public:
  MpiProcesses() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    if (provided < MPI_THREAD_FUNNELED) {
      MPI_Finalize();
      throw std::runtime_error(
          "this MPI cannot be used by a program with threads; use another one");
    }
    MPI_Comm_rank(MPI_COMM_WORLD, &index_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    heard_.assign(static_cast<std::size_t>(size_), false);
  }

  ~MpiProcesses() override { MPI_Finalize(); }

  std::uint64_t index() const override { return static_cast<std::uint64_t>(index_); }
  std::uint64_t size() const override { return static_cast<std::uint64_t>(size_); }

  void give_up() override {
    for (int other = 0; other < size_; ++other) {
      if (other != index_) {
        MPI_Request request{};
        MPI_Isend(nullptr, 0, MPI_BYTE, other, stop, MPI_COMM_WORLD, &request);
        sent_.push_back(request);
      }
    }
  }

  bool told_to_stop() override {
    int there = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, stop, MPI_COMM_WORLD, &there, &status);
    if (there != 0) {
      hear(status.MPI_SOURCE);
      told_ = true;
    }
    return told_;
  }

  bool all_ready(bool ready) override {
    const int mine = ready ? 1 : 0;
    int all = 0;
    MPI_Request request{};
    MPI_Iallreduce(&mine, &all, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD, &request);
    await(request);
    return all == 1;
  }

  std::vector<Part> gather(const Part& part) override {
    struct Message {
      Part part;
      bool gave_up;
    };
    const Message mine{part, !sent_.empty()};
    std::vector<Message> all(size());
    MPI_Request request{};
    MPI_Iallgather(&mine, sizeof mine, MPI_BYTE, all.data(), sizeof mine, MPI_BYTE, MPI_COMM_WORLD,
                   &request);
    await(request);
    std::vector<Part> parts;
    for (int other = 0; other < size_; ++other) {
      const Message& message = all[static_cast<std::size_t>(other)];
      parts.push_back(message.part);
      // No message may be left when MPI ends.
      if (other != index_ && message.gave_up && !heard_[static_cast<std::size_t>(other)]) {
        hear(other);
      }
    }
    MPI_Waitall(static_cast<int>(sent_.size()), sent_.data(), MPI_STATUSES_IGNORE);
    return parts;
  }

 private:
  static constexpr int stop = 1;

  // Without keeping a core busy.
  static void await(MPI_Request& request) {
    for (int done = 0; done == 0;) {
      MPI_Test(&request, &done, MPI_STATUS_IGNORE);
      if (done == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    }
  }

  void hear(int other) {
    MPI_Recv(nullptr, 0, MPI_BYTE, other, stop, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    heard_[static_cast<std::size_t>(other)] = true;
  }

  int index_ = 0;
  int size_ = 1;
  bool told_ = false;
  std::vector<bool> heard_;
  std::vector<MPI_Request> sent_;
};

// Variables by which the common launchers say that they started this process.
constexpr const char* launchers[] = {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK",
                                     "SLURM_MPI_TYPE"};

#endif

}  // namespace

std::unique_ptr<Processes> Processes::of_launcher() {
#ifdef CHANGEOVER_WITH_MPI
  for (const char* name : launchers) {
    if (std::getenv(name) != nullptr) {
      return std::make_unique<MpiProcesses>();
    }
  }
#else
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* processes = std::getenv(name);
    if (processes != nullptr && std::string_view(processes) != "1") {
      throw std::runtime_error("was built without MPI; start each process by hand, with --share");
    }
  }
#endif
  return std::make_unique<Alone>();
}
