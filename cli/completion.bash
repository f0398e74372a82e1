# bash completion for stoss

_stoss() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  local disk="--poisson --young --density --radius --plane"
  local output="--format -o --output --quiet -h --help"
  COMPREPLY=()

  case $previous in
    --format) COMPREPLY=($(compgen -W "table csv json" -- "$current")); return ;;
    --plane) COMPREPLY=($(compgen -W "stress strain" -- "$current")); return ;;
    --wall) COMPREPLY=($(compgen -W "hard exponential" -- "$current")); return ;;
    --tail) COMPREPLY=($(compgen -W "radiating static" -- "$current")); return ;;
    --law) COMPREPLY=($(compgen -W "center diameter printed" -- "$current")); return ;;
    --method) COMPREPLY=($(compgen -W "converge extrapolate" -- "$current")); return ;;
    -o | --output | --trajectory | --resume)
      compopt -o filenames
      mapfile -t COMPREPLY < <(compgen -f -- "$current")
      return
      ;;
    --poisson | --young | --density | --radius | --cutoff | --speed | --compression | --hardness | --strength | --step | \
      --nodes | --every | --tolerance | --threads) return ;;
  esac

  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "modes impact restitution quasistatic --help --version" -- "$current"))
    return
  fi
  case ${COMP_WORDS[1]} in
    modes) COMPREPLY=($(compgen -W "$disk --cutoff $output" -- "$current")) ;;
    impact)
      COMPREPLY=($(compgen -W "$disk --speed --wall --hardness --strength --tail --cutoff --step --nodes --trajectory \
        --every $output" -- "$current"))
      ;;
    restitution)
      COMPREPLY=($(compgen -W "$disk --speed --method --tolerance --threads --resume $output" -- "$current"))
      ;;
    quasistatic) COMPREPLY=($(compgen -W "$disk --speed --compression --law --cutoff $output" -- "$current")) ;;
  esac
}

complete -F _stoss stoss
