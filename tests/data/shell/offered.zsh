# Read by an interactive zsh: the next Tab writes what is offered to $COMPLETION_ANSWER, with its description, and ends the shell.
PROMPT=
autoload -Uz compinit && compinit -u -D
source $COMPLETION_SCRIPT
bindkey '^I' complete-word
: >$COMPLETION_ANSWER
end_at_once() { exit }
comppostfuncs=(end_at_once)
compadd() {
  if [[ ${@[1,(i)(-|--)]} == *-(O|A|D)\ * ]]; then # only asks
    builtin compadd "$@"
    return
  fi
  local -a matches shown
  local at=${@[(i)-d]} name
  if ((at < $#)); then
    name=${@[at + 1]}
    [[ $name == \(* ]] && eval "shown=$name" || shown=("${(@P)name}")
  fi
  builtin compadd -A matches -D shown "$@"
  local i
  for ((i = 1; i <= $#matches; ++i)); do
    print -r -- "$matches[i]|$shown[i]" >>$COMPLETION_ANSWER
  done
  builtin compadd "$@"
}
print "completion is rea""dy"
