source agent.soar
trace 5
run 3
preferences s1 found --names
print --justifications
