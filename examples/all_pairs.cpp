// Gram matrix and pairwise distances of more vectors than fit into memory.
//
//     all_pairs make vectors.f32 512 1048576                    512 vectors of 2²⁰ floats, 2 GiB
//     all_pairs run vectors.f32 1048576 --chunk 8 --memory 512M --threads 2 --journal job --check
//
// The file holds vectors of 32-bit floats, one after another. An item is a chunk of vectors: pairs
// within a chunk are computed when it is first loaded, others chunk against chunk. The Gram matrix
// goes to FILE.gram and the distances to FILE.dist, as n×n doubles. Each step writes its own
// entries, and they reach the disk before the step is recorded in the journal with their checksum;
// so a run that was killed is started again by the same command and goes on with the steps whose
// entries are not there. A job that is refused has changed nothing; FILE.gram belongs to one job
// while it runs, and is filled in place; FILE.dist appears whole or not at all.
//
//     mpirun -n 4 all_pairs run vectors.f32 1048576 --chunk 8 --memory 512M --journal job
//
// Each process takes its share with its own --memory, and all write to the same FILE.gram: the
// result is that of one process, byte by byte. Process i has the journal job.i. If one fails, or is
// interrupted, all end.
//
// --share I/N computes the I-th of N parts, for N processes without MPI, at the same time or one
// after another; then there are no distances. --order beta|hold|tiles|exhaustive loads as others
// do. --check compares with the same sums over the file mapped into memory. Exit codes: 0 done, 1
// --check found a difference, 2 usage, 3 bad input, 4 a file, memory or disk space is missing, 5 a
// bug, 30 interrupted.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "all_pairs/files.hpp"
#include "all_pairs/gram.hpp"
#include "all_pairs/load_orders.hpp"
#include "all_pairs/processes.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/workers.hpp"

namespace {

using namespace changeover;

constexpr int limit_reached = 30;

struct Usage {
  std::string message;
};

// A signal asked to stop, or another process of the same job.
struct Stopped {};

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

// What cannot be said must not end a job: it is told by the exit code, when results are safe.
bool all_was_said = true;

void say(const std::string& line) {
  all_was_said &= std::fputs((line + "\n").c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
}

std::uint64_t number(std::string_view text, const std::string& what) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, failure] = std::from_chars(text.data(), end, value);
  const std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  const unsigned shift = unit == "K" ? 10 : unit == "M" ? 20 : unit == "G" ? 30 : 0;
  if (failure != std::errc() || (shift == 0 && !unit.empty()) || value > (UINT64_MAX >> shift)) {
    throw Usage{fmt::format("{} '{}' is not a whole number", what, text)};
  }
  return value << shift;
}

// Eight sums at once; each piece of 4096 numbers is added up in floats, pieces in doubles.
double dot(const float* a, const float* b, std::size_t count) {
  using Eight = float __attribute__((vector_size(32)));
  constexpr std::size_t piece = 4096;
  double total = 0;
  for (std::size_t start = 0; start < count; start += piece) {
    const std::size_t end = std::min(start + piece, count);
    Eight sums{};
    std::size_t i = start;
    for (; i + 8 <= end; i += 8) {
      Eight x;
      Eight y;
      std::memcpy(&x, a + i, sizeof x);
      std::memcpy(&y, b + i, sizeof y);
      sums += x * y;
    }
    for (; i < end; ++i) {
      sums[0] += a[i] * b[i];
    }
    for (int lane = 0; lane < 8; ++lane) {
      total += static_cast<double>(sums[lane]);
    }
  }
  return total;
}

void stop_if_interrupted() {
  if (interrupted) {
    throw Stopped();
  }
}

int make(const std::string& path, std::uint64_t vectors, std::uint64_t dimension) {
  if (vectors == 0 || dimension == 0) {
    throw Usage{"VECTORS and DIMENSION must be at least 1"};
  }
  const std::uint64_t numbers = product(vectors, dimension);
  require_space(path, product(numbers, sizeof(float)));
  OutputFile out(path);
  std::mt19937_64 random(1);
  std::vector<float> piece(1 << 16);
  for (std::uint64_t done = 0; done < numbers; done += piece.size()) {
    stop_if_interrupted();
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), numbers - done)));
    for (float& x : piece) {
      x = static_cast<float>(random() >> 40) / static_cast<float>(1 << 24) - 0.5F;
    }
    out.write({reinterpret_cast<const char*>(piece.data()), piece.size() * sizeof(float)});
  }
  out.commit();
  return 0;
}

struct Job {
  std::string path;
  std::uint64_t dimension = 0;
  std::uint64_t chunk = 1;  // vectors
  std::uint64_t memory = std::uint64_t{512} << 20;
  bool check = false;
  bool cache = false;
  std::string order;
  AllPairsOptions options;
};

unsigned thread_count(std::string_view text, const std::string& what) {
  const std::uint64_t count = number(text, what);
  if (count == 0 || count > most_job_threads) {
    throw Usage{fmt::format("{} {}: give 1 to {}", what, text, most_job_threads)};
  }
  return static_cast<unsigned>(count);
}

// Results must not go where the data or the journal are.
void check_files(const Job& job) {
  const std::string& journal = job.options.journal;
  for (const char* end : {"", ".gram", ".dist"}) {
    if (!journal.empty() && is_same_file(journal, job.path + end)) {
      throw Usage{fmt::format("--journal {}: is a file of the job; name another", journal)};
    }
    if (*end != '\0' && is_same_file(job.path, job.path + end)) {
      throw Usage{fmt::format("{0}{1}: is the same file as {0}, so results would replace the data",
                              job.path, end)};
    }
  }
}

Job read_job(const std::vector<std::string>& words) {
  Job job;
  job.path = words[0];
  job.dimension = number(words[1], "DIMENSION");
  std::map<std::string, std::string> values;
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "--check" || word == "--cache") {
      (word == "--check" ? job.check : job.cache) = true;
    } else if (word.starts_with("--") && i + 1 < words.size()) {
      values[word] = words[++i];
    } else {
      throw Usage{fmt::format("'{}' is not understood", word)};
    }
  }
  for (const auto& [name, value] : values) {
    if (name == "--chunk") {
      job.chunk = number(value, name);
    } else if (name == "--memory") {
      job.memory = number(value, name);
    } else if (name == "--threads") {
      job.options.threads = thread_count(value, name);
    } else if (name == "--readers") {
      job.options.readers = thread_count(value, name);
    } else if (name == "--journal") {
      job.options.journal = value;
    } else if (name == "--order") {
      job.order = value;
    } else if (name == "--share" && value.find('/') != std::string::npos) {
      job.options.share = {number(value.substr(0, value.find('/')), name),
                           number(value.substr(value.find('/') + 1), name)};
    } else {
      throw Usage{fmt::format("{} {} is not understood", name, value)};
    }
  }
  if (job.dimension == 0 || job.chunk == 0) {
    throw Usage{"DIMENSION and --chunk must be at least 1"};
  }
  check_files(job);
  return job;
}

PrefetchPlan plan_of(const Job& job, std::uint64_t items, std::uint64_t room) {
  if (job.order.empty()) {
    return plan_prefetch(items, room);
  }
  for (LoadOrder& order : baseline_orders(items, room)) {
    if (order.facts().method == job.order) {
      return {std::move(order), 0};
    }
  }
  throw Usage{
      fmt::format("--order {}: unknown order; use beta, hold, tiles or exhaustive", job.order)};
}

std::uint64_t vectors_in(const Job& job, const FileItems& file) {
  const std::uint64_t vector_bytes = product(job.dimension, sizeof(float));
  if (file.data_bytes() % vector_bytes != 0) {
    throw BadInput(
        fmt::format("{}: {} bytes are not a whole number of vectors of {} bytes; check DIMENSION",
                    job.path, file.data_bytes(), vector_bytes));
  }
  return file.data_bytes() / vector_bytes;
}

// The smallest distance of two vectors, from the Gram matrix, and all of them into a file.
void write_distances(const std::string& path, std::uint64_t n) {
  const Mapping gram(path + ".gram");
  const auto* g = gram.as<double>();
  require_space(path + ".dist", product(product(n, n), sizeof(double)));
  OutputFile out(path + ".dist");
  std::vector<double> row(static_cast<std::size_t>(n));
  double least = HUGE_VAL;
  for (std::uint64_t i = 0; i < n; ++i) {
    stop_if_interrupted();
    for (std::uint64_t j = 0; j < n; ++j) {
      const double square = g[i * n + i] + g[j * n + j] - 2 * g[i * n + j];
      row[static_cast<std::size_t>(j)] = std::sqrt(std::max(0.0, square));
      least = i == j ? least : std::min(least, row[static_cast<std::size_t>(j)]);
    }
    out.write({reinterpret_cast<const char*>(row.data()), row.size() * sizeof(double)});
  }
  out.commit();
  say(fmt::format("least distance of two vectors: {:.6g}", least));
}

int compare(const Job& job, std::uint64_t n) {
  const Mapping data(job.path);
  const Mapping gram(job.path + ".gram");
  const auto* g = gram.as<double>();
  for (std::uint64_t i = 0; i < n; ++i) {
    stop_if_interrupted();
    for (std::uint64_t j = i; j < n; ++j) {
      const double expected = dot(data.as<float>() + i * job.dimension,
                                  data.as<float>() + j * job.dimension, job.dimension);
      if (g[i * n + j] != expected || g[j * n + i] != expected) {
        say(fmt::format("entry ({},{}) is {}, in memory it is {}", i, j, g[i * n + j], expected));
        return 1;
      }
    }
  }
  say(fmt::format("all {} entries are those that are computed in memory", n * n));
  return 0;
}

// Computes the share of this process. The results stay locked as long as `gram` is there.
Part compute_share(Job job, Processes& processes, std::unique_ptr<Gram>& gram,
                   const std::function<void()>& before_writing) {
  const std::uint64_t vector_bytes = product(job.dimension, sizeof(float));
  FileItems file(job.path, product(job.chunk, vector_bytes), {.bypass_cache = !job.cache});
  const std::uint64_t room = room_for(file, job.memory);
  const PrefetchPlan plan = plan_of(job, file.item_count(), room);
  const std::uint64_t n = vectors_in(job, file);
  const LoadOrderFacts& facts = plan.order.facts();
  Part part;
  put(part.job, fmt::format("{} vectors in {} chunks, room for {}; {} loads ({}), lower bound {}",
                            n, file.item_count(), room, facts.loads, facts.method,
                            load_lower_bound(file.item_count(), room).loads));
  if (processes.index() == 0) {
    say(part.job.data());
  }

  gram = std::make_unique<Gram>(job.path + ".gram", n, job.chunk, before_writing);
  const auto compute = [&](const PairWork& work) {
    const std::uint64_t row = work.first.item * job.chunk;
    const std::uint64_t column = work.second.item * job.chunk;
    const auto* a = reinterpret_cast<const float*>(work.first.bytes.data());
    const auto* b = reinterpret_cast<const float*>(work.second.bytes.data());
    gram->write(work.first.item, work.second.item, [&](std::uint64_t i, std::uint64_t j) {
      return dot(a + (i - row) * job.dimension, b + (j - column) * job.dimension, job.dimension);
    });
  };
  if (processes.size() > 1) {
    job.options.share = {processes.index(), processes.size()};
    job.options.on_progress = [&](const AllPairsProgress&) {
      if (processes.told_to_stop()) {
        interrupted = true;
      }
    };
    if (!job.options.journal.empty()) {
      job.options.journal += fmt::format(".{}", processes.index());
    }
  }
  job.options.read_ahead = plan.spare;
  job.options.memory_bytes = job.memory;
  job.options.job = "gram";
  job.options.cancelled = &interrupted;
  job.options.results = gram.get();
  const AllPairsReport report = all_pairs(file, plan.order, compute, job.options);
  put(part.access, file.access());
  part.steps = report.steps;
  part.steps_done = report.steps_done;
  part.steps_resumed = report.steps_resumed;
  part.steps_lost = report.steps_lost;
  put(part.note, report.note);
  part.loads = report.loads;
  part.bytes_read = report.bytes_read;
  part.buffer_bytes = report.buffer_bytes;
  part.seconds = report.elapsed.count();
  part.waited_seconds = report.waited.count();
  if (!report.finished) {
    part.code = limit_reached;
    put(part.message, "interrupted; the same command goes on if it has a --journal");
  }
  return part;
}

// What all have done, in one line.
void describe(const std::vector<Part>& parts) {
  Part all;
  std::uint64_t most_loads = 0;
  for (const Part& part : parts) {
    all.steps += part.steps;
    all.steps_done += part.steps_done;
    all.steps_resumed += part.steps_resumed;
    all.steps_lost += part.steps_lost;
    all.loads += part.loads;
    most_loads = std::max(most_loads, part.loads);
    all.bytes_read += part.bytes_read;
    all.buffer_bytes += part.buffer_bytes;
    all.seconds = std::max(all.seconds, part.seconds);
    all.waited_seconds = std::max(all.waited_seconds, part.waited_seconds);
  }
  const std::string team =
      parts.size() == 1
          ? std::string()
          : fmt::format("{} processes, {} loads at most for one: ", parts.size(), most_loads);
  const std::string lost = all.steps_lost == 0
                               ? std::string()
                               : fmt::format(", {} recorded but not found again", all.steps_lost);
  say(
      fmt::format("{}{} of {} steps, {} of them earlier{}; {} loads, {:.2f} GB read ({}), {:.0f} "
                  "MB of buffers; {:.1f} s, {:.1f} s of them waiting for loads",
                  team, all.steps_done, all.steps, all.steps_resumed, lost, all.loads,
                  static_cast<double>(all.bytes_read) / 1e9, parts[0].access.data(),
                  static_cast<double>(all.buffer_bytes) / 1e6, all.seconds, all.waited_seconds));
}

// If standard error cannot be written, the code still says it.
int complain(int code, const std::string& message) {
  std::fputs(("all_pairs: " + message + "\n").c_str(), stderr);
  return code;
}

// What `act` returns, or the code and the line of its fault.
template <typename Act>
Part attempt(const Act& act) {
  const auto failed = [](int code, std::string_view message) {
    Part part;
    part.code = code;
    put(part.message, message);
    return part;
  };
  try {
    return act();
  } catch (const Stopped&) {
    return failed(limit_reached, "interrupted; the same command goes on if it has a --journal");
  } catch (const Usage& fault) {
    return failed(2, fault.message);
  } catch (const ImpossibleParameters& fault) {
    return failed(2, fault.what());
  } catch (const BadInput& fault) {
    return failed(3, fault.what());
  } catch (const MissingResource& fault) {
    return failed(4, fault.what());
  } catch (const std::bad_alloc&) {
    return failed(4, "not enough memory; allow less by --memory, or make --chunk smaller");
  } catch (const std::exception& fault) {
    return failed(5, fault.what());
  }
}

// The code of all processes, and one line that says what went wrong, from the first of them.
int verdict_of(std::vector<Part> parts, const Processes& processes) {
  // What stopped the others comes before what was stopped.
  std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    const auto order = [](const Part& part) {
      return part.code == 0 ? 3 : part.code != limit_reached ? 0 : part.message[0] != '\0' ? 1 : 2;
    };
    return order(a) < order(b);
  });
  const Part& worst = parts[0];
  if (worst.code != 0 && worst.message[0] != '\0' && processes.index() == 0) {
    complain(worst.code, (processes.size() == 1
                              ? std::string()
                              : fmt::format("process {} of {}: ", worst.index, processes.size())) +
                             worst.message.data());
  }
  return worst.code;
}

int run(const Job& job, Processes& processes) {
  const auto together = [&](Part part) {
    part.index = processes.index();
    if (part.code != 0 && !processes.told_to_stop()) {
      processes.give_up();
    } else if (part.code == limit_reached) {
      put(part.message, "");  // the one that gave up says why
    }
    return processes.gather(part);
  };
  std::unique_ptr<Gram> gram;
  // No process writes before all have found that they can.
  bool asked = false;
  const auto before_writing = [&] {
    asked = true;
    if (!processes.all_ready(true)) {
      throw Stopped();
    }
  };
  const Part share = attempt([&] { return compute_share(job, processes, gram, before_writing); });
  if (!asked) {
    static_cast<void>(processes.all_ready(false));
  }
  std::vector<Part> parts = together(share);
  for (Part& part : parts) {
    if (part.code == 0 && part.job != parts[0].job && parts[0].code == 0) {
      part.code = 3;
      put(part.message, fmt::format("sees another job: {}", part.job.data()));
    }
  }
  const bool first = processes.index() == 0;
  for (const Part& part : parts) {
    if (first && part.note[0] != '\0') {
      complain(part.code, part.note.data());
    }
  }
  const int code = verdict_of(parts, processes);
  if (first && (code == 0 || code == limit_reached)) {
    describe(parts);
  }
  if (code != 0 || job.options.share.of > 1) {
    return code;
  }
  // Only now all entries are there.
  const Part end = attempt([&] {
    Part part;
    if (first) {
      const std::uint64_t n = gram->vectors();
      write_distances(job.path, n);
      part.code = job.check ? compare(job, n) : 0;
    }
    return part;
  });
  return verdict_of(together(end), processes);
}

// A file that is opened must not become a standard stream because that was closed.
void keep_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // Not for writing: what is written there is lost, which must be reported.
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDONLY) != stream) {
      std::_Exit(4);
    }
  }
}

// The first signal lets the step end, the second ends the process.
void handle_signals() {
  struct sigaction action {};
  action.sa_handler = [](int signal) {
    if (interrupted.exchange(true)) {
      remove_unfinished_outputs();
      ::signal(signal, SIG_DFL);
      ::raise(signal);
    }
  };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);  // of mpirun and of batch systems
  // Then the system says by errno what is wrong, and files are left in good order.
  ::signal(SIGPIPE, SIG_IGN);
  ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  keep_standard_streams();
  handle_signals();
  const std::vector<std::string> words(argv + 1, argv + argc);
  std::unique_ptr<Processes> processes;
  int code = 0;
  const Part part = attempt([&] {
    processes = Processes::of_launcher();
    if (words.size() == 4 && words[0] == "make" && processes->size() == 1) {
      code = make(words[1], number(words[2], "VECTORS"), number(words[3], "DIMENSION"));
    } else if (words.size() >= 3 && words[0] == "run") {
      const Job job = read_job({words.begin() + 1, words.end()});
      if (job.options.share.of > 1 && processes->size() > 1) {
        throw Usage{"--share is for processes without MPI; mpirun shares by itself"};
      }
      code = run(job, *processes);
    } else {
      throw Usage{
          "usage: all_pairs make FILE VECTORS DIMENSION | [mpirun -n N] all_pairs run FILE "
          "DIMENSION [--chunk N] [--memory BYTES] [--threads N] [--readers N] [--journal FILE] "
          "[--share I/N] [--order NAME] [--cache] [--check]"};
    }
    return Part();
  });
  if (part.code == 0) {
    return code == 0 && !all_was_said
               ? complain(4, "standard output cannot be written; the results are complete")
               : code;
  }
  // All processes see the same words: one says what is wrong with them.
  return processes && processes->index() > 0 ? part.code : complain(part.code, part.message.data());
}
