# SPDX-License-Identifier: BSD-2-Clause
# Completion for bash. The candidates come from the command itself (soarbox complete).
# Needs the package bash-completion, which loads this file.

_soarbox() {
  local cur words cword program line behind="" files="" extensions="" cut=""
  _get_comp_words_by_ref -n =: cur words cword || return
  program=${words[0]/#\~/$HOME}
  COMPREPLY=()
  while IFS= read -r line; do
    case $line in
      :files*) files=yes extensions=${line#:files} ;;
      :folders) files=folders ;;
      :behind\ *) behind=${line#:behind } ;;
      :open) compopt -o nospace ;;
      *) COMPREPLY+=("${line%%$'\t'*}") ;;
    esac
  done < <("$program" complete "${words[@]:1:cword}" 2>/dev/null)
  # If a word contains = or :, bash replaces only the part after the last of them.
  cut=${cur%"${cur##*[=:]}"}
  [ -z "$cut" ] || COMPREPLY=("${COMPREPLY[@]#"$cut"}")
  cur=${cur#"$behind"}
  case $files in
    folders) _filedir -d ;;
    yes)
      extensions=${extensions// ./|}
      if [ -n "$extensions" ]; then _filedir "@(${extensions#|})"; else _filedir; fi
      ;;
  esac
}
complete -F _soarbox soarbox
