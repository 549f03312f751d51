#!/bin/bash
# Run by scripts/test-deb in a bare Debian, as its root: what somebody does who has the packages. /clers has them,
# and examples. Whatever fails ends it.
set -euo pipefail
export DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8
install() { apt-get -q install -y --no-install-recommends "$@" >/clers/log 2>&1 || { tail -n 20 /clers/log; exit 1; }; }
# All files, but for what apt and dpkg note down.
files() { find / -xdev \( -path /proc -o -path /sys -o -path /dev -o -path /tmp -o -path /run -o -path /clers \
  -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache -o -path /var/log -o -name __pycache__ \) -prune -o -print | sort; }
cd /clers

echo "== the program, from its packages alone"
install ./libclers0*.deb ./clers-tools*.deb
clers --version
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' >t.off
clers encode t.off
clers verify t.off t.clers
clers decode t.clers -o t.ply
clers info t.clers >info
grep -q position info

echo "== its manual, and completion in bash and zsh"
install man-db bash-completion zsh
# A bare system may be told to leave manuals out; what was told is not our business.
grep -rqs 'path-exclude.*man' /etc/dpkg/dpkg.cfg.d || MANPAGER=cat man clers >manual
grep -q 'clers encode' manual
bash -c '
  . /usr/share/bash-completion/bash_completion
  _completion_loader clers
  COMP_WORDS=(clers enc) COMP_CWORD=1 COMP_LINE="clers enc" COMP_POINT=9
  $(complete -p clers | sed "s/.*-F \([^ ]*\).*/\1/") clers enc clers
  [ "${COMPREPLY[*]}" = encode ] || { echo "bash completes: ${COMPREPLY[*]}"; exit 1; }'
zsh -c 'autoload -U compinit && compinit -u -D && [ "$_comps[clers]" = _clers ]'

echo "== programs in C and C++, by CMake and pkg-config"
install g++ cmake make ./libclers-dev*.deb
cc -std=c99 example/c/main.c -o from_c $(pkg-config --cflags --libs clers-c)
./from_c
g++ -std=c++20 example/main.cc -o from_cpp $(pkg-config --cflags --libs clers)
./from_cpp
cmake -S example/c -B c-build >/clers/log && cmake --build c-build >/clers/log && c-build/from_c
cmake -S example -B build >/clers/log && cmake --build build --target consumer read from_c >/clers/log
build/consumer && build/read && build/from_c
ldd build/from_c >/clers/log
grep -q 'libclers_c\.so\.0\.[0-9]* => /' /clers/log

echo "== installed once more and removed, nothing is left"
packages=$(dpkg-query -W -f '${Package}\n' '*clers*')
dpkg --purge $packages >/clers/log
files >before
dpkg -i ./*.deb >/clers/log
files >between
dpkg --purge $packages >/clers/log
files >after
grep clers between >/clers/log
diff before after
if grep clers after || ldconfig -p | grep clers; then exit 1; fi
