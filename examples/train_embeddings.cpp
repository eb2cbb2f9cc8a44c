// Trains embeddings of the nodes of a graph that are too large for memory, with several workers.
//
//     train_embeddings make edges.txt 2000 20000
//     train_embeddings run edges.txt embeddings.f32 --parts 16 --room 4 --workers 2 --journal job
//
// The nodes are in parts, which lie on the disk; a worker holds a few of them and trains on the
// edges between every two. The order (changeover loadorder --disjoint --write-back) gives no part
// to two workers at once, so that no worker needs a lock. Each part has an owner that is set for
// the time in which it is trained on; if another worker owns it then, the program aborts.
//
// The model: sigmoid(a·b) for nodes a and b is near 1 if they share an edge, and near 0 for b
// replaced by another node of its part. One pass over the edges is one epoch. The same seed gives
// the same bytes, whatever the threads do, and after a crash.
//
// Exit codes: 0 done, 2 usage, 3 bad input, 4 a file is missing or cannot be written, 30
// interrupted (start it again).
#include <fmt/format.h>

#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "changeover/core/error.hpp"
#include "changeover/io/output.hpp"
#include "changeover/loadorder/all_pairs.hpp"
#include "changeover/loadorder/workers.hpp"

namespace {

using namespace changeover;

std::atomic<bool> interrupted = false;

struct Usage {
  std::string message;
};

std::uint64_t number(const std::string& word, const std::string& name) {
  std::uint64_t value = 0;
  const char* const end = word.data() + word.size();
  const auto [rest, failure] = std::from_chars(word.data(), end, value);
  if (failure != std::errc() || rest != end || value == 0 || value > 1'000'000'000) {
    throw Usage{fmt::format("{} {}: give a whole number from 1 to 1000000000", name, word)};
  }
  return value;
}

/// The same numbers everywhere: splitmix64.
class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::uint64_t below(std::uint64_t limit) { return next() % limit; }
  float unit() { return static_cast<float>(next() >> 40) / 16777216.0F; }

 private:
  std::uint64_t state_;
};

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct Job {
  std::string edges;
  std::string embeddings;
  std::string journal;
  std::uint64_t parts = 16;
  std::uint64_t room = 4;
  std::uint64_t workers = 2;
  std::uint64_t dimension = 16;
  std::uint64_t checkpoint = 10;
  std::uint64_t seed = 1;
};

// A graph of ten groups of nodes, most of whose edges are within a group.
int make(const std::string& path, std::uint64_t nodes, std::uint64_t edges) {
  constexpr std::uint64_t groups = 10;
  if (nodes < 2 * groups) {
    throw Usage{"NODES: give at least 20"};
  }
  Numbers numbers(7);
  OutputFile file(path);
  std::string text;
  for (std::uint64_t i = 0; i < edges; ++i) {
    const std::uint64_t a = numbers.below(nodes);
    std::uint64_t b = numbers.below(nodes);
    if (numbers.below(10) < 8) {
      b = b / groups * groups + a % groups;
    }
    text += fmt::format("{} {}\n", a, b < nodes ? b : a % groups);
  }
  file.write(text);
  file.commit();
  return 0;
}

/// The edges by the parts of their ends, smaller part first: what the pair of these parts is
/// trained on.
class Buckets {
 public:
  Buckets(const std::string& path, std::uint64_t parts) : parts_(parts) {
    std::ifstream in(path);
    if (!in) {
      throw MissingResource(path + ": cannot be read");
    }
    std::vector<Edge> edges;
    std::uint64_t line = 0;
    for (std::string text; std::getline(in, text);) {
      ++line;
      std::uint32_t a = 0;
      std::uint32_t b = 0;
      const char* const end = text.data() + text.size();
      const auto first = std::from_chars(text.data(), end, a);
      const auto second = first.ec == std::errc() && first.ptr < end
                              ? std::from_chars(first.ptr + 1, end, b)
                              : first;
      if (second.ec != std::errc() || second.ptr != end || first.ptr == end ||
          std::max(a, b) > 1'000'000'000) {
        throw BadInput(
            fmt::format("{}:{}: two numbers of nodes are expected, as in: 3 17", path, line));
      }
      if (a != b) {
        edges.emplace_back(a, b);
        nodes_ = std::max<std::uint64_t>(nodes_, std::max(a, b) + std::uint64_t{1});
      }
    }
    if (edges.empty()) {
      throw BadInput(path + ": has no edge between two nodes");
    }
    size_ = (nodes_ + parts - 1) / parts;
    buckets_.resize(static_cast<std::size_t>(parts * parts));
    count_ = edges.size();
    for (auto [a, b] : edges) {
      if (a / size_ > b / size_) {
        std::swap(a, b);
      }
      buckets_[a / size_ * parts + b / size_].emplace_back(a, b);
      hash_ = Numbers(hash_ ^ (std::uint64_t{a} << 32 | b)).next();
    }
  }

  /// Nodes a part; the last part may have places without a node.
  [[nodiscard]] std::uint64_t part_size() const { return size_; }
  [[nodiscard]] std::uint64_t edges() const { return count_; }
  [[nodiscard]] std::uint64_t nodes() const { return nodes_; }
  /// Of the edges, by which a journal knows them again.
  [[nodiscard]] std::uint64_t hash() const { return hash_; }
  [[nodiscard]] const std::vector<Edge>& between(std::uint64_t first, std::uint64_t second) const {
    return buckets_[static_cast<std::size_t>(first * parts_ + second)];
  }

 private:
  std::uint64_t parts_;
  std::uint64_t size_ = 0;
  std::uint64_t nodes_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t hash_ = 0;
  std::vector<std::vector<Edge>> buckets_;
};

/// Who trains on a part now.
class Owners {
 public:
  explicit Owners(std::uint64_t parts) : owner_(static_cast<std::size_t>(parts)) {}

  void take(Element part, std::uint64_t worker) {
    std::uint64_t owner = 0;
    if (!owner_[part].compare_exchange_strong(owner, worker + 1)) {
      fmt::print(stderr, "train_embeddings: worker {} takes part {}, which worker {} has\n", worker,
                 part, owner - 1);
      std::abort();
    }
    ++taken_;
  }
  void give_back(Element part) { owner_[part].store(0); }
  [[nodiscard]] std::uint64_t taken() const { return taken_; }

 private:
  std::vector<std::atomic<std::uint64_t>> owner_;
  std::atomic<std::uint64_t> taken_ = 0;
};

float dot(const float* a, const float* b, std::uint64_t dimension) {
  float sum = 0;
  for (std::uint64_t i = 0; i < dimension; ++i) {
    sum += a[i] * b[i];
  }
  return sum;
}

float sigmoid(float x) { return 1.0F / (1.0F + std::exp(-x)); }

// One step down the gradient; `wanted` is 1 for an edge and 0 for none.
void push(float* a, float* b, float wanted, std::uint64_t dimension) {
  constexpr float rate = 0.1F;
  const float step = rate * (wanted - sigmoid(dot(a, b, dimension)));
  for (std::uint64_t i = 0; i < dimension; ++i) {
    const float old = a[i];
    a[i] += step * b[i];
    b[i] += step * old;
  }
}

class Trainer {
 public:
  Trainer(const Job& job, const Buckets& buckets)
      : job_(job), buckets_(buckets), owners_(job.parts) {}

  void train(const PairUpdate& pair) {
    const bool alone = pair.first.item == pair.second.item;
    owners_.take(pair.first.item, pair.worker);
    if (!alone) {
      owners_.take(pair.second.item, pair.worker);
    }
    auto* const first = reinterpret_cast<float*>(pair.first.bytes.data());
    auto* const second = reinterpret_cast<float*>(pair.second.bytes.data());
    const std::uint64_t size = buckets_.part_size();
    const std::uint64_t d = job_.dimension;
    Numbers numbers(job_.seed * 1'000'003 + pair.first.item * job_.parts + pair.second.item);
    for (const auto& [a, b] : buckets_.between(pair.first.item, pair.second.item)) {
      float* const node = first + a % size * d;
      push(node, second + b % size * d, 1, d);
      float* const other = second + numbers.below(size) * d;
      if (other != node) {
        push(node, other, 0, d);
      }
    }
    owners_.give_back(pair.first.item);
    if (!alone) {
      owners_.give_back(pair.second.item);
    }
  }

  [[nodiscard]] std::uint64_t taken() const { return owners_.taken(); }

 private:
  const Job& job_;
  const Buckets& buckets_;
  Owners owners_;
};

// Small random numbers, whole or not at all; what is there already stays.
void begin_embeddings(const Job& job, std::uint64_t item_bytes) {
  if (std::filesystem::exists(job.embeddings)) {
    return;
  }
  Numbers numbers(job.seed);
  OutputFile file(job.embeddings);
  std::vector<float> part(static_cast<std::size_t>(item_bytes / sizeof(float)));
  for (std::uint64_t i = 0; i < job.parts; ++i) {
    for (float& x : part) {
      x = numbers.unit() - 0.5F;
    }
    file.write({reinterpret_cast<const char*>(part.data()), part.size() * sizeof(float)});
  }
  file.commit();
}

// The mean of −log of what the model gives to edges, and to as many pairs of nodes at random that
// they are none.
double loss(const Job& job, const Buckets& buckets) {
  std::ifstream in(job.embeddings, std::ios::binary);
  std::vector<float> all(static_cast<std::size_t>(job.parts * buckets.part_size() * job.dimension));
  in.read(reinterpret_cast<char*>(all.data()),
          static_cast<std::streamsize>(all.size() * sizeof(float)));
  if (!in) {
    throw MissingResource(job.embeddings + ": cannot be read");
  }
  const auto node = [&](std::uint64_t x) { return all.data() + x * job.dimension; };
  Numbers numbers(99);
  double sum = 0;
  for (std::uint64_t i = 0; i < job.parts; ++i) {
    for (std::uint64_t j = i; j < job.parts; ++j) {
      for (const auto& [a, b] : buckets.between(i, j)) {
        const auto other = node(numbers.below(buckets.nodes()));
        sum -= std::log(static_cast<double>(sigmoid(dot(node(a), node(b), job.dimension))) + 1e-9);
        sum -=
            std::log(1 - static_cast<double>(sigmoid(dot(node(a), other, job.dimension))) + 1e-9);
      }
    }
  }
  return sum / static_cast<double>(2 * buckets.edges());
}

int run(const Job& job) {
  const Buckets buckets(job.edges, job.parts);
  const std::uint64_t item_bytes = buckets.part_size() * job.dimension * sizeof(float);
  const LoadOrder order = plan_disjoint_order(job.parts, job.room, job.workers);
  begin_embeddings(job, item_bytes);
  Trainer trainer(job, buckets);
  UpdateOptions options{.data = job.embeddings, .item_bytes = item_bytes, .journal = job.journal};
  options.checkpoint_every = job.checkpoint;
  options.job = fmt::format("train_embeddings, {} edges {:016x}, dimension {}, seed {}",
                            buckets.edges(), buckets.hash(), job.dimension, job.seed);
  options.work = {.self = true};
  options.cancelled = &interrupted;
  const bool is_new = !std::filesystem::exists(job.journal);
  const double before = is_new ? loss(job, buckets) : 0;
  const UpdateReport report = update_pairs(
      order, [&](const PairUpdate& pair) { trainer.train(pair); }, options);
  if (!report.note.empty()) {
    fmt::print(stderr, "train_embeddings: {}\n", report.note);
  }
  fmt::print(
      "{} of {} steps, {} of them earlier; {} loads, {} stores and {} at checkpoints; {} pairs of "
      "parts, each part with one worker at a time ({} times)\n",
      report.steps_done, report.steps, report.steps_resumed, report.loads, report.stores,
      report.checkpoint_stores, report.updates, trainer.taken());
  if (!report.finished) {
    return 30;
  }
  if (is_new) {
    fmt::print("loss {:.4f} before, ", before);
  }
  fmt::print("loss {:.4f} after one epoch\n", loss(job, buckets));
  return 0;
}

Job read_job(const std::vector<std::string>& words) {
  Job job;
  job.edges = words[1];
  job.embeddings = words[2];
  const std::map<std::string, std::uint64_t*> numbers = {
      {"--parts", &job.parts},           {"--room", &job.room},
      {"--workers", &job.workers},       {"--dimension", &job.dimension},
      {"--checkpoint", &job.checkpoint}, {"--seed", &job.seed}};
  for (std::size_t i = 3; i < words.size(); i += 2) {
    const auto found = numbers.find(words[i]);
    if (i + 1 == words.size() || (found == numbers.end() && words[i] != "--journal")) {
      throw Usage{fmt::format("'{}' is not understood, or has no value", words[i])};
    }
    if (found != numbers.end()) {
      *found->second = number(words[i + 1], words[i]);
    } else {
      job.journal = words[i + 1];
    }
  }
  if (job.journal.empty()) {
    throw Usage{
        "--journal FILE is required: without it a crash would leave half changed embeddings"};
  }
  return job;
}

int complain(int code, const std::string& what) {
  fmt::print(stderr, "train_embeddings: {}\n", what);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { interrupted = true; });
  std::signal(SIGTERM, [](int) { interrupted = true; });
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 4 && words[0] == "make") {
      return make(words[1], number(words[2], "NODES"), number(words[3], "EDGES"));
    }
    if (words.size() >= 3 && words[0] == "run") {
      return run(read_job(words));
    }
    return complain(2,
                    "usage: train_embeddings make EDGES NODES COUNT | train_embeddings run EDGES "
                    "EMBEDDINGS --journal FILE [--parts P] [--room C] [--workers W] "
                    "[--dimension D] [--checkpoint STEPS] [--seed N]");
  } catch (const Usage& fault) {
    return complain(2, fault.message);
  } catch (const BadInput& fault) {
    return complain(3, fault.what());
  } catch (const std::exception& fault) {
    return complain(4, fault.what());
  }
}
