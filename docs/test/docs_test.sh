#!/bin/bash
# What the pages in docs name is there: commands and options in the help of the program, names of C and C++ in the headers,
# and those of Draco and meshoptimizer in theirs, where these are installed.
# usage: docs_test.sh PROGRAM
set -uo pipefail
root=$(realpath "$(dirname "$0")/../..") clers=$1
missing=0
say() { echo "$1: $2"; missing=$((missing + 1)); }
has() { grep -qwF -e "$2" $1; }

for page in "$root"/docs/*.md; do
  name=${page##*/} spans=$(mktemp)
  { grep -o '`[^`]*`' "$page" | tr -d '`'; sed -n 's/^    //p' "$page"; } >"$spans"

  commands=0
  while read -r line; do
    set -f
    set -- $line
    set +f
    [ "$1" = clers ] || continue
    commands=$((commands + 1))
    help=$("$clers" help "${2:-}") || { say "$name" "no command: $line"; continue; }
    for word in "${@:3}"; do
      case $word in
        -[1-9]) ;;
        -*) grep -qE -e "(^|[ ,])$word([ ,]|\$)" <<<"$help" || say "$name" "no option $word: $line" ;;
      esac
    done
  done <"$spans"
  ((commands > 0)) || say "$name" "no command was found to look at"

  for word in $(grep -oE '\b(clers_[a-z_]+|CLERS_[A-Z_]+)(::[a-z_]+)?' "$spans" | sed 's/::/ /' | tr ' ' '\n' | sort -u); do
    has "$root/bindings/c/clers.h" "$word" || say "$name" "$word is not in clers.h"
  done
  for word in $(grep -vE '^(draco|meshopt)' "$spans" | grep -oE '\b[A-Za-z]+::[A-Za-z_]+' | sed 's/::/ /' | tr ' ' '\n' | sort -u); do
    has "$(echo "$root"/codec/*.h)" "$word" || say "$name" "$word is in no header"
  done
  if [ -f /usr/include/draco/compression/encode.h ]; then
    for word in $(grep -oE 'draco::[A-Za-z]+(::[A-Za-z]+)?' "$spans" | sed 's/.*:://' | sort -u); do
      grep -rqw "$word" /usr/include/draco || say "$name" "Draco has no $word"
    done
  fi
  if [ -f /usr/include/meshoptimizer.h ]; then
    for word in $(grep -oE 'meshopt_[A-Za-z]+' "$spans" | sort -u); do
      has /usr/include/meshoptimizer.h "$word" || say "$name" "meshoptimizer has no $word"
    done
  fi
  rm -f "$spans"
done
((missing == 0))
