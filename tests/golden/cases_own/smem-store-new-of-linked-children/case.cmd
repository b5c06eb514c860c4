source agent.soar
trace 0
run 9
smem --add {(@6 ^next @8)}
run 13
print @
