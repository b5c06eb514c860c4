source agent.soar
watch 5
run 4
