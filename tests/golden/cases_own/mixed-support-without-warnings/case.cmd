soar max-goal-depth 23
source agent.soar
watch 5
run 2
preferences s1 went
preferences s1 seen
init-soar
output warnings off
run 2
preferences s1 went
preferences s1 seen
output warnings on
init-soar
run 2
preferences s1 went
