#!/bin/sh
# SPDX-License-Identifier: BSD-2-Clause
# Grades a world of your own by what its checks catch: sh grade.sh FOLDER
#
# The world needs more than `soarbox new` made: a second agent, an obstacle, a [[check]]. All checks must hold, none of them
# for agents without rules. Then each rule is left out, one at a time, and the checks are to notice: at least half of the
# rules of each file. SOARBOX=/path/to/soarbox takes another soarbox than the installed one.
soarbox=${SOARBOX:-soarbox}
world=${1:?"name the folder of your world: sh grade.sh FOLDER"}
[ -f "$world/scenario.toml" ] || { echo "$world: there is no scenario.toml"; exit 2; }
command -v "$soarbox" >/dev/null || { echo "there is no $soarbox; name it: SOARBOX=/path/to/soarbox sh grade.sh FOLDER"; exit 2; }
broken=$(mktemp -d) || exit 2
trap 'rm -rf "$broken"' EXIT
passed=yes
fail() { echo "no   $1"; passed=no; }

# Counts the tables of a kind in the scenario.
count() { grep -c "^\[\[$1\]\]" "$world/scenario.toml"; }
# Runs the world's checks with two seeds; the exit code is 1 if one fails.
checks() { "$soarbox" test "$@" --seeds 1..2 --no-keep >"$broken/told" 2>&1; }

if "$soarbox" check "$world" >"$broken/told" 2>&1; then echo "yes  soarbox check finds nothing"; else cat "$broken/told"; fail "soarbox check finds something"; fi
[ "$(count agent)" -ge 2 ] && echo "yes  a second agent" || fail "there is one agent: add an [[agent]] with rules of its own"
[ "$(count obstacle)" -ge 2 ] && echo "yes  an obstacle" || fail "there is one obstacle, that of the starter: add an [[obstacle]]"
[ "$(count check)" -ge 3 ] && echo "yes  a check" || fail "there are $(count check) checks, those of the starter: add a [[check]]"
if checks "$world"; then echo "yes  all checks hold"; else cat "$broken/told"; fail "a check fails"; fi
[ $passed = yes ] || { echo "not passed"; exit 1; }
if checks "$world" --empty; then fail "all checks hold for agents without rules as well: they test nothing"; else echo "yes  a check fails for agents without rules"; fi

# Leaves out each rule of each file in turn.
for file in "$world"/*.soar; do
  name=$(basename "$file")
  rules=0 caught=0
  for rule in $(sed -n 's/^sp {\([^ ]*\).*/\1/p' "$file"); do
    rm -rf "$broken/world" && cp -r "$world" "$broken/world"
    awk -v rule="$rule" '$1 == "sp" { out = $2 == "{" rule } !out { print } /^}/ { out = 0 }' "$file" >"$broken/world/$name"
    rules=$((rules + 1))
    if checks "$broken/world"; then echo "     $name without $rule: nobody notices"; else caught=$((caught + 1)); echo "     $name without $rule: caught"; fi
  done
  [ $((2 * caught)) -ge $rules ] && echo "yes  $name: $caught of $rules" || fail "$name: $caught of $rules; what does a rule do that nobody misses, and which check would notice?"
done
[ $passed = yes ] && echo "passed" || { echo "not passed"; exit 1; }
