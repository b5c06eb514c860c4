source agent.soar
smem --enable
trace 3
run 5
trace 0
print @
