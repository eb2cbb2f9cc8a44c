# capture.zsh SCRIPT WORDS: prints what an interactive zsh offers after WORDS, by the completion script SCRIPT.
# zsh completes at a terminal only, so it gets one.
here=${0:A:h}
export COMPLETION_SCRIPT=$1 COMPLETION_ANSWER=${TMPPREFIX:-/tmp/zsh}.$$
zmodload zsh/zpty || exit 77
zpty terminal "zsh -f -i" || exit 77
zpty -w terminal "source $here/offered.zsh"
zpty -r terminal said '*completion is rea''dy*' || exit 77
zpty -w -n terminal "$2"$'\t'
while zpty -r terminal said; do :; done 2>/dev/null
cat $COMPLETION_ANSWER
rm -f $COMPLETION_ANSWER
