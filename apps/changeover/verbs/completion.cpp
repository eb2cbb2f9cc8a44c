// changeover completion bash|zsh|fish
#include "shell/completion.hpp"

#include "answer/answer.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CompletionRequest {
  const Program* program = nullptr;
  std::string shell;
  OutputRequest output;
};

Answer run(const CompletionRequest& request) {
  return text_answer(completion_script(*request.program, shell_from_string(request.shell).value()),
                     request.output);
}

}  // namespace

void add_completion(Program& program) {
  auto [verb, request] =
      program.add<CompletionRequest>("completion", "print a completion script for a shell", run);
  request.program = &program;
  verb.choice("SHELL", request.shell, shell_names(), "the shell: bash, zsh or fish");
  request.output.add_file_to(verb, {".bash", ".zsh", ".fish", ".sh", ".txt"});
  verb.examples({"source <(changeover completion bash)", "source <(changeover completion zsh)",
                 "changeover completion fish | source"});
}

}  // namespace changeover::cli
