# shellcheck shell=bash disable=SC2034
# What the tests of the program share. usage: . harness.sh PROGRAM
# Works in a new folder that is removed again; check and ends count in $passed and $failed.
set -u
clers=$(realpath "$1")
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export LC_ALL=C TERM=xterm
passed=0 failed=0 status=0

# check NAME CONDITION...: counts one case.
check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    echo "FAILED: $name"
    echo "  status $status; stderr: $(head -c 500 err)"
  fi
}
# run ARGUMENTS...: runs the program; sets $status, and the files out and err.
run() {
  "$clers" "$@" >out 2>err </dev/null
  status=$?
}
# ends NAME STATUS [PATTERN]: the last run ended so, with one line on stderr that matches, or with no complaint.
ends() {
  check "$1: status $2" test "$status" -eq "$2"
  if [ $# -gt 2 ]; then
    check "$1: says $3" grep -qE "^clers: .*$3" err
    check "$1: one line" test "$(wc -l <err)" -eq 1
  else
    check "$1: does not complain" eval '! grep -q "^clers: " err'
  fi
}
silent() { check "$1: says nothing" test ! -s err -a ! -s out; }
no_leftovers() { check "$1: no temporary files" test -z "$(find "${2:-.}" -name '.clers-*')"; }

# grid N: an open grid of 2 N^2 triangles as OBJ.
grid() {
  awk -v n="$1" 'BEGIN {
    for (i = 0; i <= n; i++) for (j = 0; j <= n; j++) print "v", i, j, (i * 7919 + j * 104729) % 1009 / 1008
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
      a = i * (n + 1) + j + 1; b = a + n + 1
      print "f", a, b, b + 1; print "f", a, b + 1, a + 1
    } }'
}
tetrahedron() { printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n'; }

finish() {
  echo "$passed passed, $failed failed"
  test $failed -eq 0
}
