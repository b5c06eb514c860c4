soar max-goal-depth 23
source agent.soar
watch 5
run 6
print -d 2 s1
print --stack
