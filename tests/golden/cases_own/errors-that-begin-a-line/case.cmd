source agent.soar
watch 1
run 1
run 1 -e
run 2
