source agent.soar
trace 1
chunk always
run 60
print --chunks --full
