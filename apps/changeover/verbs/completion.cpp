// changeover completion bash
#include <memory>
#include <string>

#include "request/request.hpp"
#include "verbs.hpp"

namespace changeover::cli {

void add_completion(Program& program) {
  auto shell = std::make_shared<std::string>("bash");
  Verb& verb = program.add("completion", "print a completion script for a shell");
  verb.choice("SHELL", *shell, {"bash"}, "the shell (bash)");
  verb.examples({"source <(changeover completion bash)"});
  verb.run([shell, &program] {
    deliver(program.bash_completion(), "-");
    return exit_code::done;
  });
}

}  // namespace changeover::cli
