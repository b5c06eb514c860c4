source agent.soar
watch 0
run 5
print -d 5 e1
