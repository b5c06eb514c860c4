source agent.soar
watch 5
run 4
print s1 -d 3
