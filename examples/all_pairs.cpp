// Gram matrix and pairwise distances of more vectors than fit into memory.
//
//     all_pairs make vectors.f32 512 1048576                    512 vectors of 2²⁰ floats, 2 GiB
//     all_pairs run vectors.f32 1048576 --chunk 8 --memory 512M --threads 2 --journal job --check
//
// The file holds vectors of 32-bit floats, one after another. An item is a chunk of vectors: pairs within a
// chunk are computed when it is first loaded, others chunk against chunk. The Gram matrix goes to FILE.gram
// and the distances to FILE.dist, as n×n doubles. Each step writes its own entries, and they reach the disk
// before the step is recorded in the journal; so a run that was killed is started again by the same
// command and goes on after the last step that it finished.
//
// --share I/N computes the I-th of N parts, for N processes that write to the same FILE.gram; then there are
// no distances. --order beta|hold|tiles|exhaustive loads as others do. --check compares with the same sums
// over the file mapped into memory. Exit codes: 0 done, 1 --check found a difference, 2 usage, 3 bad input,
// 4 a file, memory or disk space is missing, 5 a bug, 30 interrupted.
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/baselines.hpp"
#include "changeover/loadorder/prefetch.hpp"
#include "changeover/search/random.hpp"

namespace {

using namespace changeover;

struct Usage {
  std::string message;
};

std::atomic<bool> interrupted = false;

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

// A file that is written in pieces, at any place.
class Output {
 public:
  Output(std::string path, int flags) : path_(std::move(path)) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
    if (file_ < 0) {
      refuse();
    }
  }
  ~Output() { ::close(file_); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  void write(const void* bytes, std::size_t count, std::uint64_t offset) const {
    const auto* from = static_cast<const char*>(bytes);
    while (count > 0) {
      const ssize_t written = ::pwrite(file_, from, count, static_cast<off_t>(offset));
      if (written < 0 && errno != EINTR) {
        refuse();
      }
      const auto done = static_cast<std::size_t>(written < 0 ? 0 : written);
      from += done;
      offset += done;
      count -= done;
    }
  }

  void sync() const {
    if (::fdatasync(file_) != 0) {
      refuse();
    }
  }

 private:
  [[noreturn]] void refuse() const {
    throw MissingResource(fmt::format("{}: cannot be written: {}", path_, std::strerror(errno)));
  }

  std::string path_;
  int file_ = -1;
};

// A file in memory as far as the system likes.
class Mapping {
 public:
  explicit Mapping(const std::string& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const off_t end = file < 0 ? -1 : ::lseek(file, 0, SEEK_END);
    if (end > 0) {
      bytes_ = static_cast<std::size_t>(end);
      start_ = ::mmap(nullptr, bytes_, PROT_READ, MAP_PRIVATE, file, 0);
    }
    if (file >= 0) {
      ::close(file);
    }
    if (start_ == MAP_FAILED) {
      throw MissingResource(fmt::format("{}: cannot be mapped into memory", path));
    }
  }
  ~Mapping() { ::munmap(start_, bytes_); }
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  template <typename T>
  [[nodiscard]] const T* as() const {
    return static_cast<const T*>(start_);
  }

 private:
  void* start_ = MAP_FAILED;
  std::size_t bytes_ = 0;
};

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

int make(const std::string& path, std::uint64_t vectors, std::uint64_t dimension) {
  const Output out(path, O_TRUNC);
  Random random(1);
  std::vector<float> vector(static_cast<std::size_t>(dimension));
  const std::uint64_t bytes = dimension * sizeof(float);
  for (std::uint64_t i = 0; i < vectors; ++i) {
    for (float& x : vector) {
      x = static_cast<float>(random.next() >> 40) / static_cast<float>(1 << 24) - 0.5F;
    }
    out.write(vector.data(), static_cast<std::size_t>(bytes), i * bytes);
  }
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
      job.options.threads = static_cast<unsigned>(number(value, name));
    } else if (name == "--readers") {
      job.options.readers = static_cast<unsigned>(number(value, name));
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
  throw Usage{fmt::format("--order {}: is none of beta, hold, tiles, exhaustive", job.order)};
}

// The smallest distance of two vectors, from the Gram matrix, and all of them into a file.
void write_distances(const std::string& path, std::uint64_t n) {
  const Mapping gram(path + ".gram");
  const auto* g = gram.as<double>();
  const Output out(path + ".dist", O_TRUNC);
  std::vector<double> row(static_cast<std::size_t>(n));
  double least = HUGE_VAL;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (std::uint64_t j = 0; j < n; ++j) {
      const double square = g[i * n + i] + g[j * n + j] - 2 * g[i * n + j];
      row[static_cast<std::size_t>(j)] = std::sqrt(std::max(0.0, square));
      least = i == j ? least : std::min(least, row[static_cast<std::size_t>(j)]);
    }
    out.write(row.data(), row.size() * sizeof(double), i * n * sizeof(double));
  }
  fmt::print("least distance of two vectors: {:.6g}\n", least);
}

int compare(const Job& job, std::uint64_t n) {
  const Mapping data(job.path);
  const Mapping gram(job.path + ".gram");
  const auto* g = gram.as<double>();
  for (std::uint64_t i = 0; i < n; ++i) {
    for (std::uint64_t j = i; j < n; ++j) {
      const double expected = dot(data.as<float>() + i * job.dimension,
                                  data.as<float>() + j * job.dimension, job.dimension);
      if (g[i * n + j] != expected || g[j * n + i] != expected) {
        fmt::print("entry ({},{}) is {}, in memory it is {}\n", i, j, g[i * n + j], expected);
        return 1;
      }
    }
  }
  fmt::print("all {} entries are those that are computed in memory\n", n * n);
  return 0;
}

int run(Job job) {
  const std::uint64_t vector_bytes = job.dimension * sizeof(float);
  FileItems file(job.path, job.chunk * vector_bytes, {.bypass_cache = !job.cache});
  const std::uint64_t room = room_for(file, job.memory);
  const PrefetchPlan plan = plan_of(job, file.item_count(), room);
  const std::uint64_t bytes = std::filesystem::file_size(job.path);
  if (bytes % vector_bytes != 0) {
    throw BadInput(fmt::format("{}: {} bytes are no whole number of vectors of {} bytes", job.path,
                               bytes, vector_bytes));
  }
  const std::uint64_t n = bytes / vector_bytes;
  const LoadOrderFacts& facts = plan.order.facts();
  fmt::print("{} vectors in {} chunks, room for {}; {} loads ({}), lower bound {}\n", n,
             file.item_count(), room, facts.loads, facts.method,
             load_lower_bound(file.item_count(), room).loads);

  const Output gram(job.path + ".gram", 0);
  const auto compute = [&](const PairWork& work) {
    const auto rows = work.first.bytes.size() / vector_bytes;
    const auto columns = work.second.bytes.size() / vector_bytes;
    const auto* a = reinterpret_cast<const float*>(work.first.bytes.data());
    const auto* b = reinterpret_cast<const float*>(work.second.bytes.data());
    const bool same = work.first.item == work.second.item;
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t j = same ? i : 0; j < columns; ++j) {
        const double value = dot(a + i * job.dimension, b + j * job.dimension, job.dimension);
        const std::uint64_t row = work.first.item * job.chunk + i;
        const std::uint64_t column = work.second.item * job.chunk + j;
        gram.write(&value, sizeof value, (row * n + column) * sizeof value);
        gram.write(&value, sizeof value, (column * n + row) * sizeof value);
      }
    }
  };
  job.options.read_ahead = plan.spare;
  job.options.memory_bytes = job.memory;
  job.options.job = "gram";
  job.options.cancelled = &interrupted;
  if (!job.options.journal.empty()) {
    job.options.on_step_done = [&](std::uint64_t) { gram.sync(); };
  }
  const AllPairsReport report = all_pairs(file, plan.order, compute, job.options);
  fmt::print(
      "{} of {} steps, {} of them earlier; {} loads, {:.2f} GB read ({}), {:.0f} MB of "
      "buffers; {:.1f} s, {:.1f} s of them waiting for loads\n",
      report.steps_done, report.steps, report.steps_resumed, report.loads,
      static_cast<double>(report.bytes_read) / 1e9, file.access(),
      static_cast<double>(report.buffer_bytes) / 1e6, report.elapsed.count(),
      report.waited.count());
  if (!report.finished) {
    constexpr int limit_reached = 30;
    return limit_reached;
  }
  if (job.options.share.of > 1) {
    return 0;
  }
  write_distances(job.path, n);
  return job.check ? compare(job, n) : 0;
}

int complain(int code, const std::string& message) {
  fmt::print(stderr, "all_pairs: {}\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &action, nullptr);
  try {
    if (words.size() == 4 && words[0] == "make") {
      return make(words[1], number(words[2], "VECTORS"), number(words[3], "DIMENSION"));
    }
    if (words.size() >= 3 && words[0] == "run") {
      return run(read_job({words.begin() + 1, words.end()}));
    }
    throw Usage{
        "usage: all_pairs make FILE VECTORS DIMENSION | all_pairs run FILE DIMENSION "
        "[--chunk N] [--memory BYTES] [--threads N] [--readers N] [--journal FILE] "
        "[--share I/N] [--order NAME] [--cache] [--check]"};
  } catch (const Usage& fault) {
    return complain(2, fault.message);
  } catch (const ImpossibleParameters& fault) {
    return complain(2, fault.what());
  } catch (const BadInput& fault) {
    return complain(3, fault.what());
  } catch (const MissingResource& fault) {
    return complain(4, fault.what());
  } catch (const std::bad_alloc&) {
    return complain(4, "not enough memory");
  } catch (const std::exception& fault) {
    return complain(5, fault.what());
  }
}
