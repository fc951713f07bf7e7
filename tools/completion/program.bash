# Bash completion for the program that this file is named after; installed once for each.
#
# Options, words and endings are read from the program's own --help when they are first asked for, so
# nothing here is out of date. What --help says is what is completed:
#   - a description that begins with a list of words ("auto, ply or xyz; ...") completes to them;
#   - endings in it (".ply", "OUT.vtk") are those of the files that are shown, without any all are;
#   - DIR stands for a folder, SIZE for 512M and the like, COLOR for what colours say; N, V, X,Y,Z and
#     others for what only the user knows;
#   - an argument that is described "below" completes to the words listed there.

declare -gA _stream_recon_helps 2>/dev/null

# Sets `words` to the list that a description begins with, and to those of ENUM:{word->number,...}.
_stream_recon_words() {
  local value=$1 text=$2 word
  words=()
  if [[ $value == 'ENUM:{'* ]]; then
    value=${value#*\{}
    for word in ${value//[,\}]/ }; do words+=("${word%%->*}"); done
    return
  fi
  while [[ $text =~ ^(.*[^ ])?' '*\([^\)]*\)(.*)$ ]]; do
    text=${BASH_REMATCH[1]}${BASH_REMATCH[2]}
  done
  text=${text%%;*}
  text=${text#*: }
  local item='[a-z0-9][a-z0-9-]*'
  [[ $text =~ ^$item((', '$item)*(,? or .*)|(', '$item)+)$ ]] || return
  text=${text//, or / }
  text=${text//, / }
  for word in ${text// or / }; do
    [[ $word =~ ^$item$ ]] || break
    words+=("$word")
  done
}

# Sets `words` to the words that a help lists under headings other than its own.
_stream_recon_listed_words() {
  local line in_list=""
  words=()
  while IFS= read -r line; do
    case $line in
      Positionals: | Options:) in_list= ;;
      [A-Z]*:) in_list=yes ;;
      '  '[a-z]*) [[ $in_list ]] && words+=("$(read -r word _ <<<"$line" && printf %s "$word")") ;;
    esac
  done <<<"$1"
}

# Completes `current` to files with the endings that a description names, and to folders.
_stream_recon_files() {
  local text=$1 ending path
  local -a endings=()
  while [[ $text =~ \.([a-z][a-z0-9]*(\.gz)?)(.*)$ ]]; do
    endings+=("${BASH_REMATCH[1]}")
    text=${BASH_REMATCH[3]}
  done
  compopt -o filenames 2>/dev/null
  while IFS= read -r path; do
    if [[ -d $path || ${#endings[@]} == 0 ]]; then
      COMPREPLY+=("$path")
      continue
    fi
    for ending in "${endings[@]}"; do
      [[ $path == *".$ending" ]] && COMPREPLY+=("$path") && break
    done
  done < <(compgen -f -- "$current")
}

# Completes `current` to what an option or argument takes, from its value's name and description.
_stream_recon_value() {
  local value=${1%%=*} text=$2 before=""
  local -a words
  case $value in
    SIZE) words=(64M 128M 256M 512M 1G 2G 4G 8G 16G) ;;
    N | R | RATIO | S | V | X,Y,Z | I:* | BYTES | DEG | ID | PIXELS | INT* | UINT* | FLOAT*) return ;;
    COLOR) words=(Delta Source Closure component none) ;;
    DIR)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$current")
      return
      ;;
    *) _stream_recon_words "$value" "$text" ;;
  esac
  if [[ ${#words[@]} == 0 && $text == *' below'* ]]; then _stream_recon_listed_words "$help"; fi
  if [[ ${#words[@]} == 0 ]]; then
    _stream_recon_files "$text"
    return
  fi
  [[ $value == LIST && $current == *,* ]] && before=${current%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "${words[*]}" -- "${current#"$before"}")
}

_stream_recon_complete() {
  local program=$1 current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
  [[ ${_stream_recon_helps[$program]-} ]] ||
    _stream_recon_helps[$program]=$("${program/#\~\//$HOME/}" --help 2>/dev/null)
  local help=${_stream_recon_helps[$program]}
  # "--option=value" comes as three words.
  if [[ $current == = ]]; then
    current=
  elif [[ $previous == = ]] && ((COMP_CWORD > 2)); then
    previous=${COMP_WORDS[COMP_CWORD - 2]}
  fi

  local line next name value text argument_value="" argument_text=""
  local -a options=() names
  local option='^  (-[^ ]+)( ([A-Z]([^ ]*[^ :])?))?( REQUIRED)?( (Needs|Excludes): [^ ]+)*(  +(.*))?$'
  local argument='^  ([^ -][^ ]*) ([A-Z][^ ]*)( \.\.\.)?( REQUIRED)?(  +(.*))?$'
  local -a lines
  mapfile -t lines <<<"$help"
  local i
  for ((i = 0; i < ${#lines[@]}; ++i)); do
    line=${lines[i]} next=${lines[i + 1]-}
    [[ $next == '          '* ]] && line+=$next
    if [[ $line =~ $option ]]; then
      IFS=, read -ra names <<<"${BASH_REMATCH[1]}"
      value=${BASH_REMATCH[3]} text=${BASH_REMATCH[9]}
      for name in "${names[@]}"; do
        [[ $name == --* ]] && options+=("$name")
        if [[ $value && $previous == "$name" ]]; then
          _stream_recon_value "$value" "${text#"${text%%[^ ]*}"}"
          return
        fi
      done
    elif [[ ! $argument_value && $line =~ $argument ]]; then
      argument_value=${BASH_REMATCH[2]} argument_text=${BASH_REMATCH[6]}
    fi
  done

  if [[ $current == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "${options[*]}" -- "$current")
  elif [[ $argument_value ]]; then
    _stream_recon_value "$argument_value" "$argument_text"
  fi
}

complete -F _stream_recon_complete "${BASH_SOURCE[0]##*/}"
