source agent.soar
run 6
watch 5
wm add s1 ^alarm 7.5
run 1
run 3
wm add s1 ^beta red
run 3
