// changeover completion bash
#include "answer/answer.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct CompletionRequest {
  const Program* program = nullptr;
  std::string shell;
};

Answer run(const CompletionRequest& request) {
  return text_answer(request.program->bash_completion(), {});
}

}  // namespace

void add_completion(Program& program) {
  auto [verb, request] = program.add("completion", "print a completion script for a shell", run);
  request.program = &program;
  verb.choice("SHELL", request.shell, {"bash"}, "the shell (bash)");
  verb.examples({"source <(changeover completion bash)"});
}

}  // namespace changeover::cli
