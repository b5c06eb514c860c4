source agent.soar
source -v agent.soar
print
run 1
print s1
