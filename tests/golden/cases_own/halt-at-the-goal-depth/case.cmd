soar max-goal-depth 3
source agent.soar
run 4
run 1
soar max-goal-depth 10
init-soar
run 4
run 1
