source agent.soar
trace 0
run 5
print @
run 3
print @
