soar max-goal-depth 23
source agent.soar
run 3
print -i s1
wm remove 16
print -i s1
print --stack
watch 4
run 2
print --stack
print s2
print -i s1
