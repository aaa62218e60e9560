# Bash completion of `ldm`; the program itself knows what may come next. Installed with the program where
# Debian's bash-completion finds it; without that: source experiments/shell/ldm.bash
_ldm() {
  # Bash takes = for the end of a word; `--set name=value` is one.
  local line=${COMP_LINE:0:COMP_POINT} words IFS=$' \t\n'
  read -r -a words <<< "$line"
  [[ $line == *[[:space:]] ]] && words+=("")
  IFS=$'\n'
  COMPREPLY=($("${words[0]}" complete "${words[@]:1}" 2>/dev/null))
  [[ ${#COMPREPLY[@]} == 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  local before=${words[-1]%"${words[-1]##*=}"}
  [[ -n $before ]] && COMPREPLY=("${COMPREPLY[@]#"$before"}")
  return 0
}
complete -o default -F _ldm ldm
