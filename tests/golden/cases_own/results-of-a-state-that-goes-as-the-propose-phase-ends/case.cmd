source agent.soar
decide indifferent-selection --first
watch 5
run 1
run 1
run 1
run 1
run 1
print s1
