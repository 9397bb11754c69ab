# bash completion of hfrac. Written by viz/command/make-manual.
_hfrac() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options='' first='' values='' files=''
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    mapfile -t COMPREPLY < <(compgen -W 'new pack run resume check export info catalogue analyse dfn sweep match options view lab calibrate render plot report --help --version' -- "$word")
    return
  fi
  case ${COMP_WORDS[1]} in
    new)
      options='--help --output --overwrite'
      first='fracture minifrac record record-study hour crossing stress-shadow cold-water paper smoke'
      case $before in
        -o|--output) files=yes ;;
      esac
      ;;
    pack)
      options='--help --output --discs --bonds --seed --workers --quiet'
      case $before in
        -o|--output|--discs|--bonds|--seed|--workers) files=yes ;;
      esac
      ;;
    run)
      options='--help --output --discs --bonds --grid --steps --workers --checkpoint-every --checkpoint-steps --no-space-check --one-model --overwrite --movie --quiet'
      case $before in
        -o|--output|--discs|--bonds|--grid|--steps|--workers|--checkpoint-every|--checkpoint-steps) files=yes ;;
      esac
      ;;
    resume)
      options='--help --steps --workers --one-model --quiet'
      case $before in
        --steps|--workers) files=yes ;;
      esac
      ;;
    check)
      options='--help'
      ;;
    export)
      options='--help --output --cells --dx'
      case $before in
        -o|--output|--cells|--dx) files=yes ;;
      esac
      ;;
    info)
      options='--help --devices'
      ;;
    catalogue)
      options='--help --distance --seconds --cycles --thickness --shear-modulus --slip-rate --completeness --quakeml --start --latitude --longitude --depth --azimuth --diffusivity --width --print --dark --svg --pdf --quiet'
      case $before in
        --distance|--seconds|--cycles|--thickness|--shear-modulus|--slip-rate|--completeness|--quakeml|--start|--latitude|--longitude|--depth|--azimuth|--diffusivity|--width|--print) files=yes ;;
      esac
      ;;
    analyse)
      options='--help --output --shut-in --injection-time --thickness --leak-off --picture --width --print --dark --quiet'
      case $before in
        --leak-off) values='little most' ;;
        -o|--output|--shut-in|--injection-time|--thickness|--picture|--width|--print) files=yes ;;
      esac
      ;;
    dfn)
      options='--help --set --size --through --seed --output --describe --touching --picture --width --print --dark --quiet'
      case $before in
        --set|--size|--through|--seed|-o|--output|--describe|--touching|--picture|--width|--print) files=yes ;;
      esac
      ;;
    sweep)
      options='--help --output --jobs --retry --quiet --collect --only --slurm --runs-per-job --cpus --minutes --memory --sbatch'
      case $before in
        -o|--output|--jobs|--only|--runs-per-job|--cpus|--minutes|--memory|--sbatch) files=yes ;;
      esac
      ;;
    match)
      options='--help --output --jobs --retry --quiet'
      case $before in
        -o|--output|--jobs) files=yes ;;
      esac
      ;;
    options)
      options='--help'
      ;;
    view)
      options='--help --record --port --no-open'
      case $before in
        --record|--port) files=yes ;;
      esac
      ;;
    lab)
      options='--help --discs --seed --packings --width --confining --slit --output --time --quiet'
      first='elastic tension uniaxial biaxial brazilian centre-crack sent pressurised-crack permeability'
      case $before in
        --discs|--seed|--packings|--width|--confining|--slit|-o|--output) files=yes ;;
      esac
      ;;
    calibrate)
      options='--help --E --nu --ucs --tension --K --permeability --slopes --packings --discs --strength-discs --seed --output --quiet'
      case $before in
        --E|--nu|--ucs|--tension|--K|--permeability|--packings|--discs|--strength-discs|--seed|-o|--output) files=yes ;;
      esac
      ;;
    render)
      options='--help --width --print --dark --height --movie --no-movie --follow --svg --pdf --quiet --view --output --zoom --snapshot'
      case $before in
        --view) values='discs bonds forces crack-time aperture crack-pressure pressure displacement displacement-x displacement-y rotation stress stress-xx stress-yy stress-xy shear intact-bonds temperature fluid-temperature joint-aperture joint-slip joint-pressure joint-state' ;;
        --width|--print|--height|--movie|-o|--output|--zoom|--snapshot) files=yes ;;
      esac
      ;;
    plot)
      options='--help --width --print --dark --svg --pdf --quiet --kgd --record --record-offset --compare --x --y --series --output --title'
      case $before in
        --y) values='cracks tensile-cracks shear-cracks length width extent reach wings volume injected leak-off tip pressure rate initiation-pressure' ;;
        --width|--print|--record|--record-offset|--compare|--x|--series|-o|--output|--title) files=yes ;;
      esac
      ;;
    report)
      options='--help --output --width --no-movie --fresh --quiet'
      case $before in
        -o|--output|--width) files=yes ;;
      esac
      ;;
  esac
  if [ -n "$values" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$values" -- "$word")
  elif [ -n "$files" ]; then
    return  # names of files, by -o default
  elif [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [ "$COMP_CWORD" -eq 2 ]; then
    mapfile -t COMPREPLY < <(compgen -W "$first" -- "$word")
  fi
}
complete -o default -F _hfrac hfrac
