# Completion of clers for bash. test/options_test.sh compares the options with those of the program.
_clers() {
  local cur prev words cword
  _init_completion -n = || return

  local command="" i
  for ((i = 1; i < cword; ++i)); do
    [[ ${words[i]} == -* ]] || { command=${words[i]} && break; }
  done
  if [[ -z $command ]]; then
    COMPREPLY=($(compgen -W "encode decode info verify check subdivide adapt simplify reconstruct help -h --help -V --version" -- "$cur"))
    return
  fi

  case $prev in
    --from) COMPREPLY=($(compgen -W "ply obj off stl glb gltf drc" -- "$cur")) && return ;;
    --to) COMPREPLY=($(compgen -W "ply obj off stl glb gltf" -- "$cur")) && return ;;
    --level) [[ $command == adapt ]] || COMPREPLY=($(compgen -W "1 2 3 4 5 6 7 8 9" -- "$cur")) && return ;;
    --order) COMPREPLY=($(compgen -W "free keep" -- "$cur")) && return ;;
    --positions)
      COMPREPLY=($(compgen -W "lossless q step error grid:" -- "$cur"))
      [[ ${COMPREPLY[*]} == lossless ]] || compopt -o nospace 2>/dev/null
      return ;;
    --pieces) COMPREPLY=($(compgen -W "never" -- "$cur")) && return ;;
    --on-nonmanifold | --on-degenerate | --on-duplicate)
      COMPREPLY=($(compgen -W "keep reject" -- "$cur")) && return ;;
    --scheme) COMPREPLY=($(compgen -W "sqrt3 loop 4-8" -- "$cur")) && return ;;
    --base) COMPREPLY=($(compgen -W "input" -- "$cur")) && return ;;
    --frames) _filedir -d && return ;;
    --piece | --attribute | --times | --near | --edge-length | --error | --faces | --radius | -T | --threads | --max-*) return ;;
    -o | --output) _filedir && return ;;
  esac

  local limits="--max-memory --max-vertices --max-faces --max-meshes"
  local meshes="@(ply|obj|off|stl|glb|gltf|drc)" options files
  case $command in
    encode)
      options="-h --help -o --output -c --stdout --from -1 -2 -3 -4 -5 -6 -7 -8 -9 --level --order --pieces
        --positions --attribute -T --threads --on-nonmanifold --on-degenerate --on-duplicate --strict --rm -k --keep -f --force
        -q --quiet"
      files=$meshes ;;
    decode)
      options="-h --help -o --output -c --stdout --to --text --piece -T --threads $limits --rm -k --keep
        -f --force -q --quiet"
      files=clers ;;
    info)
      options="-h --help --json $limits"
      files=clers ;;
    verify)
      options="-h --help --from --strict -T --threads $limits -q --quiet"
      files="@(ply|obj|off|stl|glb|gltf|drc|clers)" ;;
    check)
      options="-h --help --from --json -q --quiet"
      files=$meshes ;;
    subdivide)
      options="-h --help -o --output -c --stdout --scheme --times --from --to --text -f --force -q --quiet"
      files=$meshes ;;
    adapt)
      options="-h --help -o --output -c --stdout --level --near --edge-length --error --max-faces --base --frames
        --json --from --to --text -f --force -q --quiet"
      files=$meshes ;;
    simplify)
      options="-h --help -o --output -c --stdout --faces --error --json --from --to --text -f --force -q --quiet"
      files=$meshes ;;
    reconstruct)
      options="-h --help -o --output -c --stdout --radius --json --from --to --text -f --force -q --quiet"
      files=$meshes ;;
    help)
      COMPREPLY=($(compgen -W "encode decode info verify check subdivide adapt simplify reconstruct -h --help" -- "$cur"))
      return ;;
    *) return ;;
  esac
  if [[ $cur == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$cur"))
  else
    _filedir "$files"
  fi
} && complete -F _clers clers
