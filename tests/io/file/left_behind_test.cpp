#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "changeover/io/output.hpp"
#include "run_program.hpp"

namespace changeover::left_behind_test {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

// The number of a process that is no more.
pid_t gone() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
  return child;
}

void write(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

TEST(LeftBehind, WhatAKilledProcessLeftGoesAwayWhenTheFileIsWrittenNext) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("mine.json");
  const pid_t child = ::fork();
  if (child == 0) {
    OutputFile file(path);
    file.write("half");
    file.flush();
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_EQ(names_in(folder.path()).size(), 1U);
  write(path, "whole");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"mine.json"});
  EXPECT_EQ(test::slurp(path), "whole");
}

TEST(LeftBehind, WhatIsSomebodysStays) {
  const test::TemporaryFolder folder;
  const std::string number = std::to_string(gone());
  const std::set<std::string> others{
      ".a.json." + number + "-0.tmp",    // of another file
      ".mine." + number + ".tmp",        // not named as ours
      ".mine." + number + "-x.tmp",      //
      ".mine." + number + "-1.tmp.old",  //
      ".mine.-5-1.tmp",                  // no process
      ".mine.1-0.tmp",                   // of a process that is there
      "mine." + number + "-0.tmp",       // no hidden file
      ".mine." + number + "-7.tmp",      // held by another process
  };
  for (const std::string& name : others) {
    test::spit(folder.path() / name, "precious");
  }
  std::filesystem::create_directory(folder.path() / (".mine." + number + "-8.tmp"));
  std::filesystem::create_symlink("elsewhere", folder.path() / (".mine." + number + "-9.tmp"));
  test::spit(folder.path() / (".mine." + number + "-0.tmp"), "left");
  const int held = ::open(folder.file(".mine." + number + "-7.tmp").c_str(), O_RDONLY);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  write(folder.file("mine"), "text");
  ::close(held);
  std::set<std::string> expected = others;
  expected.insert({"mine", ".mine." + number + "-8.tmp", ".mine." + number + "-9.tmp"});
  EXPECT_EQ(names_in(folder.path()), expected);
}

// As in containers, where each run is process 1.
TEST(LeftBehind, WhatAProcessOfOurNumberLeftGoesAwayAndWhatIsOursStays) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("mine");
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string name = ".mine." + std::to_string(::getpid());
    for (int i = 0; i < 200; ++i) {
      test::spit(folder.path() / (name + "-" + std::to_string(i) + ".tmp"), "left");
    }
    OutputFile first(path);
    write(folder.file("./mine"), "second");  // looks at the folder once more
    first.write("first");
    first.commit();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(test::slurp(path), "first");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"mine"});
}

// Between the two it would have no owner, and its process may be one that others do not see.
TEST(LeftBehind, ATemporaryIsLockedUntilItHasItsName) {
  const test::TemporaryFolder folder;
  const int events = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
  ASSERT_GE(events, 0);
  ASSERT_GE(::inotify_add_watch(events, folder.path().c_str(), IN_CLOSE_WRITE | IN_MOVED_TO), 0);
  write(folder.file("mine"), "text");
  alignas(inotify_event) std::array<char, 4096> buffer = {};
  const ssize_t bytes = ::read(events, buffer.data(), buffer.size());
  ::close(events);
  std::vector<std::uint32_t> seen;
  for (ssize_t at = 0; at < bytes;) {
    inotify_event event = {};
    std::memcpy(&event, buffer.data() + at, sizeof event);
    seen.push_back(event.mask);
    at += static_cast<ssize_t>(sizeof event + event.len);
  }
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{IN_MOVED_TO, IN_CLOSE_WRITE}));
}

TEST(LeftBehind, TwoThatWriteTheSameFileDoNotTakeEachOthers) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("mine");
  OutputFile first(path);
  first.write("first");
  const pid_t child = ::fork();
  if (child == 0) {
    write(path, "second");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(test::slurp(path), "second");
  first.commit();
  EXPECT_EQ(test::slurp(path), "first");
  EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"mine"});
}

}  // namespace
}  // namespace changeover::left_behind_test
