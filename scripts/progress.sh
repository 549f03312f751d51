# shellcheck shell=bash
# with_progress WHAT LOG COMMAND...: runs a command with its output in a log and shows meanwhile how far it is: the
# count that ninja, ctest, `compare` or apt printed last. In a terminal that is one line, written again each second and
# gone at the end; elsewhere a line a minute. Ends as the command does. To be sourced.
with_progress() {
  local what=$1 log=$2 watch status=0
  shift 2
  : >"$log"
  watch_progress "$what" "$log" </dev/null &
  watch=$!
  "$@" >"$log" 2>&1 </dev/null || status=$?
  kill "$watch" 2>/dev/null
  wait "$watch" 2>/dev/null || true
  [ ! -t 1 ] || printf '\r\033[K'
  return $status
}

watch_progress() {
  local seconds=0 count
  while sleep 1 >/dev/null && kill -0 $$ 2>/dev/null; do  # $$: an interrupted script takes it along
    seconds=$((seconds + 1))
    [ -t 1 ] || ((seconds % 60 == 0)) || continue
    # [12/77] (ninja), 12/77 Test (ctest), [pass 1/2, mesh 3/5] (compare), pmstatus:g++:34.5: (apt)
    count=$(tail -c 4000 "$2" | sed -nE 's/^\[([^]]*[0-9]+\/[0-9]+)\].*/\1/p; s/^ *([0-9]+\/[0-9]+) Test .*/\1/p;
      s/^(dl|pm)status:[^:]*:([0-9]+).*/\2 %/p' | tail -n 1)
    if [ -t 1 ]; then
      printf '\r\033[K        %s: %s%d s' "$1" "${count:+$count, }" "$seconds"
    else
      printf '        %s: %safter %d s\n' "$1" "${count:+$count }" "$seconds"
    fi
  done
}
