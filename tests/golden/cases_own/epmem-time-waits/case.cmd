source agent.soar
watch 5
run 3
print s1 -d 2
