source agent.soar
watch 1
run 3
print -d 5 e1
