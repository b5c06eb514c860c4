source agent.soar
trace 1
chunk always
run 12
print --chunks --full
print s1
