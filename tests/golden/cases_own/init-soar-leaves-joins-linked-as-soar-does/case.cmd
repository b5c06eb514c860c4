source agent.soar
watch 1
run 2
init-soar
run 2
init-soar
run -p 4
init-soar
run 3
init-soar
run -e 3
