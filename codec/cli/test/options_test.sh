#!/bin/bash
# The help, the manual and the completions must name the options that the parser has, for every command.
# usage: options_test.sh PROGRAM MANUAL COMPLETIONS
manual=$(realpath "$2") completions=$(realpath "$3")
. "$(dirname "$0")/harness.sh" "$1"
touch err

commands=$("$clers" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
check "help names the commands" test "$(echo $commands)" = "encode decode info verify check subdivide adapt simplify reconstruct help"

run --help; mv out asked; run help
check "clers help is clers --help" cmp -s asked out
for command in $commands; do
  run $command --help; mv out asked; run help $command
  check "clers help $command is clers $command --help" cmp -s asked out
  check "its lines fit 80 columns" eval '! grep -E "^.{81}" out'
done

# Options of a command as its help has them, the names of one option on a line: "-o --output".
for command in $commands ""; do
  "$clers" $command --help | sed -n '/^Options:/,/^$/s/^  \(-[^ ]*\).*/\1/p' | tr , ' ' |
    sed 's/^-1$/-1\n-2\n-3\n-4\n-5\n-6\n-7\n-8\n-9/' >"options of $command"
done
groups() { cat "options of $1"; }
names() { tr ' ' '\n' | sort -u; }

# Every option that the help names is one to the parser, which says so by what it complains of.
for command in $commands; do
  for option in $(groups "$command"); do
    "$clers" $command "$option" >out 2>err </dev/null
    check "clers $command knows $option" eval '! grep -q "unknown option" err'
  done
done
# And the parser has no others: it would not call these unknown.
for command in $commands ""; do
  groups "$command" | names >known
  for option in $(for other in $commands ""; do groups "$other"; done | names) -n -x -v --verbose --file; do
    grep -qxe "$option" known && continue
    "$clers" $command "$option" x y >out 2>err </dev/null
    check "clers $command does not know $option" grep -q "unknown option '$option'" err
  done
done

# ---- The manual: the synopsis of each command, and the list of options
synopsis() {
  awk -v command="$1" '
    /^\.Sh/ { in_it = $2 == "SYNOPSIS"; next }
    /^\.Nm/ { mine = 0 }
    /^\.Cm/ && in_it { mine = $2 == command; next }
    in_it && mine' "$manual" |
    sed -n 's/^\.\(Op \)\{0,1\}Fl \(-*\)\([^ ]*\).*/\2 \3/p; s/^\.Op Ar limits.*/limits/p' |
    while read -r dash letters; do
      case $dash in
        limits) printf '%s\n' --max-memory --max-vertices --max-faces --max-meshes ;;
        -) echo "--$letters" ;;
        *) grep -o . <<<"$dash" | sed 's/^/-/' ;;
      esac
    done
}
for command in $commands; do
  synopsis "$command" | names >in_manual
  groups "$command" | names >in_help
  check "the synopsis of $command names nothing else" test -z "$(comm -23 in_manual in_help)"
  groups "$command" | grep -v -e '--help' | while read -r option; do
    grep -qxF -e "$(tr ' ' '\n' <<<"$option")" in_manual || echo "$option"
  done >missing
  check "the synopsis of $command has all: $(echo $(<missing))" test ! -s missing
done
sed -n '/^\.Sh OPTIONS/,/^\.Sh JSON/s/^\.It Fl //p' "$manual" | sed 's/\(Ar\|Cm\) [^,]*//g; s/Fl//g' | tr , '\n' |
  tr -d ' ' | sed 's/^/-/' | names >in_manual
for command in $commands ""; do groups "$command"; done | names >in_help
check "the manual has all options: $(comm -3 in_help in_manual | tr '\n' ' ')" cmp -s in_help in_manual
for code in 0 1 2 3 4 5 6; do
  check "the manual has status $code" grep -qx "\.It $code" "$manual"
done
if command -v mandoc >/dev/null; then
  mandoc -T lint -W warning "$manual" >out 2>&1
  check "mandoc has nothing to say: $(head -n 1 out)" test ! -s out
else
  echo "not tested: the manual's markup (needs mandoc)"
fi

# ---- Completion for bash
_init_completion() { words=("${COMP_WORDS[@]}") cword=$COMP_CWORD cur=${words[cword]} prev=${words[cword - 1]}; }
_filedir() { COMPREPLY=("files of ${1:-any kind}"); }
. "$completions/clers.bash"
completed() {
  COMP_WORDS=(clers "$@") COMP_CWORD=$#
  COMPREPLY=()
  _clers
  printf '%s\n' "${COMPREPLY[@]}"
}
for command in $commands; do
  groups "$command" | names >in_help
  completed "$command" - | names >completed
  check "bash completes $command: $(comm -3 in_help completed | tr '\n' ' ')" cmp -s in_help completed
done
check "bash completes commands" test "$(echo $(completed ""))" = "$(echo $commands $(groups ""))"
check "bash completes values" test "$(echo $(completed subdivide --scheme ""))" = "sqrt3 loop 4-8"
check "bash completes files" test "$(completed decode "")" = "files of clers"

# ---- Completion for zsh
if command -v zsh >/dev/null; then
  cat >complete.zsh <<'ZSH'
    command=$2
    _arguments() {
      if [[ -n $state ]]; then print -l -- "$@"; else state=arguments line=($command); fi
    }
    compdef() { }
    eval "$(sed '$d' "$1")"
    _clers
ZSH
  for command in $commands; do
    groups "$command" | names >in_help
    zsh -f complete.zsh "$completions/_clers" "$command" |
      sed -n 's/^\*\{0,1\}\(([^)]*)\)\{0,1\}\(-[-a-zA-Z0-9]*\)\[.*/\2/p' | grep -vx -e -s | names >completed
    check "zsh completes $command: $(comm -3 in_help completed | tr '\n' ' ')" cmp -s in_help completed
  done
else
  echo "not tested: completion for zsh (needs zsh)"
fi
finish
