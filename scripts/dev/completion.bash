# Completion of scallop in bash. To use it: eval "$(scallop --completion bash)", in ~/.bashrc for every shell.
# Commands and options are those that --help prints when they are completed; all else is completed as the name of a file.
_scallop() { # PROGRAM WORD
  local line names='' name='^  (-*[A-Za-z][-A-Za-z0-9_]*)' program=${1/#\~/$HOME} command=${COMP_WORDS[1]}
  COMPREPLY=()
  if [[ $COMP_CWORD -eq 1 || $command == help || $command == -* ]]; then
    [[ $COMP_CWORD -le 2 ]] || return 0
    command=''
  elif [[ $2 != -* ]]; then
    return 0
  fi
  while IFS= read -r line; do
    [[ ! $line =~ $name ]] || names+=" ${BASH_REMATCH[1]}"
  done < <("$program" --help $command 2>/dev/null)
  while IFS= read -r line; do
    COMPREPLY+=("$line")
  done < <(compgen -W "$names" -- "$2")
}
complete -o bashdefault -o default -F _scallop scallop
