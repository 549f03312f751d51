#!/bin/bash
# Programs compiled before rely on the symbols of libclers_c, on where fields of structs are, and on numbers. What
# is in abi.txt may be added to; what changes there breaks them, and then SOVERSION must change.
# usage: [UPDATE=1] abi_test.sh LIBRARY PRINTER
# With UPDATE=1 the record is written anew.
set -euo pipefail
here=$(dirname "$0")
now=$(mktemp)
trap 'rm -f "$now"' EXIT
{
  nm -D --defined-only "$1" | awk '$2 != "A" { print $2, $3 }' | sort
  "$2"
} >"$now"
if [ -n "${UPDATE:-}" ]; then
  cp "$now" "$here/abi.txt"
fi
diff "$here/abi.txt" "$now" || { echo "the ABI is not that of $here/abi.txt (<: recorded, >: now)"; exit 1; }
# Fields and numbers that the printer forgets could change unseen.
for word in $(sed 's,//.*,,' "$here/../clers.h" | grep -oE '\bCLERS_[A-Z0-9_]+\b' | grep -vxE 'CLERS_(H|C_.*)' | sort -u); do
  grep -q "^$word " "$now" || { echo "$word is not recorded"; exit 1; }
done
for field in $(sed 's,//.*,,' "$here/../clers.h" | awk '/^typedef struct .*\{/ { inside = 1; next } /^\}/ { inside = 0 } inside' |
  sed 's/\[[0-9]*\]//' | tr ',' '\n' | sed -nE 's/.*\b([a-z_0-9]+)[; ]*$/\1/p' | sort -u); do
  grep -q "^  $field " "$now" || { echo "$field is not recorded"; exit 1; }
done
