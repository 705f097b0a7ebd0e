# Completion of scallop in bash. To use it: eval "$(scallop --completion bash)", in ~/.bashrc for every shell.
# Commands and options are those that --help prints when they are completed, values those that the option is refused without; all else is completed
# as the name of a file.
_scallop_values() { # PROGRAM COMMAND OPTION WORD: "it takes tsv, json or table" are values, and "it takes a finite number > 0" are none
  local said item values=''
  said=$("$1" "$2" "$3" '' --no-such-option 2>&1 >/dev/null) # of which one is wrong, so that nothing is done
  said=${said#*" it takes "}
  said=${said// or /, }
  while [[ $said ]]; do
    item=${said%%, *}
    [[ $said == *", "* ]] && said=${said#*, } || said=''
    [[ $item =~ ^[A-Za-z][-A-Za-z0-9_/]*(:.*)?$ ]] || return 0
    values+=" ${item%%:*}${BASH_REMATCH[1]:+:}" # constant:R: what follows is the user's
  done
  while IFS= read -r item; do
    COMPREPLY+=("$item")
    [[ $item != *: ]] || compopt -o nospace 2>/dev/null || :
  done < <(compgen -W "$values" -- "$4")
}
_scallop() { # PROGRAM WORD
  local line item items names='' section='' program=${1/#\~/$HOME} command=${COMP_WORDS[1]} at=$((COMP_CWORD - 1)) word=$2
  COMPREPLY=()
  if [[ $COMP_CWORD -ge 3 && ${COMP_WORDS[COMP_CWORD]} == = ]]; then # --gait=, which is three words with what follows
    word=''
  elif [[ $COMP_CWORD -ge 3 && (${COMP_WORDS[at]} == = || ${COMP_WORDS[at - 1]} == --map) ]]; then
    at=$((at - 1))
  fi
  if [[ $COMP_CWORD -ge 3 && ${COMP_WORDS[at]} == --?* && $word != -* ]]; then
    _scallop_values "$program" "$command" "${COMP_WORDS[at]}" "$word"
    return 0
  fi
  if [[ $COMP_CWORD -eq 1 || $command == help || $command == -* ]]; then
    [[ $COMP_CWORD -le 2 ]] || return 0
    command=''
  elif [[ $2 != -* ]]; then
    return 0
  fi
  while IFS= read -r line; do
    [[ $line != [A-Z]*: ]] || section=$line
    [[ $line == '  --'* || (! $command && $line == '  '[a-z]*) ]] || continue
    [[ $section != Topics: || $COMP_CWORD -eq 2 ]] || continue # topics are for `scallop help`
    line=${line#  }
    read -ra items <<<"${line%%  *}" # what stands in front of the text: "--m1 M, --m2 M", "steady"
    for item in "${items[@]}"; do
      [[ $line == --* && $item != --* ]] || names+=" ${item%,}"
    done
  done < <("$program" --help $command 2>/dev/null)
  while IFS= read -r line; do
    COMPREPLY+=("$line")
  done < <(compgen -W "$names" -- "$2")
}
complete -o bashdefault -o default -F _scallop scallop
