source agent.soar
soar stop-phase output
watch 5
run 3
wm add s1 ^beta red
run -e 2
run 2
