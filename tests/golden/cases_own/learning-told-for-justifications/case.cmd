soar max-goal-depth 2
source agent.soar
watch 1
trace --learning 2
run 3
print --justifications
trace --learning 1
init-soar
run 2
init-soar
watch 5
trace --learning 2
run 2
chunk max-dupes 1
init-soar
watch 1
trace --learning 1
run 2
