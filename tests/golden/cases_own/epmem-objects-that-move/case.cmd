source agent.soar
trace 0
run 15
epmem --print 3
epmem --print 12
