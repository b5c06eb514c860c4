soar max-goal-depth 23
source agent.soar
watch 5
run 4
print -d 3 s1
print --stack
run 2
