source agent.soar
run 1
run 5 -g
print -s
run 1
run -p
init-soar
run 1
run -o 2 -g
run -p 1
init-soar
run 1
run -g
run 1
run 2 -g
run 1
