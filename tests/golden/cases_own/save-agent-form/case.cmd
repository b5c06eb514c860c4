source agent.soar
soar max-goal-depth 7
chunk max-chunks 8
soar wait-snc on
save agent copy.soar
excise -a
source copy.soar
print
print -f large
source copy.soar
