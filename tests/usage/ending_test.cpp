// What a signal ends says so in one line, and leaves no file that is not whole.
#include "cases.hpp"

namespace changeover::test::ending_test {
namespace {

struct Signal {
  std::string name;
  std::string said;
  int code;
};

const std::vector<Signal> signals = {{"INT", "Ctrl-C", 130},
                                     {"TERM", "SIGTERM", 143},
                                     {"HUP", "SIGHUP", 129},
                                     {"QUIT", "SIGQUIT", 131}};

std::string line_of_end(const Signal& signal) {
  return "changeover: stopped by " + signal.said + " before the end\n";
}

// Starts `command`, sends the signal once `ready` holds, and ends with the code of the command.
std::string sent(const Signal& signal, const std::string& command, const std::string& ready) {
  return "ulimit -c 0; env --default-signal " + command + " & pid=$!; until " + ready +
         " || ! kill -0 $pid; do sleep 0.02; done; { kill -" + signal.name +
         " $pid; wait $pid; code=$?; } 2>/dev/null; ";
}

TEST(Ending, ASignalKeepsTheOldFileAndLeavesNoOther) {
  for (const Signal& signal : signals) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run("echo old >x.txt; " +
                sent(signal, "$changeover design 65535 4 --format text -o x.txt",
                     "compgen -G '.x.txt.*.tmp' >/dev/null") +
                "ls -A; cat x.txt; exit $code",
            folder.path());
    EXPECT_EQ(outcome.code, signal.code) << signal.name << outcome.err;
    EXPECT_EQ(outcome.err, line_of_end(signal));
    EXPECT_EQ(outcome.out, "x.txt\nold\n") << signal.name;
  }
}

TEST(Ending, AVerbWithoutAFileSaysSoToo) {
  for (const std::string verb : {"table --k 3..60 --v 5..900", "factorize 20000"}) {
    const TemporaryFolder folder;
    const Outcome outcome = run(sent(signals.front(), "$changeover " + verb + " >/dev/null",
                                     "(($(cut -d ' ' -f 14 /proc/$pid/stat) >= 10))") +
                                    "exit $code",
                                folder.path());
    EXPECT_EQ(outcome.code, 130) << verb;
    EXPECT_EQ(outcome.err, line_of_end(signals.front())) << verb;
  }
}

}  // namespace
}  // namespace changeover::test::ending_test
